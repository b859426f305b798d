"""Attributes of XHTML and HTML that change what a text says: by them words are struck, raised or hidden."""

import re
from collections.abc import Iterator, Mapping

from codegen.pattern import pattern

_PROPERTIES = (
    "color background background-color font font-family font-size font-weight font-style font-stretch font-kerning "
    "font-size-adjust line-height letter-spacing word-spacing text-align text-align-last text-justify text-indent "
    "text-decoration text-decoration-line text-decoration-color text-decoration-style text-decoration-thickness text- "
    "decoration-skip-ink text-underline-offset text-underline-position vertical-align white-space word-break word- "
    "wrap overflow-wrap hyphens orphans widows page-break-before page-break-after page-break-inside break-before "
    "break-after break-inside tab-stops outline border-collapse border-spacing cursor direction unicode-bidi display "
    "visibility text-transform font-variant width max-width min-width box-sizing"
)
_LOOKS = frozenset(_PROPERTIES.split())
"""Properties that leave the words as they are, some of them with the values below alone."""
_EDGES = pattern(r"(?:margin|padding|border|outline)(?:-[a-z-]+)?|mso-(?!hide$)[a-z-]+")
_SAYS_OTHERWISE: tuple[tuple[str, str], ...] = (
    (r"text-decoration(-line)?", r"(?!.*(line-through|blink|inherit)).*"),
    (r"vertical-align", r"baseline|middle|auto|initial|unset|0(px|pt|em|%)?"),
    (r"white-space", r"normal|nowrap|pre-wrap|pre-line|break-spaces|initial|unset"),
    (r"font|font-size", r"(?!(.*\s)?(0+(\.0*)?|\.0+)(px|pt|em|rem|ex|%|/|\s|$)).*"),
    (r"color", r"(?!white|transparent|#f{3,4}$|#f{6}(f{2})?$|rgba?\(\s*255\s*,\s*255\s*,\s*255\s*[,)]).*"),
    (r"direction", r"ltr|initial|unset"),
    (r"unicode-bidi", r"normal|initial|unset"),
    (r"display", r"inline|initial|unset"),
    (r"visibility", r"visible|initial|unset"),
    (r"text-transform", r"none|initial|unset"),
    (r"font-variant", r"normal|none|initial|unset"),
    (r"width|max-width", r"(?!(0+(\.0*)?|\.0+)(px|pt|em|rem|%|$)).*"),
    (r"text-indent|margin(-left|-top)?|letter-spacing|word-spacing", r"(?!.*-\s*\d{3}).*"),
)
_CLASS = pattern(
    r"(?i)strike|struck|through|delet|remov|obsolet|super|\bsup\b|sub(?:script)?(?![a-z])|^su[bp]$|hidden|hide|invisible"
)
_ATTRIBUTE = pattern(r"""([a-zA-Z:-]+)(?:\s*=\s*(?:"([^"]*)"|'([^']*)'|([^\s"'>]+)))?""")


def said_otherwise(attributes: Mapping[str, str]) -> str | None:
    """Return the attribute of an element by which its text says something else than without it; None without one."""
    return next(_changing(attributes), None)


def attributes_of(tag: str) -> dict[str, str]:
    """Return the attributes of a tag of HTML as it is written, by names in small letters."""
    found = _ATTRIBUTE.finditer(tag.partition(" ")[2])
    return {each[1].lower(): next((text for text in each.groups()[1:] if text is not None), "") for each in found}


def _changing(attributes: Mapping[str, str]) -> Iterator[str]:
    for name, value in attributes.items():
        if name == "style":
            for declared in re.sub(r"/\*.*?\*/", "", value, flags=re.DOTALL).split(";"):
                if declared.strip() and not _is_look(declared):
                    yield f"style {' '.join(declared.split())!r}"
        elif name == "class":
            yield from (f"class {word!r}" for word in value.split() if _CLASS.search(word))
        elif name == "hidden" or (name == "dir" and value.strip().lower() == "rtl"):
            yield f"{name} {value!r}"


def _is_look(declared: str) -> bool:
    """Return whether a declaration of a style leaves what a text says."""
    name, colon, value = declared.lower().partition(":")
    name, value = name.strip(), value.replace("!important", "").strip()
    if not colon or "\\" in declared or not (name in _LOOKS or _EDGES.fullmatch(name)):
        return False
    return all(re.fullmatch(harmless, value) for names, harmless in _SAYS_OTHERWISE if re.fullmatch(names, name))
