"""A text that only the running board knows: the number of its chip."""

from collections.abc import Iterator

from codegen.answers.constant import BAD_CONSTANT
from codegen.answers.kind import KindOfAnswer
from codegen.answers.scope import Scope
from codegen.frozen import dataclass
from codegen.model.answers.account import Aspect, Origins, Trait, Words
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Known, Value
from codegen.model.answers.step import Step
from codegen.model.code.payload_code import PayloadCode
from codegen.model.dialect.dialect import Kind
from codegen.model.spec.population import FieldAnswer
from codegen.model.vehicle import Component

UNIQUE_ID = "unique_id"
"""The word in a table for the number that the maker gave the board's chip, as a text in hex."""

MOCK_CHIP = bytes.fromhex("e6613852831b2c21")
"""The number of the mocked board's chip."""


@dataclass(frozen=True, slots=True)
class ChipAnswer(KindOfAnswer):
    """A text that the running board knows, cut to the field. ``source``: unique_id, the chip's number in hex."""

    covers: Elements
    source: str

    @classmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """``board: unique_id``."""
        return written.board == UNIQUE_ID

    @classmethod
    def bind(cls, covers: Elements, scope: Scope) -> "ChipAnswer | None":
        """The number of the chip, into a text."""
        if covers.field.type.kind is not Kind.CHAR:
            message = f"{covers.field.name} is a {covers.field.type.name}, and {UNIQUE_ID} a text"
            scope.report.add(
                BAD_CONSTANT,
                covers.written.at("board"),
                message,
                hint="answer a text field with it, and this one with a number or unknown",
            )
            return None
        return cls(covers, UNIQUE_ID)

    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """Return what the mocked board makes of it."""
        return (MOCK_CHIP.hex()[: self.covers.field.count],)

    def statements(self, code: PayloadCode) -> list[str]:
        """Return what the board was asked for at the start."""
        return [f"# {self.covers.label}: number of the chip ({self.covers.citation})", *code.chip(self.covers)]

    def words(self) -> Words:
        """Return the words for the source, the number of the chip, and for its form."""
        return Words("number of the chip", "in hex")

    def way(self, origins: Origins) -> Iterator[Step]:
        """The board tells it."""
        words = self.words()
        yield Step("program", words.source, (words.conversion,), (str(self.covers.citation),))

    def traits(self, position: int) -> Iterator[Trait]:
        """Yield the source: the text that is sent."""
        yield Trait("source", f"text {self.source}", Aspect.SOURCE)

    @property
    def is_chip_number(self) -> bool:
        """Return True: the text is the number of the chip."""
        return True

    def is_fact(self, component: Component) -> bool:
        """The board that sends it stays the same."""
        return True
