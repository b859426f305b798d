"""The number of the first value on a page, in a message that is sent in pages."""

from collections.abc import Iterator

from codegen.answers.kind import KindOfAnswer
from codegen.answers.limits import counts
from codegen.answers.pages import BAD_PAGES
from codegen.answers.scope import Scope
from codegen.frozen import dataclass
from codegen.model.answers.account import Aspect, Origins, Trait, Words
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Known, Value
from codegen.model.answers.step import Step
from codegen.model.code.payload_code import PayloadCode
from codegen.model.spec.population import FieldAnswer


@dataclass(frozen=True, slots=True)
class PageAnswer(KindOfAnswer):
    """The number of the first value on a page of ``size`` values."""

    covers: Elements
    size: int

    @classmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """``page: true``."""
        return written.page is not None

    @classmethod
    def bind(cls, covers: Elements, scope: Scope) -> "PageAnswer | None":
        """The number, in one integer that can count to the last page."""
        place, pages = covers.written.at("page"), scope.pages
        if pages is None:
            if scope.population.pages is None:
                scope.report.add(BAD_PAGES, place, "the message has no pages", "pages: component.quantity")
            return None
        field = covers.field
        firsts = range(0, pages.count * pages.size, pages.size)
        if not counts(covers, firsts):
            message = f"{field.name} cannot carry the number {firsts[-1]}, the first of the last page"
            if counts(covers, range(firsts[-1], firsts[-1] + 1)):
                message = f"{field.name} cannot carry the numbers of pages, {firsts[0]} to {firsts[-1]}"
            scope.report.add(
                BAD_PAGES, place, message, hint="take a wider integer field for it, or make the list shorter: elements"
            )
            return None
        return cls(covers, pages.size)

    def values(self, known: Known, instance: int, page: int) -> tuple[Value, ...]:
        """The values on the pages before."""
        return (page * self.size,)

    def statements(self, code: PayloadCode) -> list[str]:
        """The page times its size."""
        words = f"# {self.covers.label}: number of the first value on the page ({self.covers.citation})"
        return [words, *code.store(self.covers, f"page * {self.size}")]

    def words(self) -> Words:
        """Return what it counts, and in which steps."""
        return Words("number of the first value", f"{self.size} on a page")

    def way(self, origins: Origins) -> Iterator[Step]:
        """The program counts the pages."""
        words = self.words()
        yield Step("program", words.source, (words.conversion,), (str(self.covers.citation),))

    def traits(self, position: int) -> Iterator[Trait]:
        """Yield what it counts, and in which steps."""
        yield Trait("source", f"number of the first value of a page of {self.size}", Aspect.SOURCE)
