"""Explains a sensor or a failsafe."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.explain.text import cited, facts
from codegen.model.failsafe import Condition, Failsafe, FailsafeLevel
from codegen.model.quantities.source_kind import Source
from codegen.model.system import System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import Parameter


def watching_stories(topic: str, system: System) -> Iterator[str]:
    """Yield the stories of the sensor and of the failsafe of a name."""
    if topic in system.sources:
        yield _sensor(system.sources[topic], system)
    for failsafe in system.program.failsafes if system.program else ():
        if failsafe.name == topic:
            yield _failsafe(failsafe)


def watching_topics(system: System) -> list[str]:
    """The names of the sensors and the failsafes."""
    failsafes = system.program.failsafes if system.program else ()
    return [*system.sources, *(failsafe.name for failsafe in failsafes)]


def _sensor(source: Source, system: System) -> str:
    polling = source.polling
    told = [
        *((fact.attribute, fact.text) for fact in source.facts()),
        *(("gives", f"{each.name} {each.low} to {each.high} {each.unit.name}".strip()) for each in source.outputs),
        ("asked every", f"{decimal(Fraction(polling.period_us, 1000))} ms"),
        ("sets", ", ".join(_set_by(source.name, system))),
        ("criterion", cited(polling.citation)),
        ("written at", polling.spec.place.shown()),
    ]
    doc = [polling.spec.doc] if polling.spec.doc else []
    return "\n".join([f"{source.name}, a sensor: {source.words()}", *doc, "", *facts(told)]) + "\n"


def _set_by(name: str, system: System) -> Iterator[str]:
    for component in system.components.values():
        for quantity in component.quantities.values():
            if any(given.partition(".")[0] == name for given, _, _ in quantity.derivation.gives):
                yield quantity.path


def _failsafe(failsafe: Failsafe) -> str:
    spec = failsafe.spec
    told = [
        ("looks", "while the vehicle is armed" if spec.when.value == "armed" else "armed or not"),
        *(fact for level in failsafe.levels for fact in _level(level)),
        ("not armed", f"while {'; '.join(map(_condition, failsafe.to_arm))}" if failsafe.to_arm else ""),
        ("arming", "is refused while it stands at a level" if spec.arming else ""),
        ("stays", "until the next start" if spec.latch else "until nothing of it holds"),
        ("is over", failsafe.over.written if failsafe.over else ""),
        ("switched off", f"by {failsafe.enabled_by.name} 0" if failsafe.enabled_by else ""),
        ("criterion", cited(failsafe.citation)),
        ("written at", spec.place.shown()),
    ]
    return "\n".join([f"{failsafe.name}, a failsafe: it watches {failsafe.watched}", "", *facts(told)]) + "\n"


def _level(level: FailsafeLevel) -> Iterator[tuple[str, str]]:
    yield level.name, f"level {level.number}, while {', or '.join(map(_condition, level.conditions))}"
    action = level.action
    if action is not None:
        does = f"what {action.name} says" if isinstance(action, Parameter) else f"{action.call}()"
        yield "  does", does
    yield "  says", level.text.written


def _condition(condition: Condition) -> str:
    subject = condition.quantity.path if condition.quantity else "the ground station"
    limit = f" {condition.limit.default_words}" if condition.limit else ""
    after = f" for {condition.after.default_words}" if condition.after else ""
    return f"{subject} {'is ' if condition.quantity else ''}{condition.sense.value}{limit}{after}"
