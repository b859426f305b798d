"""Subjects of the failsafes and of their actions: whatever of them is another one, another deed is done, or none."""

from collections.abc import Iterable, Iterator

from codegen.diff.system import behaviour_rules as rules
from codegen.diff.system.subject import Fact, Subject, amount, citations, cited
from codegen.diff.system.trace_rules import CITATION, DOC
from codegen.model.failsafe import Condition, Failsafe, FailsafeLevel, Setting
from codegen.model.program import Program
from codegen.model.spec.program import ActionSpec
from codegen.model.vehicle import Parameter, Quantity

_ARMED = "whether the vehicle may be armed then"
_TOLD = "whether who is told of it is told there"


def failsafe_subject(failsafe: Failsafe) -> Subject:
    """A failsafe with its levels."""
    return Subject(
        name=f"failsafe {failsafe.name}",
        says=failsafe.watched,
        added=rules.FAILSAFE,
        removed=rules.FAILSAFE,
        place=failsafe.spec.place,
        facts=(*_facts(failsafe), *(fact for level in failsafe.levels for fact in _level(level, failsafe))),
        cited=cited(failsafe.citation, failsafe.aspects, *(level.citation for level in failsafe.levels)),
        row=failsafe.name,
        doubt=f"whether nothing is to watch {failsafe.watched} so any more",
    )


def _facts(failsafe: Failsafe) -> Iterator[Fact]:
    spec = failsafe.spec
    believed, shown = _steps(failsafe.believed_above, failsafe.quantity)
    looks = "armed" if spec.when.value == "armed" else "armed or not"
    stays = "until the next start" if spec.latch else "until nothing of it holds"
    enabled = failsafe.enabled_by.name if failsafe.enabled_by else ""
    health = failsafe.health.path if failsafe.health else ""
    level = failsafe.level.path if failsafe.level else ""
    every = amount(failsafe.health_every_ms, "ms")
    over = failsafe.over.written if failsafe.over else "never"
    to_arm = "; ".join(shown for _, shown in map(_condition, failsafe.to_arm))
    for name, text, key, doubt in (
        ("watches", failsafe.watched, "watches", f"whether {failsafe.watched} is to be watched"),
        ("of", failsafe.component.name if failsafe.component else "", "watches", ""),
        ("called", failsafe.title, "title", ""),
        ("looks", spec.when.value, "when", f"whether it is to look while the vehicle is {looks}"),
        ("is over", over, "over", ""),
        ("stays", stays, "latch", f"whether a level is to stay {stays}"),
        ("forbids arming", "yes" if spec.arming else "no", "arming", _ARMED),
        ("switched off by", enabled, "enabled_by", "whether who has switched it off, or not, means this one"),
        ("health in", health, "health", _TOLD),
        ("level in", level, "level", _TOLD),
        ("health told every", every, "health_every", "whether it is told often enough"),
    ):
        yield Fact(name, text, rules.FAILSAFE, spec.at(key), doubt=doubt)
    place = spec.at("believed_above")
    yield Fact("believed above", believed, rules.FAILSAFE, place, shown, "whether other values are to be believed")
    place = spec.at("to_arm")
    yield Fact("not armed while", _conditions(failsafe.to_arm), rules.FAILSAFE, place, to_arm, _ARMED)
    yield Fact("answers to", citations(failsafe.citation, failsafe.aspects), CITATION, spec.at("requirement"))


def _level(level: FailsafeLevel, failsafe: Failsafe) -> Iterator[Fact]:
    written, action, name = level.spec, level.action, level.name
    does = "" if action is None else action.name if isinstance(action, Parameter) else action.call
    shown = "; ".join(shown for _, shown in map(_condition, level.conditions))
    doubt = f"whether what is watched for and done at {name} is meant"
    counted = f"whether who is told the number of {name} knows it" if failsafe.level or failsafe.health else ""
    yield Fact(f"{name} is level", str(level.number), rules.FAILSAFE, written.place, doubt=counted)
    yield Fact(f"{name} while", _conditions(level.conditions), rules.FAILSAFE, written.place, shown, doubt)
    yield Fact(f"{name} does", does or "nothing but tell", rules.FAILSAFE, written.at("action"), doubt=doubt)
    yield Fact(f"{name} says", level.text.written, rules.FAILSAFE, written.at("text"))
    yield Fact(f"{name} answers to", str(level.citation or ""), CITATION, written.at("requirement"))


def _conditions(conditions: Iterable[Condition]) -> str:
    """Conditions as text that differs where one of them does, in whatever unit a quantity is kept."""
    return "; ".join(text for text, _ in map(_condition, conditions))


def _condition(condition: Condition) -> tuple[str, str]:
    """A condition in units that do not depend on how its quantity is kept, and for people."""
    subject = condition.quantity.path if condition.quantity else "ground station"
    limit = f" {_plain(condition.limit)}" if condition.limit else ""
    better, shown_better = _steps(condition.hysteresis or None, condition.quantity)
    ways = (
        (f"{subject} {condition.sense.value}{limit}", better),
        (condition.words, shown_better),
    )
    after = [f"for {condition.after.words}"] if condition.after else []
    compared, shown = (
        ", ".join([words, *after, *([f"until better by {amount_}"] if amount_ else [])]) for words, amount_ in ways
    )
    return compared, shown


def _plain(setting: Setting) -> str:
    if setting.parameter is not None:
        return setting.parameter.name
    return f"{setting.count * setting.unit.scale + setting.unit.zero} {setting.unit.dimension}"


def _steps(steps: int | None, quantity: Quantity | None) -> tuple[str, str]:
    """An amount in stored steps of a quantity: in no unit of its own, and for people."""
    if steps is None or quantity is None:
        return amount(steps), ""
    return f"{steps * quantity.stored.scale}", amount(steps, quantity.stored.name)


def action_subject(action: ActionSpec, program: Program) -> Subject:
    """An action: known by its number where a parameter chooses it, which is stored on boards, else by its call."""
    mode = "" if action.mode is None else str(action.mode)
    disarms = "yes" if action.disarm else ""
    facts = (
        Fact("call", action.call, rules.FAILSAFE, action.at("call")),
        Fact("value", str(action.value), rules.FAILSAFE, action.at("value")),
        Fact("mode", mode, rules.FAILSAFE, action.at("mode"), doubt=f"whether {action.call} is to report this mode"),
        Fact("priority", _place(action, program), rules.FAILSAFE, program.spec.at("priority")),
        Fact(
            "disarms",
            disarms,
            rules.FAILSAFE,
            action.at("disarm"),
            doubt=f"whether {action.call} {'may' if disarms else 'need not'} disarm the vehicle",
        ),
        Fact("doc", action.doc, DOC, action.at("doc")),
    )
    return Subject(
        f"failsafe action {action.value}",
        action.call,
        rules.FAILSAFE,
        rules.FAILSAFE,
        action.place,
        facts,
        key=f"action {action.value if is_chosen(program) else action.call}",
        doubt=f"whether nothing is to be done by {action.call}() any more",
    )


def is_chosen(program: Program) -> bool:
    """Return whether a parameter says by a number what is done at some level."""
    return any(isinstance(level.action, Parameter) for failsafe in program.failsafes for level in failsafe.levels)


def _place(action: ActionSpec, program: Program) -> str:
    """Return how many actions are more severe, in words; empty where none is said to be."""
    return f"behind {program.priority.index(action)} of {len(program.priority)}" if program.priority else ""
