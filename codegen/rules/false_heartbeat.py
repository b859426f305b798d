"""A HEARTBEAT that says something else than the program does, or that is never sent."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity, shortened_list
from codegen.model.answers.answer import Answer
from codegen.model.armed_flag import HEARTBEAT
from codegen.model.dialect.wire_types import VERSION_TYPE
from codegen.model.program import Program, is_set_by_program
from codegen.model.system import PopulatedMessage, System

RULE = Rule(
    "false-heartbeat",
    "HEARTBEAT says the same in every mode though vehicle.yaml declares modes, or the same state of the system though "
    "a failsafe makes that MAV_STATE_CRITICAL, or it belongs to no stream that sends it; or a field that carries the "
    "version of MAVLink carries another number. Ground stations know nothing of the vehicle by other means.",
)
UNSENT = Rule(
    "no-heartbeat",
    "A program around the telemetry (vehicle.yaml) sends no HEARTBEAT, since no table is for it. Ground stations show "
    "no system, and a few send it nothing, before they have heard one.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """The tables of HEARTBEAT, and each field of any message with the version."""
    for message in system.messages:
        for answer in message.answers:
            if answer.covers.field.definition.type == VERSION_TYPE:
                yield from _version(message, answer, system)
    if system.program is None:
        return
    tables = [message for message in system.messages if message.wire.name == HEARTBEAT]
    if tables and not any(message.stream and message.stream.default_rate for message in tables):
        yield _unsent(tables[0])
    elif not tables and HEARTBEAT in system.dialect.messages:
        hint = "write messages/heartbeat.yaml: message: HEARTBEAT, with a stream of 1 Hz"
        yield Diagnostic(system.program.spec.place, UNSENT, f"no table of messages/ is for {HEARTBEAT}", hint)
    for message in tables:
        yield from _told(message, system.program, system)


def _version(message: PopulatedMessage, answer: Answer, system: System) -> Iterator[Diagnostic]:
    version, label = system.dialect.version, answer.covers.label
    if answer.always != (version,):
        says = "what can differ" if answer.always is None else str(answer.always[0])
        text = f"{message.name}.{label} is {says}, and the version of MAVLink in the dialect is {version}"
        yield Diagnostic(answer.covers.written.place, RULE, text, f"{label}: {{dialect: version}}")


def _unsent(message: PopulatedMessage) -> Diagnostic:
    stream = message.stream
    if stream is None:
        text, place = "belongs to no stream, so that it is sent to nobody who does not ask", message.population.place
        return Diagnostic(place, RULE, f"{HEARTBEAT} {text}", "stream: and a stream of 1 Hz of streams.yaml")
    source = f" ({stream.parameter.name}, by default)" if stream.parameter else ""
    text = f"{HEARTBEAT} is never sent: the stream {stream.name} goes out at 0 Hz{source}"
    place = message.population.at("stream")
    return Diagnostic(place, RULE, text, "take a stream of 1 Hz", ((stream.spec.place, "the stream is here"),))


def _told(message: PopulatedMessage, program: Program, system: System) -> Iterator[Diagnostic]:
    vehicle = system.components.get("vehicle")
    for answer in message.answers:
        field, always = answer.covers.field.name, answer.always
        if always is None:
            continue
        if field == "custom_mode" and (program.modes or any(action.mode is not None for action in program.actions)):
            text = f"{HEARTBEAT}.{field} is {always[0]}, always, and {_modes(program)}"
            yield Diagnostic(answer.covers.written.place, RULE, text, f"{field}: {{state: vehicle.mode}}")
        if field == "system_status" and program.failsafes and is_set_by_program(vehicle, "status"):
            told = answer.words().source
            text = f"{HEARTBEAT}.{field} is {told}, always, and not MAV_STATE_CRITICAL while a failsafe is up"
            declared = ((program.failsafes[0].spec.place, "a failsafe is declared here"),)
            yield Diagnostic(answer.covers.written.place, RULE, text, f"{field}: {{state: vehicle.status}}", declared)


def _modes(program: Program) -> str:
    """Return which modes the vehicle can be in, as the end of a sentence."""
    if program.modes:
        return f"the vehicle has the modes {shortened_list([f'{mode.number} ({mode.name})' for mode in program.modes])}"
    action = next(action for action in program.actions if action.mode is not None)
    return f"the action {action.call} changes the mode to {action.mode}"
