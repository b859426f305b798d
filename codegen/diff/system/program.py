"""Subjects of the program on the board, and of the receiver."""

from collections.abc import Iterator

from codegen.diff.system import behaviour_rules as rules
from codegen.diff.system.commands import command_subjects
from codegen.diff.system.failsafes import action_subject, failsafe_subject
from codegen.diff.system.subject import Fact, Subject, amount, citations, cited
from codegen.diff.system.trace_rules import CITATION
from codegen.loop.budget import loop_budget
from codegen.model.program import Program
from codegen.model.receiver import Receiver
from codegen.model.spec.receiver import ReceiverSpec, RolesSpec
from codegen.model.system import System
from codegen.source import Place

_FORCE = "whether who arms by force sends this number"
_READ = "whether what it reads no more, or only now, is meant"
_STALE = "whether nothing is to be known after so long"
_LASTS = "whether it still tells rightly how long something lasts"
_SILENCE = "whether stations that are silent for so long are gone"


def program_subjects(system: System) -> Iterator[Subject]:
    """The program, its failsafes and what they do, and the receiver, as far as there are any."""
    if system.program is not None:
        yield _program(system.program, system)
        yield _access(system, system.program)
        if system.has_whole_parameters:  # all others are alike in each encoding
            yield _encoding(system, system.program)
        yield from (failsafe_subject(failsafe) for failsafe in system.program.failsafes)
        yield from (action_subject(action, system.program) for action in system.program.actions)
        yield from command_subjects(system.program)
    if system.receiver is not None:
        yield _receiver(system.receiver)


def _program(program: Program, system: System) -> Subject:
    spec = program.spec
    arming = "" if spec.arming is None else str(spec.arming.force)
    services, silence = spec.services, amount(program.silence_ms, "ms")
    texts = (
        ("control slot every", amount(program.control_us, "us"), spec.control.at("rate")),
        ("links served every", amount(program.links_us, "us"), spec.control.at("links")),
        ("checks made every", amount(program.checks_us, "us"), spec.control.at("checks")),
        ("missed slots reported every", amount(program.report_ms, "ms"), spec.control.at("report_every")),
        ("step of a save takes at most", amount(program.step_limit_us, "us"), spec.storage.at("step_limit")),
        ("parameters stored in", f"{', '.join(spec.storage.files)} by {spec.storage.chunk} bytes", spec.storage.place),
        ("fastest without a stream:", amount(program.fastest, "Hz"), services.at("fastest")),
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
        Fact("armed past the checks by", arming, rules.PROGRAM, spec.at("arming"), doubt=_FORCE),
        Fact("ground station gone after", silence, rules.PROGRAM, services.at("silence"), doubt=_SILENCE),
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


def _encoding(system: System, program: Program) -> Subject:
    """The encoding of whole parameters, which all of them share."""
    place = system.spec.parameters.at("encoding")
    fact = Fact("encoding", program.encoding.value, rules.PARAMETER_ENCODING, place)
    says = f"encoding {program.encoding}"
    return Subject("whole parameters", says, rules.PROGRAM, rules.PROGRAM, place, (fact,))


def _receiver(receiver: Receiver) -> Subject:
    spec = receiver.spec
    over, stale = amount(receiver.rate_over_ms, "ms"), amount(receiver.stale_after_ms, "ms")
    names = tuple(message.wire.name for message in receiver.messages)
    facts = (
        Fact("component", receiver.component.name, rules.RECEIVER, spec.at("component")),
        Fact("reads", ", ".join(names), rules.RECEIVER, spec.place, doubt=_READ),
        Fact("stale after", stale, rules.RECEIVER, spec.at("stale_after"), doubt=_STALE),
        Fact("current averaged over", over, rules.RECEIVER, spec.at("rate_over"), doubt=_LASTS),
        *(Fact(f"{role} is", fields, rules.RECEIVER, spec.at("roles"), doubt=_LASTS) for role, fields in _roles(spec)),
        Fact("answers to", citations(receiver.citation, receiver.aspects), CITATION, spec.at("requirement")),
    )
    says = f"of {receiver.component.name}"
    citation = cited(receiver.citation, receiver.aspects)
    return Subject("receiver", says, rules.RECEIVER, rules.RECEIVER, spec.place, facts, citation, names)


def _roles(spec: ReceiverSpec) -> Iterator[tuple[str, str]]:
    """Return what each role is played by: any change of it may make another time that something lasts."""
    roles = spec.roles or RolesSpec(place=spec.place)
    yield from ((role, ", ".join(fields)) for role, fields in roles.fields())
    yield "charging", ", ".join(roles.charging)
    yield "counted anew", "yes" if roles.counted_anew else "no"
