"""A text of the state, cut at a character to what its field holds."""

from collections.abc import Iterator

from codegen.answers.filling import comment
from codegen.answers.fitting import BAD_SOURCE, WITHHELD, no_sentinel
from codegen.answers.kind import KindOfAnswer
from codegen.answers.letters import carries_text, says_unknown
from codegen.answers.scope import Scope
from codegen.frozen import dataclass
from codegen.model.answers.account import Aspect, Origins, StateCase, Trait, Words
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Known, Value, kept_text
from codegen.model.answers.step import Step
from codegen.model.code.letters import NUL, cut
from codegen.model.code.payload_code import PayloadCode
from codegen.model.code.reading import Reading
from codegen.model.dialect.dialect import Dialect
from codegen.model.spec.population import FieldAnswer, Send
from codegen.model.vehicle import Component, Quantity, QuantityKind


@dataclass(frozen=True, slots=True)
class TextAnswer(KindOfAnswer):
    """A quantity that is a text, in a field of characters or of bytes. Unknown goes out as the empty text.

    Where the field has no sentinel for that, the source has a text at all times, or the answer ``withholds`` the
    message.
    """

    covers: Elements
    source: Quantity
    withholds: bool = False

    @classmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """``state: component.quantity``, where that is a text."""
        component, _, name = (written.state or "").partition(".")
        owner = scope.components.get(component)
        quantity = owner.quantities.get(name) if owner and written.each is None else None
        return quantity is not None and quantity.kind is QuantityKind.TEXT

    @classmethod
    def bind(cls, covers: Elements, scope: Scope) -> "TextAnswer | None":
        """The text, where the field as a whole takes one."""
        key, report = covers.written.at("state"), scope.report
        source = scope.quantity(covers.written.state or "", key)
        if source is None:
            return None
        if not carries_text(covers):
            hint = "a text goes into a field of characters or of bytes without a unit, as a whole"
            report.add(BAD_SOURCE, key, f"{source.path} is a text, {covers.label} is {covers.field.type.name}", hint)
            return None
        may_be_unknown = source.initial is None
        withholds = may_be_unknown and not says_unknown(covers) and scope.population.send is Send.WHILE_KNOWN
        if may_be_unknown and not says_unknown(covers) and not withholds:
            no_sentinel(covers, "state", source.path, report)
            return None
        return cls(covers, source, withholds)

    @property
    def size(self) -> int:
        """Bytes of the longest text that goes out."""
        return min(self.source.length, self.covers.count)

    @property
    def _bytes(self) -> str:
        return f"{self.size} byte{'s' if self.size > 1 else ''}"

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """The text."""
        return (self.source,)

    @property
    def carried(self) -> tuple[Quantity, ...]:
        """The same."""
        return (self.source,)

    @property
    def withheld_for(self) -> tuple[Quantity, ...]:
        """The text, where the field cannot say that it is unknown."""
        return self.quantities if self.withholds else ()

    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """Return what is left of the text."""
        return (cut(kept_text(self.source, known) or "", self.size),)

    def used_bytes(self, first: int, last: int) -> tuple[int, int]:
        """Return no byte for the empty text, and all for the longest."""
        return 0, self.size

    def statements(self, code: PayloadCode) -> list[str]:
        """Byte by byte up to the cut, then NULs."""
        covers, source = self.covers, self.source
        words = f"{source.path}, up to {self._bytes}" if self.size < source.length else source.path
        return [comment(covers, words), *code.letters(covers, source, forgotten=source.ages and not self.withholds)]

    def words(self) -> Words:
        """The path, and where it is cut."""
        conversion = f"in UTF-8, cut at a character to {self._bytes}"
        return Words(self.source.path, conversion, "")

    def way(self, origins: Origins) -> Iterator[Step]:
        """The source, and the cut."""
        yield from origins.steps(self.source)
        yield Step("text", self.words().conversion, ("NULs behind it",), (str(self.covers.citation),))
        if self.withholds:
            yield WITHHELD
        elif self.source.initial is None:
            yield Step("unknown", "the empty text", ("goes out while the text is not known",), ())

    def traits(self, position: int) -> Iterator[Trait]:
        """Source, cut, and what stands for unknown."""
        yield Trait("source", self.source.path, Aspect.SOURCE)
        yield Trait("conversion", self.words().conversion, Aspect.CONVERSION)
        unknown = "the empty text" if self.source.initial is None else ""
        yield Trait("unknown", WITHHELD.text if self.withholds else unknown, Aspect.UNKNOWN)

    def is_fact(self, component: Component) -> bool:
        """Unless it is a quantity of the component itself."""
        return self.source.component != component.name

    def readings(self, component: Component, dialect: Dialect) -> Iterator[Reading]:
        """The text."""
        source, field = self.source, self.covers.field
        if source.component == component.name:
            yield Reading(source.name, f'text(get("{field.name}"))', "", source.spec.doc, field.name, uses=("text",))

    @property
    def varies(self) -> bool:
        """Return True: it changes with its source."""
        return True

    def cases(self, plain: Known, instances: int, pages: int) -> Iterator[StateCase]:
        """Unknown, empty, full, too long by a byte, with a NUL, and each length of a character around each cut."""
        path = self.source.path
        for name, text in _texts(self.source.length, self.covers.count):
            yield StateCase(name, {path: text})


def _texts(kept: int, held: int) -> Iterator[tuple[str, str | None]]:
    """Names and texts; what is kept is cut first, and then what the field holds."""
    yield "unknown", None
    yield "empty", ""
    yield "nul", f"a{NUL}b"
    yield "all-wide", "€" * kept
    letters = "abcdefghijklmnopqrstuvwxyz" * 10
    for size in sorted({kept, min(kept, held)}):
        yield f"full-{size}", letters[:size]
        yield f"beyond-{size}", letters[: size + 1]
        for width, letter in ((2, "Ä"), (3, "€"), (4, "🚤")):
            for inside in range(min(size, width) + 1):
                yield f"{width}-bytes-{inside}-before-{size}", f"{letters[: size - inside]}{letter}xyz"
