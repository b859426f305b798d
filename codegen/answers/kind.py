"""The base of the kinds of answers: how a table's keys select a kind, and how an answer of that kind is bound."""

from abc import abstractmethod
from typing import ClassVar

from codegen.answers.scope import Scope
from codegen.diagnostics import Rule
from codegen.model.answers.answer import Answer, Elements
from codegen.model.spec.population import FieldAnswer

POINTLESS_KEY = Rule(
    "pointless-key",
    "split, min, max and rounding shape a value that is read at run time. Beside a constant, an enum entry, flags or "
    "unknown they would have no effect: remove them, or answer with state or parameter.",
    remedy="leave it out, or answer with state or parameter",
)


class KindOfAnswer(Answer):
    """Base of the kinds. ``SHAPED_BY`` are the keys beside the source that have an effect on it."""

    __slots__ = ()

    SHAPED_BY: ClassVar[frozenset[str]] = frozenset()

    @classmethod
    @abstractmethod
    def is_meant(cls, written: FieldAnswer, scope: Scope) -> bool:
        """Return whether an answer is of this kind, as it is written; of several kinds the first one counts."""

    @classmethod
    @abstractmethod
    def bind(cls, covers: Elements, scope: Scope) -> Answer | None:
        """The answer, bound to its source; None after a finding."""
