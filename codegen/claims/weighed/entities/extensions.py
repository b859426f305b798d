"""Words for extensions and base fields in the reach of a field."""

from collections.abc import Iterator

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.rules import EXTENSION
from codegen.claims.statements.fields import said_of_fields
from codegen.claims.weighed.comparison import traits
from codegen.claims.weighed.entities.statement import Statement, piece
from codegen.claims.weighed.pairs import field_at
from codegen.load.prose import PassageKind
from codegen.pattern import pattern

_OLD = r"(?:an? |the |any )?mavlink ?(?:N|1)\b"
_WORD = pattern(
    r"\b(?P<extension>extensions?(?: fields?)?|(?:mavlink ?(?:N|2)|v2) only"
    rf"|(?:lost|cut|missing|absent|dropped|gone|empty|invisible|not (?:sent|carried|seen|there))"
    rf" (?:on|over|in|with|for|by) {_OLD})"
    r"|\b(?P<base>base(?: field| part| payload)?s?|no extensions?|not an extension"
    r"|(?:part of the )?original (?:message|definition|fields?)"
    rf"|{_OLD} (?:and|or) (?:mavlink ?)?N|{_OLD} [a-z]+ (?:carr|see|show|get|has|have|receive|know)[a-z]*"
    rf"|(?:with|over|on|in) {_OLD}(?: [a-z]+)? (?:too|as well|also|alike))\b"
)
_OTHER = pattern(r"\b(?:without|with|file|before|after|behind|all|no|only|the other|rest|of the) $")


def of_extensions(reading: Reading, span: Span) -> Iterator[Statement]:
    """Yield what words for extensions would say of the fields of their sentence."""
    for found in _WORD.finditer(span.text):
        at = found.start()
        low, high = piece(span, at)
        says = found["extension"] is not None
        groups = [said for said in said_of_fields(span) if low <= said.start < high]
        before = [said for said in groups if said.start < at][-1:]
        behind = [said for said in groups if said.start > at][:1]
        for said in (*before, *behind):
            for name in said.names:
                one = field_at(reading, span, name)
                if one is None:
                    continue
                about, is_loose = one
                is_right = any(each.definition.is_extension == says for each in (about.field, *about.others))
                gap = span.text[min(at, said.end) : max(at, said.start)]
                text = f"{about.name} is {'a base field' if says else 'an extension'}"
                yield Statement(
                    "extension",
                    EXTENSION,
                    span,
                    name,
                    low,
                    high,
                    about.message.name,
                    about.field.name,
                    is_right,
                    text,
                    about.message.name,
                    traits(
                        says_extension=says,
                        name_behind=said.start > at,
                        loose=is_loose,
                        sure=about.is_sure,
                        names_between=any(letter in gap for letter in "FPM"),
                        several_names=len(said.names) > 1,
                        far=len(gap) > 40,
                        beside=len(gap) < 12,
                        full_stop=". " in gap,
                        comma="," in gap,
                        colon=":" in gap,
                        verb=" is " in gap or " are " in gap,
                        other_words=_OTHER.search(span.text, max(at - 14, 0), at),
                        row_=span.kind is PassageKind.ROW,
                        both=bool(before and behind),
                        by_version="mavlink" in found[0],
                    ),
                )
