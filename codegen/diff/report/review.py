"""Everything that a report of a comparison says, whatever its format."""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from enum import StrEnum

from codegen.diagnostics import Diagnostic, Report, Severity, shortened_list
from codegen.diff.change import Area
from codegen.diff.following import with_following
from codegen.diff.report.excerpt import difference
from codegen.diff.report.grouping import Group, consequence, counted, grouped, notice_text
from codegen.diff.system.bandwidth import Bandwidth
from codegen.diff.system.system import Comparison
from codegen.findings.shortened import shortened
from codegen.frozen import dataclass
from codegen.source import Place

MOST_TESTS = 3


class FailOn(StrEnum):
    """The condition under which a comparison fails, beside areas and single rules."""

    NEVER = "never"
    ANY = "any"
    BREAKING = "breaking"
    SILENT = "silent"
    PERSON = "person"


@dataclass(frozen=True, slots=True)
class Review:
    """A comparison of ``base`` and ``head`` (as people call them), its changes grouped, the gravest first.

    ``faults`` are the errors of either side by its name: what they concern may be missing. ``notes`` say more of that
    kind; ``elsewhere`` counts changes of the dialect that do not concern the project, ``off`` those switched off.
    """

    base: str
    head: str
    groups: tuple[Group, ...]
    bandwidth: tuple[tuple[str, Bandwidth], ...]
    elsewhere: int
    notes: tuple[str, ...] = ()
    faults: tuple[tuple[str, Diagnostic], ...] = ()
    off: int = 0

    @property
    def is_empty(self) -> bool:
        """Return whether there is nothing to say: nothing changed, and both sides could be read."""
        return not self.groups and not self.faults and not self.off

    @property
    def counting(self) -> tuple[Group, ...]:
        """The groups that are not waived."""
        return tuple(group for group in self.groups if group.waived is None)

    @property
    def head_line(self) -> str:
        """Return how much changed, and how bad it is, as far as the sides can be read."""
        nothing = "nothing changed but what is switched off" if self.off else "nothing changed"
        known = counted(self.groups) if self.groups else nothing
        return f"{known}; {self.fault_line}" if self.faults else known

    @property
    def fault_line(self) -> str:
        """``work tree has 2 errors, and what they concern may be missing``; empty without any."""
        counts = Counter(label for label, _ in self.faults)
        told = [f"{label} has {'an error' if count == 1 else f'{count} errors'}" for label, count in counts.items()]
        whose = "it concerns" if len(self.faults) == 1 else "they concern"
        return f"{' and '.join(told)}, and what {whose} may be missing" if told else ""

    def of_area(self, area: Area) -> tuple[Group, ...]:
        """The groups of one area."""
        return tuple(group for group in self.groups if group.first.rule.area is area)


def review(
    base: str,
    head: str,
    comparison: Comparison,
    notes: Sequence[str] = (),
    faults: Iterable[tuple[str, Diagnostic]] = (),
) -> Review:
    """The review of a comparison, nothing of it waived yet."""
    groups = tuple(with_following(grouped(comparison.changes), comparison.carried))
    return Review(
        base, head, groups, comparison.bandwidth, len(comparison.elsewhere), tuple(notes), tuple(dict.fromkeys(faults))
    )


def with_waived(found: Review, judged: Sequence[Diagnostic]) -> Review:
    """The review with what ``judged``, its findings after waivers were applied, have as waived."""
    waived = {(finding.rule.id, finding.fingerprint): finding.waived for finding in judged}
    groups = (_with_waiver(group, waived.get((group.first.rule.id, group.fingerprint))) for group in found.groups)
    return replace(found, groups=tuple(groups))


def _with_waiver(group: Group, waived: str | None) -> Group:
    """The group as waived, with what follows from it."""
    following = tuple(replace(each, waived=waived) for each in group.following)
    return replace(group, waived=waived, following=following)


def fails(found: Review, fail_on: Sequence[str]) -> bool:
    """Return whether something that counts is of a kind that ``fail_on`` names: FailOn, an area, or the id of a rule.

    What somebody set to be an error fails whatever is named, except ``never``.
    """
    for group in found.counting:
        if group.severity is Severity.ERROR and FailOn.NEVER.value not in fail_on:
            return True
        rules = {each.first.rule for each in (group, *group.following)}
        kinds = {FailOn.ANY.value, *(rule.area.value for rule in rules), *(rule.id for rule in rules)}
        if not group.is_lowered:
            kinds.update(_grave_kinds(group))
        if kinds.intersection(fail_on):
            return True
    return False


def _grave_kinds(group: Group) -> Iterator[str]:
    """The kinds by which a group fails unless somebody set it to be no error."""
    change = group.first
    if change.is_breaking or change.is_lost:
        yield FailOn.BREAKING.value
    if change.is_silent:
        yield FailOn.SILENT.value
    if change.doubt:
        yield FailOn.PERSON.value


def fault_findings(found: Review) -> Report:
    """Return the errors of either side as findings of the comparison: of each kind as many as tell what is wrong."""
    return shortened(
        replace(fault, message=f"{label} cannot be compared as a whole: {fault.message}")
        for label, fault in found.faults
    )


def as_finding(group: Group) -> Diagnostic:
    """A group as a finding: for terminals, annotations, SARIF and waivers."""
    change = group.first
    said = [what_changed(group), change.effect, notice_text(change), consequence(change)]
    if group.severity is not None:
        said.append(f"set to {group.severity}: {group.reason}")
    related: list[tuple[Place, str]] = []
    if change.has_moved and change.was_at is not None:
        related.append((change.was_at, "before"))
    related += [(other.place, other.subject) for other in group.changes[1:6] if other.place != change.place]
    related += [(other.first.place, following_text(other)) for other in group.following]
    return Diagnostic(
        place=change.place,
        rule=replace(change.rule, severity=severity(group)),
        message="; ".join(word for word in said if word),
        hint=reach_text(group) or None,
        related=tuple(related),
        fingerprint=group.fingerprint,
        waived=group.waived,
    )


def following_text(group: Group) -> str:
    """``follows: population-conversion-changed: BATTERY_STATUS.temperature: ...``."""
    return f"follows: {group.first.rule.id}: {what_changed(group)}"


def severity(group: Group) -> Severity:
    """An error if somebody breaks or a person has to judge, or a requirement loses something; or what somebody set."""
    change = group.first
    if group.severity is not None:
        return group.severity
    return Severity.ERROR if change.is_breaking or change.doubt or change.is_lost else Severity.WARNING


def what_changed(group: Group) -> str:
    """``BATTERY_STATUS.temperature: cdegC -> degC``."""
    old, new = difference(group.first.old, group.first.new)
    if old is None:
        return f"{group.subject}: now {new}" if new else group.subject
    return f"{group.subject}: {old} -> {new}" if new is not None else f"{group.subject}: no longer {old}"


def reach_text(group: Group) -> str:
    """``reaches FR-00068.3; firmware/telemetry.py: build_battery_status; 4 tests in ...``; empty without any."""
    reach = group.reach
    told = [shortened_list(reach.requirements, 6), shortened_list(reach.symbols, 4), tests_text(reach.tests)]
    words = [word for word in told if word]
    return f"reaches {'; '.join(words)}" if words else ""


def off_text(count: int) -> str:
    """A sentence about changes that a severity of the project switches off."""
    return f"{count} {'change is' if count == 1 else 'changes are'} switched off."


def elsewhere_text(count: int) -> str:
    """A sentence about changes that are only counted."""
    words = "change of the dialect concerns" if count == 1 else "changes of the dialect concern"
    return f"{count} further {words} nothing that this project sends or receives."


def tests_text(tests: Sequence[str]) -> str:
    """The tests by name if they are few, else how many of which files."""
    if len(tests) <= MOST_TESTS:
        return ", ".join(tests)
    files = sorted({test.partition("::")[0] for test in tests})
    return f"{len(tests)} tests in {shortened_list(files, MOST_TESTS)}"
