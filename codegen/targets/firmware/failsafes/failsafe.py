"""View of failsafe.py: one class for all failsafes, with what these need, and the tables and texts of each."""

from collections.abc import Iterable, Sequence

from codegen.frozen import dataclass
from codegen.model.failsafe import Failsafe, Sense
from codegen.model.program import Program
from codegen.model.system import System
from codegen.model.vehicle import Parameter
from codegen.targets.firmware.failsafes.arguments import Argument, Settled, arguments_of
from codegen.targets.firmware.failsafes.condition import (
    after_lines,
    follow_lines,
    guarded,
    inverted,
    limit_lines,
    of_parameter,
    row_constants,
)
from codegen.targets.firmware.failsafes.table import (
    Columns,
    condition_rows,
    inverted_rows,
    table_constant,
    table_lines,
)
from codegen.targets.firmware.failsafes.text import shows, text_lines
from codegen.targets.firmware.failsafes.watching import (
    armed_constant,
    bare,
    flags,
    watching_lines,
    when_disabled,
    when_off,
    when_off_to_arm,
    while_watching,
)
from codegen.targets.firmware.words import Layout
from codegen.targets.imports import LINE_LENGTH, either_import
from codegen.targets.naming import failsafe_function, quoted

_SAID = ("title", "level")
"""The arguments of the functions that make texts, beside the component."""
_TO_TELL = "rows[_WORST] != self._told or self._told_ms is not None"
"""The condition under which a text about the health of the watched quantity may be due."""


@dataclass(frozen=True, slots=True)
class FailsafeView:
    """One failsafe: its ``tables``, the lines of the function with its ``text``, and of the one that makes it.

    ``has_arming``: the vehicle is not armed while it speaks against that.
    """

    name: str
    attribute: str
    component: str | None
    is_measured: bool
    has_arming: bool
    variable: str
    watched: str
    citation: str
    tables: tuple[str, ...]
    text: tuple[str, ...]
    made: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class FailsafesView:
    """All of them, and what their class has to know for them: expressions and statements as they are printed.

    ``has_...`` says that one of them needs it at least.
    """

    failsafes: tuple[FailsafeView, ...]
    imports: tuple[str, ...]
    columns: tuple[str, ...]
    constants: tuple[str, ...]
    init: str
    kept: tuple[str, ...]
    level_words: str
    is_off: str
    is_off_to_arm: str
    watching: str
    flags: str
    is_watching: tuple[str, ...]
    is_over: str
    is_unknown: str
    last_problem: str
    limit: tuple[str, ...]
    follow: tuple[str, ...]
    row_constants: tuple[str, ...]
    words: str
    level: str
    level_of_due: str
    after: tuple[str, ...]
    is_inverted: str
    milder: str
    worse: str
    has_pairs: bool
    text: str
    set_level: str
    is_to_tell: str
    disabled: str
    head: str
    health_every_ms: str
    worst: str
    names: str
    inverted: str
    action: tuple[str, ...]
    before: tuple[str, ...]
    aging: str
    has_values: bool
    can_arm: bool
    has_unknown: bool
    has_silence: bool
    has_floor: bool
    has_slack: bool
    has_recovery: bool
    has_level: bool
    has_health: bool
    has_inverted: bool
    shows: bool


def failsafe_views(system: System, program: Program, layout: Layout) -> FailsafesView | None:
    """Return what the module needs; None where there is no failsafe."""
    failsafes = program.failsafes
    if not failsafes:
        return None
    given = [arguments_of(failsafe, layout) for failsafe in failsafes]
    found = Settled.of(given)
    conditions = [condition for failsafe in failsafes for condition in failsafe.conditions]
    has_values = any(condition.quantity for condition in conditions)
    has_silence = not all(condition.quantity for condition in conditions)
    looked_at = [*conditions, *(condition for failsafe in failsafes for condition in failsafe.to_arm)]
    has_unknown = any(condition.sense is Sense.UNKNOWN for condition in looked_at)
    rows = [row for one in failsafes for at in range(one.instances) for row in condition_rows(one, layout, at)]
    columns = Columns.of(rows)
    pair = _only_pair(failsafes)
    can_arm = program.spec.arming is not None
    looks = ["holding", "watch"] if can_arm else ["watch"]
    has_recovery = found.has("is_latched")
    follow = tuple(follow_lines(columns, has_silence=has_silence, has_unknown=has_unknown))
    limit = tuple(limit_lines(columns)) if columns.values("LIMIT") else ()
    after = tuple(after_lines(columns))
    level, level_of_due = columns("LEVEL"), columns("LEVEL", "due")
    is_inverted = f"{pair[2]} if {inverted(columns)} else None" if pair else inverted(columns)
    milder = of_parameter(columns, f"self._conditions[{pair[0]}]" if pair else "milder")
    worse = of_parameter(columns, f"self._conditions[{pair[1]}]" if pair else "worse")
    compared = (is_inverted, milder, worse) if found.has("inverted") else ()
    watching = while_watching(found)
    levels = {len(one.levels) for one in failsafes}
    worst = f"len({found('names')})" if len(levels) > 1 else str(levels.pop())
    return FailsafesView(
        failsafes=tuple(
            _failsafe(
                failsafe,
                one,
                found,
                columns,
                layout,
                is_measured=program.looks_with_readings(failsafe),
                has_pairs=not pair,
            )
            for failsafe, one in zip(failsafes, given, strict=True)
        ),
        imports=either_import("scan", looks, machine_code=system.spec.project.machine_code),
        columns=tuple(columns.constants([*follow, *limit, *after, level, level_of_due, *compared])),
        constants=(
            *armed_constant(found, layout),
            *found.constants,
        ),
        init=_def_lines(["self", "vehicle", "component", "title", "conditions", *found.parameters]),
        kept=tuple(_kept(found, has_silence=has_silence)),
        level_words=_level_words(found),
        is_off=when_off(found),
        is_off_to_arm=when_off_to_arm(found),
        watching="self._is_watching()" if " " in watching else watching,
        flags=flags("self._is_watching()" if " " in watching else watching, has_silence=has_silence),
        is_watching=tuple(watching_lines(found)) if " " in watching else (),
        is_over="(due[_LEVEL] if due else OK) < self.level"
        + ("" if found.is_same("is_latched") else " and not self._is_latched"),
        is_unknown=guarded(
            found.only_some("watched_at"),
            found("watched_at"),
            f"self._words[{found('watched_at')}] == _UNKNOWN",
        ),
        last_problem="self._mixed" if found.has("inverted") else "None",
        limit=limit,
        follow=follow,
        row_constants=tuple(row_constants(follow)),
        words='array("i", [0]) if component is None else component.words' if has_silence else "component.words",
        level=level,
        level_of_due=level_of_due,
        after=after,
        is_inverted=is_inverted,
        milder=milder,
        worse=worse,
        has_pairs=not pair,
        text=found("text"),
        set_level=_set_level(found),
        is_to_tell=f"{found('health_at')} is not None and ({_TO_TELL})" if found.only_some("health_at") else _TO_TELL,
        disabled=bare(when_disabled(found)),
        head=_head(found, worst),
        health_every_ms=found("health_every_ms"),
        worst=worst,
        names=found("names"),
        inverted=found("inverted"),
        action=_action(failsafes),
        before=(("self._forget()",) if found.has("aging") else ()) + _listening(found),
        aging=found("aging") if found.has("aging") else "",
        has_values=has_values,
        can_arm=can_arm,
        has_unknown=has_unknown,
        has_silence=has_silence,
        has_floor=any(failsafe.believed_above is not None for failsafe in failsafes),
        has_slack=columns.values("SLACK") - {"0"} != set(),
        has_recovery=has_recovery,
        has_level=found.has("level_at"),
        has_health=found.has("health_at"),
        has_inverted=found.has("inverted"),
        shows=any(shows(failsafe) for failsafe in failsafes),
    )


def _only_pair(failsafes: Sequence[Failsafe]) -> tuple[int, int, str] | None:
    """The pair of thresholds that every failsafe has, and no other; None where they differ."""
    pairs = {tuple(inverted_rows(failsafe)) for failsafe in failsafes}
    rows = next(iter(pairs))
    return rows[0] if len(pairs) == 1 and len(rows) == 1 else None


def _failsafe(
    failsafe: Failsafe,
    given: tuple[Argument, ...],
    found: Settled,
    columns: Columns,
    layout: Layout,
    *,
    is_measured: bool,
    has_pairs: bool,
) -> FailsafeView:
    component = failsafe.component
    variable = "_nothing" if component is None else component.name
    variable += "_" if variable in _SAID else ""
    return FailsafeView(
        name=failsafe.name,
        attribute=failsafe_function(failsafe.name),
        component=component.name if component else None,
        is_measured=is_measured,
        has_arming=failsafe.can_arm and failsafe.spec.arming,
        variable=variable,
        watched=f"{failsafe.watched} of each" if failsafe.instances > 1 else failsafe.watched,
        citation=str(failsafe.citation),
        tables=tuple(_tables(failsafe, columns, layout, has_pairs=has_pairs)),
        text=tuple(text_lines(failsafe, variable)),
        made=tuple(_made(failsafe, given, found)),
    )


def _tables(failsafe: Failsafe, columns: Columns, layout: Layout, *, has_pairs: bool) -> Iterable[str]:
    constant = table_constant(failsafe)
    levels = [f"{level.name} ({level.citation or failsafe.citation})" for level in failsafe.levels]
    yield f"# {failsafe.watched}: {', '.join(levels)}"
    instances = range(failsafe.instances)
    rows = [[columns.printed(row) for row in condition_rows(failsafe, layout, at)] for at in instances]
    yield from table_lines(constant, rows)
    if has_pairs and inverted_rows(failsafe):
        pairs = [f"({first}, {second}, {words})" for first, second, words in inverted_rows(failsafe)]
        yield from table_lines(f"{constant}_INVERTED", [pairs], is_shared=True)


def _made(failsafe: Failsafe, given: tuple[Argument, ...], found: Settled) -> Iterable[str]:
    """The body of the function that makes it, or one for each instance."""
    constant, several = table_constant(failsafe), failsafe.instances > 1
    each = "[instance]" if several else "[0]"
    title = failsafe.title.replace("{number}", "{instance + 1}" if several else "1")
    state = f"vehicle.state.{failsafe.component.name}" if failsafe.component else "None"
    arguments = [
        "vehicle",
        f"{state}[instance]" if several else state,
        f'f"{title}"' if several and "{" in title else quoted(title),
        f"{constant}{each}",
        *found.arguments(given),
    ]
    yield "return ["
    yield "    Failsafe("
    yield from (f"        {argument}," for argument in arguments)
    yield "    )"
    if several:
        yield f"    for instance in range({failsafe.instances})"
    yield "]"


def _kept(found: Settled, *, has_silence: bool) -> Iterable[str]:
    """The statements of __init__ behind ``self._``."""
    if not found.is_same("is_always"):
        yield "vehicle_words = vehicle.state.vehicle.words"
    yield from (f"{name} = {name}" for name in found.kept)
    if has_silence:
        yield from ("was_heard = False", "is_silent = False", "heard_ms = [None] * len(vehicle.connections)")


def _def_lines(parameters: Sequence[str]) -> str:
    """The beginning of __init__, as the formatter prints it."""
    line = f"    def __init__({', '.join(parameters)}):"
    if len(line) <= LINE_LENGTH:
        return line
    inside = f"        {', '.join(parameters)}"
    if len(inside) > LINE_LENGTH:
        inside = "\n".join(f"        {parameter}," for parameter in parameters)
    return f"    def __init__(\n{inside}\n    ):"


def _level_words(found: Settled) -> str:
    if not found.has("is_latched"):
        return "it stays until the next start and only rises"
    return "it stays while anything of it holds" + ("" if found.is_same("is_latched") else ", or is latched")


def _head(found: Settled, worst: str) -> str:
    """Return what the rows of conditions begin with, as scan_plain has it, in a line or one for each word."""

    def place(name: str) -> str:
        if not found.has(name):
            return "_NOT"
        return f"_NOT if {found(name)} is None else {found(name)}" if found.only_some(name) else found(name)

    untimed = found("timed_from") if found.has("timed_from") else "0"
    words = ["len(conditions)", untimed, "OK", "_NOT", "OK", "now_ms", place("watched_at"), worst, place("health_at")]
    line = f"        head = ({', '.join(words)})"
    return (
        line
        if len(line) <= LINE_LENGTH
        else "\n".join(["        head = (", *(f"            {word}," for word in words), "        )"])
    )


def _set_level(found: Settled) -> str:
    place = found("level_at")
    stored = f"self._words[{place}] = level"
    return f"if {place} is not None:\n            {stored}" if found.only_some("level_at") else stored


def _action(failsafes: Sequence[Failsafe]) -> tuple[str, ...]:
    """The statements that return the action of the level that was reached."""
    chosen = [isinstance(level.action, Parameter) for failsafe in failsafes for level in failsafe.levels]
    if all(chosen):
        return ("return getattr(self._parameters, self._reached[_ACTION]) if self.level else 0",)
    if not any(chosen):
        return ("return self._reached[_ACTION] if self.level else 0",)
    return (
        "action = self._reached[_ACTION] if self.level else 0",
        "return getattr(self._parameters, action) if isinstance(action, str) else action",
    )


def _listening(found: Settled) -> tuple[str, ...]:
    if not found.has("listens"):
        return ()
    return ("self._listen()",) if found.is_same("listens") else ("if self._listens:", "    self._listen()")
