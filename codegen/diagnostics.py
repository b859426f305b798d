"""Findings of the stages about their input: values with a rule, a place and a hint, never exceptions."""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from difflib import get_close_matches
from enum import StrEnum

from codegen.frozen import dataclass
from codegen.source import Place


class Severity(StrEnum):
    """The severity of a finding: an error stops the build, a warning does not, and an information asks for nothing."""

    ERROR = "error"
    WARNING = "warning"
    INFO = "info"


@dataclass(frozen=True, slots=True)
class Rule:
    """One kind of finding: its id as printed, its severity, and the text that ``codegen explain ID`` shows.

    ``unreadable`` marks the rules whose finding means that the input could not be read at all
    (exit code 2 instead of 1). ``remedy`` says what to do about any finding of the rule, for those without a hint of
    their own.
    """

    id: str
    explanation: str
    severity: Severity = Severity.ERROR
    unreadable: bool = False
    remedy: str = ""

    @property
    def standing(self) -> str:
        """Return what kind of finding it makes, in a few words."""
        return str(self.severity)


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One finding at one place. ``related`` are further places that explain it, each with a short text.

    ``fingerprint`` (12 hex digits, see ``codegen.findings.fingerprint``) is what a waiver names; without one a finding
    cannot be waived. ``waived`` says who waived it, why and until when: then it counts neither as error nor as warning,
    but is still shown.
    """

    place: Place
    rule: Rule
    message: str
    hint: str | None = None
    related: tuple[tuple[Place, str], ...] = ()
    fingerprint: str | None = None
    waived: str | None = None

    @property
    def is_error(self) -> bool:
        """Return whether it stops a build, or makes a check fail."""
        return self.rule.severity is Severity.ERROR and self.waived is None

    @property
    def advice(self) -> str | None:
        """Return what to do about it: its hint, or else the remedy of its rule; None where neither says anything."""
        return self.hint or self.rule.remedy or None


MOST = 100
"""Findings of one rule that are shown; the others are counted."""

Hint = str | Callable[[], str | None] | None
"""A hint as text, or a function that finds it out where that takes long."""


class Report:
    """Collects the diagnostics of one run, so that all of them are shown and not only the first."""

    def __init__(self) -> None:
        self._diagnostics: list[Diagnostic] = []
        self._found_out: Counter[str] = Counter()

    def add(
        self,
        rule: Rule,
        place: Place,
        message: str,
        hint: Hint = None,
        related: Iterable[tuple[Place, str]] = (),
        fingerprint: str | None = None,
    ) -> None:
        """Record one finding; its hint is found out for as many of a rule as are shown."""
        if callable(hint):
            self._found_out[rule.id] += 1
            hint = hint() if self._found_out[rule.id] <= MOST else None
        self._diagnostics.append(Diagnostic(place, rule, message, hint, tuple(related), fingerprint))

    def extend(self, diagnostics: Iterable[Diagnostic]) -> None:
        """Record the findings of a rule."""
        self._diagnostics.extend(diagnostics)

    def __iter__(self) -> Iterator[Diagnostic]:
        """The findings without repetitions, ordered by place."""
        return iter(sorted(set(self._diagnostics), key=lambda found: (found.place, found.rule.id, found.message)))

    @property
    def count(self) -> int:
        """Return how many findings there are, repetitions included."""
        return len(self._diagnostics)

    @property
    def has_errors(self) -> bool:
        """Return whether anything was found that must stop the build."""
        return any(found.is_error for found in self._diagnostics)

    @property
    def exit_code(self) -> int:
        """0 without errors that count, 2 if an input could not be read, 1 for every other error."""
        errors = [found.rule for found in self._diagnostics if found.is_error]
        if not errors:
            return 0
        return 2 if any(rule.unreadable for rule in errors) else 1


def did_you_mean(written: str, candidates: Iterable[str]) -> str | None:
    """A hint that names the nearest candidates, or lists them where none is near (at most eight)."""
    names = sorted(set(candidates))
    near = get_close_matches(written, names, n=3, cutoff=0.6)
    if near:
        return f"did you mean {_listed(near)}?"
    if not names:
        return None
    return f"known: {shortened_list(names)}"


def shortened_list(names: Iterable[str], most: int = 8) -> str:
    """The names in one line, at most ``most`` of them, with the number of the others."""
    names = list(names)
    shown = names[:most]
    more = f" and {len(names) - len(shown)} more" if len(names) > len(shown) else ""
    return f"{', '.join(shown)}{more}"


def _listed(names: list[str]) -> str:
    return " or ".join(names)
