"""The year from which a field counts its time: "seconds since 1970" of one that counts from 2019."""

from collections.abc import Iterator

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import DENIED, MISTAKEN, PAST, REPLACED, words
from codegen.claims.rules import UNIT, as_sure
from codegen.claims.statements.fields import number, said_of_fields
from codegen.claims.statements.subjects import about
from codegen.diagnostics import Diagnostic
from codegen.model.dialect.dialect import WireField
from codegen.pattern import pattern

_SINCE = pattern(r"\b(?:since|from|after) (?:the )?(?:[a-z]+ ){0,3}(?:N[ /.-]*(?:[a-z]+ )?)?(?P<year>N)")
_YEAR = pattern(r"\b(?:19|20)\d\d\b")
_NOT = words(DENIED, REPLACED, PAST, MISTAKEN)


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every year from which a field is said to count, where its description names another one."""
    for said in said_of_fields(span):
        found = _SINCE.search(span.text, said.end, said.until)
        if found is None or _NOT.search(span.text, said.end, found.end()):
            continue
        dates = [(at, term) for at, term in span.sentence.within(*found.span(), "N") if _YEAR.fullmatch(term.written)]
        one = about(reading, span, said.names[-1]) if dates else None
        if one is None or not _years(one.field):
            continue
        at, term = dates[0]
        if all(number(term) not in _years(field) for field in (one.field, *one.others)):
            text = f"{one.name} counts from {_years(one.field)[0]}, not {term.written}"
            yield reading.found(as_sure(UNIT, is_sure=False), span.place(at), f"{one.name} from {term.written}", text)


def _years(field: WireField) -> list[int]:
    return [int(found[0]) for found in _YEAR.finditer(field.definition.description)]
