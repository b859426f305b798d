"""Claims about the place of fields in their message: extension or not, offset, order; and about their enum."""

import re
from collections.abc import Iterator, Sequence
from difflib import get_close_matches

from codegen.claims.parts.span import Span, head_of
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import COMPARED, DENIED, MISTAKEN, OWN, PAST, REPLACED, words
from codegen.claims.rules import ENUM_OF, EXTENSION, OFFSET, as_sure
from codegen.claims.statements.fields import Said, each_about, made_of, number, said_of_fields
from codegen.claims.statements.subjects import about
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.pattern import pattern

_NAMES = r"(?P<names>[FP](?:(?:,? and |,? or |, ?| ?/ ?| ?& ?)[FP]){0,20})"
_GROUP = pattern(_NAMES)
_KIND = pattern(
    r"\b(?:extensions?|extension fields?)\b(?! of (?!M)| [FP]\b)"
    r"|\b(?:base fields?|the base|base payload)\b|\bno extensions?\b"
    r"|\bthe (?:later|last|new) additions?\b|\bthe (?:later|newer) fields\b"
    r"|\bthe (?:original|initial) (?:message|fields|definition|payload|part)\b",
    needs="addition|base|extension|initial|original|later|newer",
)
_AND_REST = pattern(
    r"^,? (?:and|with) (?:all )?(?:the )?(?:following|next|later|others|rest|ones behind|ones after|that follow)\b"
    r"(?: it)?"
)
_ORIGINAL = ("base", "original", "initial")
_VERBS = frozenset((
    "it", "belongs", "they", "note",
    "is", "are", "both", "all", "count", "counts", "were", "was", "came", "come", "comes", "later", "belong",
    "belongs", "among", "to", "in", "as", "sits", "sit", "lives", "live", "part",
))  # fmt: skip
_IDLE = _VERBS | frozenset((
    "field", "fields", "an", "a", "the", "only", "of", "really", "one", "fact", "added", "of", "M", "T", "U", "N",
    "type", "part", "which", "that", "following", "one", "well", "ones", "others", "here",
    "mavlink", "v", "normal", "regular", "ordinary", "plain", "too", "also", "just", "not", "no",
))  # fmt: skip
_LIST = pattern(
    rf"(?P<kind>extensions?(?: fields?)?|base fields?)(?: of M)?(?: are|:| is| \u2013| -"
    rf"|,){{1,4}}(?: the)?(?: fields?)? {_NAMES}(?! (?:is|are|has|have|belongs?|counts?|was|were)\b)",
    needs="base field|extension",
)
_OFFSET = pattern(
    r"(?:(?:at|from|has|is|begins? at|starts? at|sits at|lies at|stands at|comes at|is at|found at|,|\(|:|//|/\*"
    r"|#|\*|\|)\s?)+(?:the )?"
    r"(?:(?:byte )?offset(?: of| is|:| =)?|bytes?(?: number)?|position|index) ?(?P<number>N)(?!\s?(?:bytes"
    r"|,? ?(?:to|\.\.|-) ?N))",
    needs="byte|index|offset|position",
)
_AT = pattern(r"@ ?(?P<number>N)")
_ENUM = pattern(r"[^.;EC]{0,60}?(?P<enum>[EC])(?![\w*])")
_ENUM_IDLE = frozenset((
    "is", "are", "an", "a", "from", "of", "use", "uses", "the", "enum", "type", "taken", "see", "value", "values",
    "entry", "in", "one", "hold", "holds", "has", "contains", "as", "by", "bitmask", "bits", "flags", "list", "code",
    "codes", "those", "T", "M", "take", "takes", "be", "shall", "must", "decoded", "encoded", "coded", "enumeration",
    "entries", "with", "its", "listed", "defined", "comes", "come", "given", "number", "field",
    "according", "to", "follow", "follows",
))  # fmt: skip
_NOT = words(DENIED[:2], REPLACED, PAST[:1], MISTAKEN[:1], OWN[:1], COMPARED[1:2])


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every such statement of a part."""
    yield from _extensions(reading, span)
    yield from _placed(reading, span) if span.kind is PassageKind.ROW else ()
    for said in said_of_fields(span):
        yield from _offset(reading, said)
        yield from _enum(reading, said)


_PLACED = pattern(r"(?P<name>[FP]) ?\((?P<number>N)\)")
_OFFSETS = pattern(r"\boffsets?\b", re.IGNORECASE)


def _placed(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "lat (8), lon (12)" below a heading with the word offset."""
    for found in _PLACED.finditer(span.text) if any(_OFFSETS.search(head) for head in span.heads) else ():
        at = found.start("number")
        one, value = about(reading, span, found.start("name")), number(span.sentence.term(at))
        if one is not None and _OFFSETS.search(head_of(span, at)) and one.is_wrong(lambda field: field.offset == value):  # noqa: B023
            written = span.sentence.term(at).written
            words = f"{one.name} begins at byte {one.field.offset}, not {written}"
            yield reading.found(as_sure(OFFSET, is_sure=one.is_sure), span.place(at), f"{one.name} at {written}", words)


def _extensions(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "`a` and `b` are extensions", "`c` belongs to the base fields", "the extensions are `a` and `b`"."""
    text = span.text
    if span.is_code and not span.is_comment and _ADDS_TO_TYPE.match(text):
        return
    for found in _LIST.finditer(text):
        if text[found.end("kind")] == "," and _SAID_BEFORE.search(text, 0, found.start()):
            continue
        names = [at for at in range(*found.span("names")) if text[at] in "FP"]
        yield from _kinds(reading, span, names, is_extension=found["kind"].startswith("ext"))
    for found in _THESE.finditer(text):
        value = number(span.sentence.term(found.start("many")))
        named = [at for at, _ in span.sentence.within(0, found.start(), "FP")]
        if value is not None and 1 < value <= len(named):
            is_extension = found["kind"].startswith("ext")
            yield from _kinds(reading, span, named[-int(value) :], found.start("kind"), is_extension=is_extension)
    for said in said_of_fields(span) if span.kind in (PassageKind.ITEM, PassageKind.ROW) else ():
        clause = _CLAUSE.search(text, said.end, said.until)
        if clause is not None:
            is_extension = clause["kind"].startswith("ext")
            yield from _kinds(reading, span, said.names, clause.start("kind"), is_extension=is_extension)
    for found in _NAMED_SO.finditer(text):
        yield from _kinds(reading, span, [found.start("name")], is_extension=found["kind"].startswith("ext"))
    for found in _MARKED.finditer(text) if span.kind is not PassageKind.ROW else ():
        yield from _kinds(reading, span, [found.start()], is_extension=found["kind"].startswith("ext"))
    yield from _grouped(reading, span) if _KIND.search(text) else ()


_SAID_BEFORE = pattern(
    r"[FP][^.;:]{0,40}\b(?:is|are|remains?|stays?|counts? as|belongs? to)(?: [a-z]+){0,2} $",
    needs="is|are|remain|stay|count|belong",
)
"""Before a kind of fields that is said of those before it, where a comma follows: "`a` is a base field, `c` ..."."""
_ADDS_TO_TYPE = pattern(r"\s*(?:public |private |internal |fileprivate )?extension [A-Z]")
"""A line of Swift or Dart that adds to a type."""


def _grouped(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "`a` and `b` are extensions", "`c` belongs to the base fields", "`d` tells it; it is an extension"."""
    text = span.text
    for found in _GROUP.finditer(text):
        kind = _KIND.search(text, found.end(), found.end() + _NEAR)
        gap = _AND_REST.sub("", text[found.end() : kind.start()]) if kind is not None else ""
        resumed = _RESUMED.search(gap)
        gap = gap[resumed.start("what") - 2 :] if resumed is not None else gap
        words = pattern(r"[A-Za-z]+").findall(gap)
        is_tied = bool(_VERBS & set(words)) or pattern(r"[:(,|\u2013]").search(gap) is not None
        if (
            kind is None
            or not is_tied
            or not made_of(gap, _IDLE)
            or text[max(found.start() - 2, 0) : found.start()].endswith("M.")
        ):
            continue
        names = [at for at in range(*found.span()) if text[at] in "FP"]
        is_of_all = {"are", "both", "all", "belong", "were", "come"} & set(words) or kind[0].endswith("s")
        is_of_all = is_of_all or ("as" in words and "an" not in words)  # "`a`, and `b` as an extension"
        is_extension = not kind[0].startswith("no") and not any(word in kind[0] for word in _ORIGINAL)
        is_extension = not is_extension if {"not", "no"} & set(words) else is_extension
        if _IT.match(gap) or (resumed is not None and resumed["what"] in ("it", "the field")):
            names = [at for at, _ in span.sentence.within(span.bounds(found.start())[0], found.end(), "FP")]
            if any(_is_so(reading, span, at, is_extension=is_extension) for at in names[:-1]):
                continue  # which of several names "it" is, only the sense tells
        far = kind.start() if span.place(kind.start()).line != span.place(names[-1]).line else None
        yield from _kinds(reading, span, names if is_of_all else names[-1:], far, is_extension=is_extension)


_RESUMED = pattern(
    r"[;:,] ?(?:and |but |so )?(?P<what>it|the field|both|they|these|all(?: of them| three| four)?) (?=is|are"
    r"|belongs?|c[ao]me|counts?)",
)
"""A clause that goes on about the names before it."""
_IT = pattern(r"[.;!] it\b")


def _is_so(reading: Reading, span: Span, offset: int, *, is_extension: bool) -> bool:
    """Return whether a field is an extension, where that is said, or a base field."""
    one = about(reading, span, offset)
    return one is not None and one.field.definition.is_extension == is_extension


_THESE = pattern(
    r"\b(?:these|those|all|the last) (?P<many>N)(?: fields)? are (?:all |also )?(?P<kind>extension|base)(?: field)?s?\b"
)
_CLAUSE = pattern(
    r"[,;:.|(\u2013]\s*(?:an? |also )?(?P<kind>extension|base)(?: field)?(?=\s*(?:[,;|)]|\.(?:\s|$)|$|\*/))",
    needs="base|extension",
)
"""A clause of an item or a cell that is nothing else."""
_NAMED_SO = pattern(
    r"\b(?P<kind>extension|base field)(?: field)? (?P<name>F)\b(?! of (?!M))",
    needs="base field|extension",
)
_MARKED = pattern(r"F ?[(\[](?:T,? |U,? )*(?P<kind>ext\.?|extension|base)(?: field)?[)\]]")
_NEAR = 90
"""Characters between names and what kind of fields they are."""


def _kinds(
    reading: Reading, span: Span, names: Sequence[int], kind_at: int | None = None, *, is_extension: bool
) -> Iterator[Diagnostic]:
    """Yield a finding for each named field that is no extension though called one, or the reverse."""
    low, high = span.bounds(names[0])
    if pattern(r"\bwithout\b|\bpropos|\bwould\b|\bshould\b|\bmake\b|\?").search(span.text[low:high]):
        return
    for offset in names:
        one = about(reading, span, offset)
        if one is not None and one.is_wrong(lambda field: field.definition.is_extension == is_extension):
            kind = "an extension" if one.field.definition.is_extension else "a base field"
            yield reading.found(
                as_sure(EXTENSION, is_sure=one.is_sure),
                span.place(offset if kind_at is None else kind_at),
                f"{one.name} {is_extension}",
                f"{one.name} is {kind}",
            )


_AND_THE = pattern(r"\band (?:then )?(?:the|its|all) [a-zFP]")
"""Another thing whose place follows: "`count` (1), and the data from byte 7"."""


def _offset(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    span, text = said.span, said.span.text
    found = _OFFSET.search(text, said.end, said.until) or _AT.search(text, said.end, said.until)
    if (
        found is None
        or len(said.names) > 1
        or _NOT.search(text[said.end : found.start()])
        or _AND_THE.search(text, said.end, found.start())
        or found.start() - said.end > 90
    ):
        return
    value = number(span.sentence.term(found.start("number")))
    one = about(reading, span, said.names[0])
    low, high = span.bounds(found.start())
    element = span.sentence.term(said.names[0]).written
    if one is None or value is None or "[" in element or re.search(r"\bframe\b|\bheader\b|\bbit\b", text[low:high]):
        return
    if one.is_wrong(lambda field: field.offset == value):
        written = span.sentence.term(found.start("number")).written
        words = f"{one.name} begins at byte {one.field.offset}, not {written}"
        yield reading.found(
            as_sure(OFFSET, is_sure=one.is_sure), span.place(found.start("number")), f"{one.name} at {written}", words
        )


def _enum(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """The enum that a field is said to have."""
    span, text = said.span, said.span.text
    found = _ENUM.match(text, said.end, said.until)
    if found is None or not made_of(_OF_THE.sub(" ", found[0][:-1]), _ENUM_IDLE):
        return
    offset = found.start("enum")
    written = span.sentence.term(offset).written
    for at, one in each_about(reading, said)[-1:]:
        own = one.field.definition.enum
        enums = [field.definition.enum for field in (one.field, *one.others)]
        if at not in said.names or own is None or written in enums:
            continue
        is_known = written in reading.enums
        if (
            not is_known
            and not get_close_matches(written, [own], n=1, cutoff=0.6)
            and written.split("_")[0] != own.split("_")[0]
        ):
            continue
        if not is_known and ("_" not in written or written in reading.messages):
            continue
        hint = None if is_known else f"there is no enum {written}"
        if own.startswith(f"{written}_") or (not is_known and _is_entry(reading, own, written)):
            continue
        words = f"{one.name} has the enum {own}, not {written}"
        yield reading.found(
            as_sure(ENUM_OF, is_sure=one.is_sure), span.place(offset), f"{one.name} {written}", words, hint
        )


_OF_THE = pattern(r" (?:of|in) (?:the|an?|this|that) [a-z]+ ")


def _is_entry(reading: Reading, enum: str, written: str) -> bool:
    """Return whether a name is, or nearly is, that of an entry: another rule reports it."""
    entries = [entry.name for entry in reading.enums[enum].entries] if enum in reading.enums else []
    return any(entry.endswith(written) for entry in entries) or bool(
        get_close_matches(written, entries, n=1, cutoff=0.75)
    )
