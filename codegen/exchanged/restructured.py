"""reStructuredText, in which sphinx-needs has contents, as Markdown: plain paragraphs with emphasis and code."""

import re

from codegen.diagnostics import Report
from codegen.exchanged.stated import UNREADABLE_TEXT, Formatted
from codegen.exchanged.xhtml import written
from codegen.source import Place

_BLOCK = re.compile(
    r"^\s*(?:\.\. |[-*+•] |\d+[.)] |#\. |\+[-=]|[=\-~^\"#*+]{4,}\s*$|:[\w-]+:(?:\s|$)|\||>>> )|::\s*$", re.MULTILINE
)
_ROLE = re.compile(r":[\w.:+-]+:`|`[^`]*`__?|(?<!`)`(?!`)[^`]+`(?!`)|\w+__?(?=\s|$)|\|[^|\s][^|]*\|_?|\[[\w#*]+\]_")
_INLINE = re.compile(r"\\(.)|``([^`]+)``|\*\*([^*\s](?:[^*]*[^*\s\\])?)\*\*|\*([^*\s](?:[^*]*[^*\s\\])?)\*", re.S)


def formatted_content(content: str, place: Place, report: Report) -> Formatted | None:
    """A content; None, after a finding, where it has more than prose: directives, lists, roles."""
    bare = re.sub(r"\\.", "", content)
    found = _BLOCK.search(content) or _ROLE.search(bare)
    if found is not None:
        shown = " ".join(found[0].split())
        report.add(UNREADABLE_TEXT, place, f"its content has {shown!r}, which is no prose", "put it into words there")
        return None
    markdown, plain, at = [], [], 0
    for each in _INLINE.finditer(content):
        before = content[at : each.start()]
        escaped, code, strong, emphasis = each.groups()
        text = next(part for part in (escaped, code, strong, emphasis) if part is not None)
        text = "" if escaped and escaped.isspace() else text
        mark = "`" if code else "**" if strong else "*" if emphasis else ""
        markdown.append(f"{before}{mark}{text}{mark}")
        plain.append(f"{before}{text}")
        at = each.end()
    rest = content[at:]
    return written(" ".join("".join([*markdown, rest]).split()), " ".join("".join([*plain, rest]).split()))
