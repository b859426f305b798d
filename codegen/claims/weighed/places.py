"""Numbers in the reach of a field that tell its place on the wire."""

from collections.abc import Iterator

from codegen.claims.parts.span import head_of
from codegen.claims.rules import OFFSET
from codegen.claims.weighed.comparison import Comparison, traits
from codegen.claims.weighed.pairs import Pair, whole_number
from codegen.load.prose import PassageKind
from codegen.pattern import pattern

_CUE = pattern(r"(?:\boffsets?|\bbytes?|\bposition|\bat|\bfrom|\bbegins|\[)[^.;N]{0,12}$|F \($|F at $")
_STRONG = pattern(r"\boffsets?\b|\bbytes? N|\bat byte|\bbegins at\b|\bstarts at\b")
_IN_BUFFER = pattern(
    r"(?:u8|u16|u32|uint\d+|int\d+|float\d*|get\w+|unpack_from|payload|buf\w*|\bp|\bb|data|msg)[^.;]{0,14}[\[(,] ?$"
)
_BEHIND = pattern(r" ?(?:bytes?|hz|times|elements|U|of the|[*/x])")


_MOST_BYTES = 255


def of_place(pair: Pair) -> Iterator[Comparison]:
    """Yield what a number says of the place of a field."""
    value, field = whole_number(pair.term), pair.one.field
    if value is None or not 0 <= value < _MOST_BYTES:
        return
    before = pair.span.source_text(max(pair.low, pair.at - 40), pair.at).lower()
    head = head_of(pair.span, pair.at).lower() if pair.span.kind is PassageKind.ROW else ""
    marked = pair.before(40)
    is_cued = _CUE.search(marked) or "offset" in head
    is_code = pair.span.is_code and not pair.span.is_comment and _IN_BUFFER.search(before)
    if not (is_cued or is_code) or (_BEHIND.match(pair.behind(10)) and not is_code):
        return
    offsets = [each.offset for each in pair.fields]
    named = {one.offset for one in pair.one.message.fields}
    found = traits(
        of_code=is_code,
        offset_word=_STRONG.search(pair.sentence),
        column_of_offsets="offset" in head,
        place_of_another=value in named,
        beyond=value >= pair.one.message.length,
        wire="wire" in pair.sentence,
        beside_name=pair.before(3).strip(" (") == "F",
        less_than_others=value < min(offsets),
    )
    text = f"{pair.one.name} is at offset {field.offset}, not {pair.term.written}"
    yield Comparison("place", OFFSET, value in offsets, text, found)
