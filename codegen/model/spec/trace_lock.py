"""``trace.lock.yaml``: the texts of the criteria for which the links were reviewed."""

from collections.abc import Mapping

from codegen.frozen import dataclass
from codegen.model.spec.described import Verbatim, described
from codegen.source import Written


@dataclass(frozen=True, slots=True, kw_only=True)
class ReviewedLinkSpec(Written):
    """One link from a criterion that was looked at by itself."""

    text: Verbatim = described("Fingerprint of the text that it was looked at with, 12 hex digits.")
    reason: str = described("What was looked at, or why the link still holds.")
    by: str | None = described("Who looked, where a project wants to know.", default=None)


@dataclass(frozen=True, slots=True, kw_only=True)
class ReviewedSpec(Written):
    """One criterion whose rows, tests and dependent criteria were looked at."""

    text: Verbatim = described("Fingerprint of the text with which all of its links were reviewed, 12 hex digits.")
    reason: str = described("What was looked at, or why the links still hold.")
    by: str | None = described("Who looked, where a project wants to know.", default=None)
    links: Mapping[str, ReviewedLinkSpec] = described(
        "Links that were looked at one by one since, by name, such as parameter SR0_EXTRA1: while one is left, text is "
        "that of before.",
        default_factory=dict,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class TraceLockSpec(Written):
    """``trace.lock.yaml``: written by ``codegen trace accept``, one line for each criterion."""

    criteria: Mapping[str, ReviewedSpec] = described("The criteria by name, such as FR-00068.3.", default_factory=dict)
