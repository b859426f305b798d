"""The places of a document that are about one parameter of a command: "param 2", a column of it, a row, "2: ..."."""

from collections.abc import Iterator, Mapping

from codegen.claims.parts.span import Span
from codegen.claims.parts.spans import spans
from codegen.claims.reading import Reading
from codegen.claims.statements.commands import commands_in
from codegen.claims.statements.fields import number
from codegen.claims.weighed.comparison import traits
from codegen.claims.weighed.entities.statement import piece
from codegen.frozen import dataclass
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import CommandParameter, EnumEntry
from codegen.once import once
from codegen.pattern import pattern

_PARAM = pattern(
    r"\bparam(?:eter)?s? ?(?:no\.? |number |#)?(?P<spaced>N)|\bparam(?P<joined>[1-7])\b|\bp(?P<short>[1-7])\b"
)
_HEAD = pattern(r"(?:param(?:eter)?|p)?[ _.#]*(?P<number>[1-7])\b")
"""The heading of a column of one parameter."""
_NUMBERS = pattern(r"(?:param(?:eter)?s?|#|no\.?|nr\.?|number|p)\b")
"""The heading of a column in which each row has the number of a parameter."""
_LISTED = pattern(r"(?:(?<=\| )|(?<=[.;,] )|^)N[:.)=] ")
_PARAMETERS = pattern(r"\bparam(?:eter)?s?\b")
_COLUMN = pattern(r"[^|]+")
_MOST = 7


@dataclass(frozen=True, slots=True)
class ParameterPlace:
    """A piece of a part, from ``start`` to ``end``, that tells of a parameter of a command; ``mark`` is its number."""

    command: EnumEntry
    parameter: CommandParameter
    mark: int
    start: int
    end: int
    traits: tuple[str, ...]


def parameter_places(reading: Reading, span: Span) -> Iterator[ParameterPlace]:
    """Yield the places of a part that are about a parameter of the command that it names, or that stands above."""
    commands = commands_of(reading)
    named = [
        (at, str(term.value)) for at, term in span.sentence.within(0, len(span.text), "V") if term.value in commands
    ]
    carried = "" if named else _above(reading).get(id(span), "")
    if not named and not carried:
        return
    marks = sorted({found[:3]: found for found in _marks(span)}.values())
    for index, (start, mark, value, end, how) in enumerate(marks):
        before = [name for at, name in named if at < start]
        name = before[-1] if before else named[0][1] if named else carried
        own = next((each for each in commands[name].parameters if each.number == str(value)), None)
        if own is None:
            continue
        following = marks[index + 1][0] if index + 1 < len(marks) else end
        found = traits(
            before=bool(before),
            several=len(marks) > 1,
            several_commands=len({each for _, each in named}) > 1,
            carried=bool(carried),
        )
        yield ParameterPlace(commands[name], own, mark, start, min(end, max(following, start)), (how, *found))


@once
def commands_of(reading: Reading) -> Mapping[str, EnumEntry]:
    """The commands of the dialect by name."""
    enum = reading.enums.get("MAV_CMD")
    return {entry.name: entry for entry in enum.entries} if enum is not None else {}


def commands_near(reading: Reading, span: Span) -> tuple[str, ...]:
    """Return the commands that a part names, or else the one that stands above it."""
    commands = commands_of(reading)
    named = (str(term.value) for _, term in span.sentence.within(0, len(span.text), "V"))
    own = tuple(dict.fromkeys(name for name in named if name in commands))
    above = _above(reading).get(id(span), "")
    return own or ((above,) if above else ())


@once
def enums_of_parameters(command: EnumEntry) -> tuple[tuple[str, str], ...]:
    """The parameters of a command that have an enum, by "param" and their number, with its name."""
    given = ((f"param{each.number}", dict(each.attributes).get("enum", "")) for each in command.parameters)
    return tuple((name, enum) for name, enum in given if enum)


@once
def _above(reading: Reading) -> dict[int, str]:
    """By the identity of each part the one command that its heading, the last part with a command, or all name.

    None for what stands below a command that the dialect does not have.
    """
    last: str | None = ""
    every = set[str]()
    found: dict[int, str | None] = {}
    for span in spans(reading):
        named = set(commands_in(reading, span))
        every |= named - {""}
        if named or span.kind is PassageKind.HEADING:
            last = None if "" in named else next(iter(named)) if len(named) == 1 else ""
        found[id(span)] = last
    only = next(iter(every)) if len(every) == 1 else ""
    return {part: "" if name is None else name or only for part, name in found.items()}


def _marks(span: Span) -> Iterator[tuple[int, int, int, int, str]]:
    """Yield where the words about a parameter begin, where its number stands, that number, and where they end."""
    text = span.text
    for found in _PARAM.finditer(text):
        value = (
            number(span.sentence.term(found.start("spaced")))
            if found["spaced"]
            else int(found["joined"] or found["short"])
        )
        _, high = piece(span, found.start())
        bar = text.find(" | ", found.end(), high)
        if value in range(1, _MOST + 1):
            yield found.end(), found.start(), int(value or 0), high if bar < 0 else bar, "numbered"
    if span.kind is PassageKind.ROW:
        yield from _columns(span)
    yield from _listed(span)


def _columns(span: Span) -> Iterator[tuple[int, int, int, int, str]]:
    """Yield the columns below the name of a parameter, and those of a row that begins with the number of one."""
    columns = [(found.start(), found.end()) for found in _COLUMN.finditer(span.text) if found[0].strip()]
    if len(span.heads) < len(columns):
        return
    for (start, end), head in zip(columns, span.heads, strict=False):
        found = _HEAD.fullmatch(head.strip().lower())
        if found is not None:
            yield start, start, int(found["number"]), end, "column"
    first = span.text[slice(*columns[0])].strip() if columns else ""
    if first == "N" and _NUMBERS.match(span.heads[0].strip().lower()):
        at = span.text.index("N", columns[0][0])
        value = number(span.sentence.term(at))
        if value in range(1, _MOST + 1):
            for start, end in columns[1:]:
                yield start, start, int(value or 0), end, "row of it"


def _listed(span: Span) -> Iterator[tuple[int, int, int, int, str]]:
    """Yield the pieces of "1: angle, deg. 2: deg/s": the numbers rise from one, and something says what they are."""
    found = [(each, number(span.sentence.term(each.start()))) for each in _LISTED.finditer(span.text)]
    head = " ".join(span.heads).lower()
    if not found or found[0][1] != 1 or not (_PARAMETERS.search(head) or _PARAMETERS.search(span.text)):
        return
    rising = [(each, index) for index, (each, value) in enumerate(found, 1) if value == index]
    for index, (each, value) in enumerate(rising):
        bar = span.text.find(" |", each.end())
        last = rising[index + 1][0].start() if index + 1 < len(rising) else len(span.text) if bar < 0 else bar
        yield each.end(), each.start(), value, last, "listed"
