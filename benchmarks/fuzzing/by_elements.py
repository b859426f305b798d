"""Faults of XML: attributes, entities, encodings, and elements that are missing, doubled, nested or thousands."""

import random
import re
from functools import lru_cache

from fuzzing.hostile import EVERYTHING, NAMES, NUMBERS, PATHS, TEXTS

_ATTRIBUTE = re.compile(r'([\w:]+)\s*=\s*"([^"]*)"')
_ELEMENT = re.compile(r"<(field|entry|param|description|version|include|dialect)\b[^>]*>(?:[^<]*</\1>)?")
_BLOCK = re.compile(r"<(message|enum)\b.*?</\1>", re.DOTALL)
_TEXT = re.compile(r">([^<>]+)<")
_TYPES = (
    *(
        "uint8_t",
        "int64_t",
        "float",
        "double",
        "char",
        "char[256]",
        "uint8_t[0]",
        "uint8_t[-1]",
        "uint64_t[40]",
        "uint8_t[999999999]",
    ),
    *(
        "uint8_t_mavlink_version",
        "uint8_t [4]",
        "uint8_t[4",
        "uint8_t[]",
        "array[4]",
        "int128_t",
        "void",
        "uint8_t[1][2]",
    ),
    *("uint8_t[\u0664]", "uint8_t[1e2]", "uint8_t[+4]", "uint8_t[ 4 ]", "uint8_t[04]", "FLOAT", "char[0x10]"),
)
_BOMB = '<!DOCTYPE m [<!ENTITY a "x"><!ENTITY b "&a;&a;&a;&a;"><!ENTITY c "&b;&b;&b;&b;"><!ENTITY e SYSTEM "file:///etc/passwd">]>'
_OUTER = ("mavlink", "messages", "enums", "message", "enum", "field", "entry")


def by_elements(data: bytes, lot: random.Random) -> bytes:
    """Return the file with one fault."""
    text = data.decode("utf-8", "replace")
    kinds = (
        _attribute,
        _attribute,
        _attribute,
        _typed,
        _attributes,
        _doubled,
        _doubled,
        _missing,
        _moved,
        _text,
        _many,
        _many,
    )
    changed = lot.choice((*kinds, _nested, _declared, _tag, _include))(text, lot)
    return changed if isinstance(changed, bytes) else changed.encode("utf-8", "surrogatepass")


@lru_cache(maxsize=50)
def _found(pattern: "re.Pattern[str]", text: str) -> tuple[tuple[int, int], ...]:
    return tuple(match.span() for match in pattern.finditer(text))


def _drawn(pattern: "re.Pattern[str]", text: str, lot: random.Random) -> tuple[int, int]:
    spans = _found(pattern, text)
    return lot.choice(spans) if spans else (0, 0)


def _attribute(text: str, lot: random.Random) -> str:
    """Put another value into an attribute."""
    start, end = _drawn(_ATTRIBUTE, text, lot)
    name = text[start:end].partition("=")[0]
    other = _drawn(_ATTRIBUTE, text, lot)
    value = lot.choice((lot.choice(NUMBERS), lot.choice(NAMES), lot.choice(EVERYTHING), _value_of(text[slice(*other)])))
    value = value.replace('"', "&quot;") if lot.random() < 0.9 else value
    return f'{text[:start]}{name}="{value.replace("<", "&lt;")}"{text[end:]}'


def _value_of(attribute: str) -> str:
    return attribute.partition("=")[2].strip().strip('"')


def _typed(text: str, lot: random.Random) -> str:
    spans = [match.span(1) for match in re.finditer(r'\btype="([^"]*)"', text)]
    if not spans:
        return _attribute(text, lot)
    start, end = lot.choice(spans)
    return text[:start] + lot.choice(_TYPES) + text[end:]


def _attributes(text: str, lot: random.Random) -> str:
    """Leave an attribute out, write it twice, or add one."""
    start, end = _drawn(_ATTRIBUTE, text, lot)
    here = text[start:end]
    known = (
        "units",
        "enum",
        "display",
        "invalid",
        "print_format",
        "multiplier",
        "default",
        "instance",
        "minValue",
        "maxValue",
        "bitmask",
        "name",
        "id",
        "value",
        "type",
        "increment",
        "xmlns",
        "xml:lang",
        "x:y",
    )
    added = f'{lot.choice(known)}="{lot.choice(NUMBERS if lot.random() < 0.5 else NAMES).replace(chr(34), "")}"'
    return text[:start] + lot.choice(("", f"{here} {here}", f"{here} {added}", added)) + text[end:]


def _doubled(text: str, lot: random.Random) -> str:
    start, end = _drawn(lot.choice((_ELEMENT, _BLOCK)), text, lot)
    here = text[start:end]
    at = lot.choice((end, _drawn(_ELEMENT, text, lot)[0]))
    return text[:at] + here + text[at:]


def _missing(text: str, lot: random.Random) -> str:
    start, end = _drawn(lot.choice((_ELEMENT, _BLOCK)), text, lot)
    return text[:start] + text[end:]


def _moved(text: str, lot: random.Random) -> str:
    first, second = sorted((_drawn(_ELEMENT, text, lot), _drawn(_ELEMENT, text, lot)))
    if first[1] > second[0]:
        return text
    return (
        text[: first[0]] + text[slice(*second)] + text[first[1] : second[0]] + text[slice(*first)] + text[second[1] :]
    )


def _text(text: str, lot: random.Random) -> str:
    start, end = _drawn(_TEXT, text, lot)
    new = lot.choice(
        (
            *TEXTS,
            *NUMBERS,
            "&e;",
            "&#0;",
            "&#x110000;",
            "&lt;b&gt;",
            "<![CDATA[<field/>]]>",
            "<!-- -- -->",
            "<?x y?>",
            "]]>",
            "&",
        )
    )
    return f"{text[:start]}>{new}<{text[end:]}"


def _many(text: str, lot: random.Random) -> str:
    """Write an element thousands of times: fields, entries of an enum, or messages."""
    spans = _found(lot.choice((_ELEMENT, _ELEMENT, _BLOCK)), text)
    if not spans:
        return text * 2
    start, end = lot.choice(spans)
    here = text[start:end]
    count = min(lot.choice((70, 300, 10_000)), 3_000_000 // max(1, len(here)))
    is_same = lot.random() < 0.3
    return text[:end] + "".join(here if is_same else _numbered(here, number) for number in range(count)) + text[end:]


def _numbered(element: str, number: int) -> str:
    element = re.sub(r'\bname="(\w*)"', rf'name="\g<1>_{number}"', element, count=1)
    return re.sub(r'\b(value|id)="[^"]*"', rf'\1="{100_000 + number}"', element, count=1)


def _nested(text: str, lot: random.Random) -> str:
    start, end = _drawn(lot.choice((_ELEMENT, _BLOCK)), text, lot)
    name, deep = lot.choice(_OUTER), lot.choice((1, 3, 200, 300, 20_000))
    return text[:start] + f"<{name}>" * deep + text[start:end] + f"</{name}>" * deep + text[end:]


def _declared(text: str, lot: random.Random) -> bytes:
    """Return the file with a document type, or in an encoding that is odd or is not the one that it says."""
    body = re.sub(r"^<\?xml[^>]*\?>", "", text)
    named = lot.choice(
        (
            "utf-8",
            "UTF-16",
            "utf-7",
            "cp037",
            "latin-1",
            "ISO-8859-15",
            "windows-1252",
            "rot13",
            "x" * 300,
            "idna",
            "hex",
            "utf_8_sig",
            "",
        )
    )
    kind = lot.randrange(4)
    if kind == 0:
        return (lot.choice(("", "\n", "<!-- x -->")) + _BOMB + body).encode("utf-8", "surrogatepass")
    written = f'<?xml version="{lot.choice(("1.0", "1.1", "2.0", ""))}" encoding="{named}"?>{body}'
    written = lot.choice(
        (written, written, " " + written, "<!DOCTYPE x>" + written, written.replace("?>", ' standalone="no"?>', 1))
    )
    if kind == 1:
        return written.encode("utf-8", "surrogatepass")
    try:
        return written.encode(
            lot.choice(("utf-16", "utf-16-be", "utf-32", "latin-1", "cp037", "utf-7", named)), "xmlcharrefreplace"
        )
    except (LookupError, UnicodeError, ValueError):
        return written.encode("utf-8", "replace")


def _tag(text: str, lot: random.Random) -> str:
    """Give a tag another name, of both ends or of one."""
    old, new = lot.choice(_OUTER), lot.choice((*_OUTER, "extensions", "deprecated", "wip", "x:y", "FIELD", "\u00e9"))
    if lot.random() < 0.5:
        return re.sub(rf"(</?){old}\b", rf"\g<1>{new}", text)
    return text.replace(f"<{old}", f"<{new}", 1)


def _include(text: str, lot: random.Random) -> str:
    name = lot.choice((*PATHS, "common.xml", "minimal.xml", "own.xml", "minimal.xml\n", "all.xml"))
    written = f"<include>{name.replace('&', '&amp;')}</include>" * lot.choice((1, 1, 2, 500))
    return re.sub(r"<mavlink>", lambda found: found[0] + written, text, count=1)
