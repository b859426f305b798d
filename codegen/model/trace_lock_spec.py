"""``trace.lock.yaml``: the texts of the criteria for which the links were reviewed."""

from collections.abc import Mapping

from codegen.frozen import dataclass
from codegen.model.described import Verbatim, described
from codegen.source import Written


@dataclass(frozen=True, slots=True, kw_only=True)
class ReviewedSpec(Written):
    """One criterion whose rows and tests were looked at."""

    text: Verbatim = described("Fingerprint of the text that was reviewed, 12 hex digits.")
    reason: str = described("What was looked at, or why the links still hold.")
    by: str | None = described("Who looked, where a project wants to know.", default=None)


@dataclass(frozen=True, slots=True, kw_only=True)
class TraceLockSpec(Written):
    """``trace.lock.yaml``: written by ``codegen trace accept``, one line for each criterion."""

    criteria: Mapping[str, ReviewedSpec] = described("The criteria by name, such as FR-00068.3.", default_factory=dict)
