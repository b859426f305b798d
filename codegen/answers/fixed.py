"""Values that are known at build time: an entry, a constant, a fact of the dialect, unknown."""

import struct
from collections.abc import Iterator

from codegen.answers.constant import fits, read_constant
from codegen.answers.fitting import NO_SENTINEL, field_enum
from codegen.answers.kind import KindOfAnswer
from codegen.answers.scope import Scope
from codegen.diagnostics import Report, Rule
from codegen.frozen import dataclass
from codegen.model.answers.account import Aspect, Origins, Trait, Words
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Known, Value, shown_value
from codegen.model.answers.step import Step
from codegen.model.code.letters import on_one_line
from codegen.model.code.payload_code import PayloadCode
from codegen.model.dialect.dialect import Kind, SentinelForm
from codegen.model.spec.population import FieldAnswer
from codegen.model.vehicle import Component

UNKNOWN_FACT = Rule(
    "unknown-fact",
    "A table names a fact that board.yaml, or the dialect, does not have.",
    remedy="state it in board.yaml: facts: {component: {name: value}}",
)


@dataclass(frozen=True, slots=True)
class FixedAnswer(KindOfAnswer):
    """Values known at build time, one per element (a char array has one ``str``), with the words for reviewers."""

    covers: Elements
    fixed: tuple[Value, ...]
    meaning: str
    is_unknown: bool = False

    @classmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """``enum``, ``constant``, ``dialect`` or ``unknown``."""
        stated = (written.enum, written.constant, written.dialect, written.unknown)
        return any(value is not None for value in stated)

    @classmethod
    def bind(cls, covers: Elements, scope: Scope) -> "FixedAnswer | None":
        """The values that the table states, or the dialect's sentinels."""
        written = covers.written
        if written.enum is not None:
            value = read_entry(covers, written.enum, "enum", scope)
            return None if value is None else repeated(covers, value, written.enum)
        if written.constant is not None:
            found = read_constant(covers, written.constant, "constant", scope.report)
            return None if found is None else repeated(covers, *found)
        if written.dialect is not None:
            return _version(covers, written.dialect, scope)
        return _unknown(covers, scope.report)

    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """The same ones always."""
        return self.fixed

    @property
    def constants(self) -> tuple[Value, ...]:
        """Return what is stated; nothing where that is unknown."""
        return () if self.is_unknown else self.fixed

    @property
    def always(self) -> tuple[Value, ...]:
        """The values."""
        return self.fixed

    def used_bytes(self, first: int, last: int) -> tuple[int, int]:
        """Up to the last byte that is not zero."""
        wire_type = self.covers.field.type
        if isinstance(self.fixed[0], str):
            packed = self.fixed[0].encode()
        else:
            packed = b"".join(struct.pack(f"<{wire_type.code}", value) for value in self.fixed)
        used = len(packed.rstrip(b"\0"))
        return used, used

    def statements(self, code: PayloadCode) -> list[str]:
        """The values; equal ones together."""
        covers = self.covers
        value = self.fixed[0]
        zero = ", 0" if value == 0 and str(self.meaning) != "0" else ""
        words = "text" if isinstance(value, str) and value else f"{self.meaning}{zero}"
        head = f"# {covers.label}: {words} ({covers.citation})"
        if isinstance(value, str):
            return [head, *code.text(covers, value)]
        if len(set(map(repr, self.fixed))) == 1:
            return [head, *code.fill(covers, value)]
        return [
            head,
            *(
                line
                for at, each in enumerate(self.fixed)
                if not isinstance(each, str)
                for line in code.store(covers, each, at)
            ),
        ]

    def words(self) -> Words:
        """Return what it means, and the values."""
        shown = list(dict.fromkeys(map(shown_value, self.fixed)))
        if len(shown) > 1:
            shown = [shown_value(value) for value in self.fixed]
        return Words("unknown" if self.is_unknown else self.meaning, f"= {', '.join(shown)}")

    def way(self, origins: Origins) -> Iterator[Step]:
        """The row of the table."""
        words, sentinel = self.words(), self.covers.sentinel
        own = (str(self.covers.citation),)
        if self.is_unknown:
            text = f"the dialect's {sentinel}" if sentinel else words.source
            why = "the table does not list this field" if self.covers.by_others else "nothing gives this field a value"
            yield Step("unknown", text, (why, words.conversion), own)
        else:
            yield Step("table", words.source, (words.conversion,), own)

    def traits(self, position: int) -> Iterator[Trait]:
        """The value, with its meaning where that says more."""
        value = self.fixed[position] if position < len(self.fixed) else self.fixed[-1]
        shown = _told(value)
        if self.is_unknown:
            yield Trait("source", "unknown", Aspect.SOURCE)
            yield Trait("unknown", shown, Aspect.UNKNOWN)
            return
        yield Trait("source", "constant", Aspect.SOURCE)
        text = shown if self.meaning in ("", shown) else f"{shown} ({self.meaning})"
        yield Trait("value", text, Aspect.CONSTANT)

    @property
    def entries(self) -> tuple[str, ...]:
        """The name of the entry, where it is one."""
        return (self.meaning,)

    def is_fact(self, component: Component) -> bool:
        """Return True: a constant of the table is a fact."""
        return True


def repeated(covers: Elements, value: Value, meaning: str) -> FixedAnswer:
    """The same value in every element; a text is one."""
    return FixedAnswer(covers, (value,) if isinstance(value, str) else (value,) * covers.count, meaning)


def read_entry(covers: Elements, name: str, key: str, scope: Scope) -> int | None:
    """The value of an entry of the field's enum, which the table names under ``key``."""
    enum = field_enum(covers, key, scope)
    value = scope.entry(enum, name, covers.written.at(key)) if enum else None
    return value if value is not None and fits(covers, value, key, name, scope.report) else None


def _told(value: Value) -> str:
    return f'"{on_one_line(value)}"' if isinstance(value, str) else shown_value(value)


def _version(covers: Elements, name: str, scope: Scope) -> FixedAnswer | None:
    """A fact of the dialect; so far its version, which fields of type uint8_t_mavlink_version carry."""
    if name != "version":
        message = f"the dialect has no fact {name}"
        scope.report.add(UNKNOWN_FACT, covers.written.at("dialect"), message, "known: version")
        return None
    return FixedAnswer(covers, (scope.dialect.version,), "version of the dialect")


def _among_others(covers: Elements) -> str:
    return ", and the table does not list it" if covers.by_others else ""


def _unknown(covers: Elements, report: Report) -> FixedAnswer | None:
    """The sentinel(s) of the dialect for every covered element."""
    field = covers.field
    sentinel = field.sentinel
    if sentinel is None or sentinel.values[covers.first] is None:
        report.add(
            NO_SENTINEL,
            covers.written.at("unknown"),
            f"{field.name} has no value that means unknown{_among_others(covers)}",
            "if its description names one, add it to the corrections file as 'invalid'",
            [(field.definition.place, f"{field.name} is declared here")],
        )
        return None
    if field.type.kind is Kind.CHAR:
        return FixedAnswer(covers, ("",), f"unknown ({sentinel.written})", is_unknown=True)
    if sentinel.form is SentinelForm.FIRST and covers.first == 0:
        values = (sentinel.values[0], *[0] * (covers.count - 1))
    else:
        values = sentinel.values[covers.first : covers.first + covers.count]
    known = [value for value in values if value is not None]
    if len(known) < covers.count:
        report.add(
            NO_SENTINEL,
            covers.written.at("unknown"),
            f"{covers.label} has no value that means unknown for each of these elements{_among_others(covers)}",
            f"the dialect says invalid={sentinel.written!r}",
            [(sentinel.place, "the sentinel is stated here")],
        )
        return None
    return FixedAnswer(covers, tuple(known), f"unknown ({sentinel.written})", is_unknown=True)
