"""Subjects of the program on the board, and of the receiver."""

from collections.abc import Iterable, Iterator

from codegen.diff.system import behaviour_rules as rules
from codegen.diff.system.commands import command_subjects
from codegen.diff.system.subject import Fact, Subject, amount, citations, cited
from codegen.diff.system.trace_rules import CITATION, DOC
from codegen.loop.budget import loop_budget
from codegen.model.failsafe import Condition, Failsafe
from codegen.model.program import Program
from codegen.model.receiver import Receiver
from codegen.model.spec.program import ActionSpec
from codegen.model.system import System
from codegen.model.vehicle import Parameter
from codegen.source import Place


def program_subjects(system: System) -> Iterator[Subject]:
    """The program, its failsafes and what they do, and the receiver, as far as there are any."""
    if system.program is not None:
        yield _program(system.program, system)
        yield _access(system, system.program)
        yield from (_failsafe(failsafe) for failsafe in system.program.failsafes)
        for action in system.program.actions:
            mode = "" if action.mode is None else str(action.mode)
            facts = (
                Fact("call", action.call, rules.FAILSAFE, action.at("call")),
                Fact("mode", mode, rules.FAILSAFE, action.at("mode")),
                Fact("priority", _place(action, system.program), rules.FAILSAFE, system.program.spec.at("priority")),
                Fact("disarms", "yes" if action.disarm else "", rules.FAILSAFE, action.at("disarm")),
                Fact("doc", action.doc, DOC, action.at("doc")),
            )
            name = f"failsafe action {action.value}"
            yield Subject(name, action.call, rules.FAILSAFE, rules.FAILSAFE, action.place, facts)
        yield from command_subjects(system.program)
    if system.receiver is not None:
        yield _receiver(system.receiver)


def _place(action: ActionSpec, program: Program) -> str:
    """Return how many actions are more severe, in words; empty where none is said to be."""
    return f"behind {program.priority.index(action)} of {len(program.priority)}" if program.priority else ""


def _program(program: Program, system: System) -> Subject:
    spec = program.spec
    arming = "" if spec.arming is None else str(spec.arming.force)
    services = spec.services
    texts = (
        ("control slot every", amount(program.control_us, "us"), spec.control.at("rate")),
        ("links served every", amount(program.links_us, "us"), spec.control.at("links")),
        ("checks made every", amount(program.checks_us, "us"), spec.control.at("checks")),
        ("missed slots reported every", amount(program.report_ms, "ms"), spec.control.at("report_every")),
        ("step of a save takes at most", amount(program.step_limit_us, "us"), spec.storage.at("step_limit")),
        ("parameters stored in", f"{', '.join(spec.storage.files)} by {spec.storage.chunk} bytes", spec.storage.place),
        ("armed past the checks by", arming, spec.at("arming")),
        ("fastest without a stream:", amount(program.fastest, "Hz"), services.at("fastest")),
        ("ground station gone after", amount(program.silence_ms, "ms"), services.at("silence")),
        ("longest slot takes, predicted", _longest(system), spec.control.at("rate")),
        *_watchdog(program),
        ("own code:", f"{program.module}.{program.class_name}", spec.at("code")),
        ("own code measures every", amount(program.measure_us, "us"), spec.at("code")),
        ("receives", ", ".join(message.name for message in program.services), spec.place),
        ("answers with", ", ".join(program.sent), spec.place),
        ("constants", ", ".join(f"{name} {value}" for name, value in sorted(program.constants.items())), spec.place),
    )
    aspects = {f"{section}.{name}": one for section, all_of in program.aspects.items() for name, one in all_of.items()}
    facts = (
        *(Fact(name, text, rules.PROGRAM, place) for name, text, place in texts),
        Fact("answers to", citations(None, {**program.cited, **aspects}), CITATION, spec.place),
    )
    says = f"control at {amount(program.control_us, 'us')}"
    return Subject("program", says, rules.PROGRAM, rules.PROGRAM, spec.place, facts, cited(program.cited, aspects))


def _longest(system: System) -> str:
    """Return how long the longest slot of control takes with all messages due, in
    tenths of ms; empty where nobody knows.
    """
    budget = loop_budget(system)
    took = budget.longest.busy.likely_us if budget else None
    return "" if took is None else f"{float(took) / 1000:.1f} ms"


def _watchdog(program: Program) -> tuple[tuple[str, str, Place], ...]:
    """Return what the watchdog does, as far as there is one."""
    watchdog, place = program.watchdog, program.spec.at("watchdog")
    if watchdog is None:
        return (("a loop that stands still is reset after", "", place), ("resets are told as", "", place))
    causes = ", ".join(f"{number} {words}" for number, words in sorted(watchdog.board.causes.items()))
    return (
        ("a loop that stands still is reset after", amount(watchdog.timeout_ms, "ms"), place),
        ("resets are told as", causes, place),
    )


def _access(system: System, program: Program) -> Subject:
    """Whom each link obeys; without ``access`` everybody."""
    access = program.access
    place = program.spec.at("access")
    systems = ", ".join(map(str, access.spec.stations)) if access else ""
    facts = []
    for name in (link.name for link in system.links):
        obeys = "everybody"
        if access is not None and name in access.signed:
            obeys = "who has the key"
        elif access is not None and name in access.listed:
            obeys = f"what says that it comes from {systems}"
        facts.append(Fact(f"{name} obeys", obeys, rules.ACCESS, place))
    setup = ", ".join(access.spec.setup) if access else ""
    facts += [
        Fact("a new key comes over", setup, rules.PROGRAM, place),
        Fact("key in", access.spec.key if access else "", rules.PROGRAM, place),
    ]
    return Subject("access", "", rules.PROGRAM, rules.PROGRAM, place, tuple(facts))


def _failsafe(failsafe: Failsafe) -> Subject:
    spec = failsafe.spec
    texts = (
        ("watches", failsafe.watched, "watches"),
        ("of", failsafe.component.name if failsafe.component else "", "watches"),
        ("called", failsafe.title, "title"),
        ("believed above", amount(failsafe.believed_above), "believed_above"),
        ("looks", spec.when.value, "when"),
        ("is over", failsafe.over.written if failsafe.over else "never", "over"),
        ("forbids arming", "yes" if spec.arming else "no", "arming"),
        ("switched off by", failsafe.enabled_by.name if failsafe.enabled_by else "", "enabled_by"),
        ("health in", failsafe.health.path if failsafe.health else "", "health"),
        ("level in", failsafe.level.path if failsafe.level else "", "level"),
        ("health told every", amount(failsafe.health_every_ms, "ms"), "health_every"),
    )
    facts = [Fact(name, text, rules.FAILSAFE, spec.at(key)) for name, text, key in texts]
    facts.append(Fact("not armed while", _conditions(failsafe.to_arm), rules.FAILSAFE, spec.at("to_arm")))
    for level in failsafe.levels:
        written, action = level.spec, level.action
        does = "" if action is None else action.name if isinstance(action, Parameter) else action.call
        facts += [
            Fact(f"{level.name} is level", str(level.number), rules.FAILSAFE, written.place),
            Fact(f"{level.name} while", _conditions(level.conditions), rules.FAILSAFE, written.place),
            Fact(f"{level.name} does", does, rules.FAILSAFE, written.at("action")),
            Fact(f"{level.name} says", level.text.written, rules.FAILSAFE, written.at("text")),
            Fact(f"{level.name} answers to", str(level.citation or ""), CITATION, written.at("requirement")),
        ]
    facts.append(Fact("answers to", citations(failsafe.citation, failsafe.aspects), CITATION, spec.at("requirement")))
    return Subject(
        name=f"failsafe {failsafe.name}",
        says=failsafe.watched,
        added=rules.FAILSAFE,
        removed=rules.FAILSAFE,
        place=spec.place,
        facts=tuple(facts),
        cited=cited(failsafe.citation, failsafe.aspects, *(level.citation for level in failsafe.levels)),
        row=failsafe.name,
    )


def _conditions(conditions: Iterable[Condition]) -> str:
    """Conditions as text that differs where one of them does."""
    return "; ".join(
        ", ".join(
            (
                condition.words,
                *([f"for {condition.after.words}"] if condition.after else []),
                *([f"until better by {condition.hysteresis}"] if condition.hysteresis else []),
            )
        )
        for condition in conditions
    )


def _receiver(receiver: Receiver) -> Subject:
    spec = receiver.spec
    names = tuple(message.wire.name for message in receiver.messages)
    facts = (
        Fact("component", receiver.component.name, rules.RECEIVER, spec.at("component")),
        Fact("reads", ", ".join(names), rules.RECEIVER, spec.place),
        Fact("stale after", amount(receiver.stale_after_ms, "ms"), rules.RECEIVER, spec.at("stale_after")),
        Fact("current averaged over", amount(receiver.rate_over_ms, "ms"), rules.RECEIVER, spec.at("rate_over")),
        Fact("answers to", citations(receiver.citation, receiver.aspects), CITATION, spec.at("requirement")),
    )
    says = f"of {receiver.component.name}"
    citation = cited(receiver.citation, receiver.aspects)
    return Subject("receiver", says, rules.RECEIVER, rules.RECEIVER, spec.place, facts, citation, names)
