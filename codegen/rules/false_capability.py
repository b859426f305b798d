"""A capability, or an autopilot, by which stations speak another protocol than the program does."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.answers.answer import Answer
from codegen.model.spec.spec import ParameterEncoding, ParameterType
from codegen.model.system import System
from codegen.source import Place

RULE = Rule(
    "false-capability",
    "What AUTOPILOT_VERSION and HEARTBEAT say of the vehicle decides how stations speak to it. One that takes "
    "parameters as bytes, as of any autopilot but MAV_AUTOPILOT_ARDUPILOTMEGA, sets 7e-45 where it means 5, is told "
    "that it worked, and shows numbers that nobody has. The program carries whole parameters by 'encoding' of "
    "parameters.yaml, refuses each request for files, and takes missions only where a table of receives/ does. "
    "MAV_AUTOPILOT_INVALID says nothing of parameters, and real32 is the same in each encoding.",
    Severity.ERROR,
)
_CAPABILITIES, _AUTOPILOT = ("AUTOPILOT_VERSION", "capabilities"), ("HEARTBEAT", "autopilot")
_PREFIX = "MAV_PROTOCOL_CAPABILITY_"
_CAST_FLAG = f"{_PREFIX}PARAM_ENCODE_C_CAST"
_BYTE_FLAG = f"{_PREFIX}PARAM_ENCODE_BYTEWISE"
_CAST_AUTOPILOT = "MAV_AUTOPILOT_ARDUPILOTMEGA"
_SAYS_NOTHING = "MAV_AUTOPILOT_INVALID"

_OF_FLAG = {
    _CAST_FLAG: ParameterEncoding.C_CAST,
    _BYTE_FLAG: ParameterEncoding.BYTEWISE,
    f"{_PREFIX}PARAM_UNION": ParameterEncoding.BYTEWISE,  # of older dialects
}
_OF_MISSIONS = tuple(f"{_PREFIX}MISSION_{kind}" for kind in ("FLOAT", "INT", "FENCE", "RALLY"))
_WORDS = {
    ParameterEncoding.C_CAST: "parameters are C casts here: PARAM_SET and PARAM_VALUE carry the number as a float",
    ParameterEncoding.BYTEWISE: "parameters are bytewise here: PARAM_SET and PARAM_VALUE carry the bytes of integers",
}


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each entry that is told, always or at times, and does not hold of the program."""
    if system.program is None:
        return
    for message in system.messages:
        for answer in message.answers:
            field = (message.wire.name, answer.covers.field.name)
            if field == _CAPABILITIES:
                yield from _capabilities(answer, system)
            elif field == _AUTOPILOT and _is_encoded(system):
                yield from _autopilot(answer, system.program.encoding, system)


def _capabilities(answer: Answer, system: System) -> Iterator[Diagnostic]:
    enum = system.dialect.enums.get(answer.covers.field.definition.enum or "MAV_PROTOCOL_CAPABILITY")
    numbers = answer.constants if answer.conditions is None else tuple(answer.conditions)
    for entry in enum.entries if enum else ():
        if any(isinstance(number, int) and number & entry.value for number in numbers):
            yield from _flag(entry.name, answer, system)


def _flag(name: str, answer: Answer, system: System) -> Iterator[Diagnostic]:
    assert system.program is not None
    encoding = system.program.encoding
    missions = any(reception.wire.name.startswith("MISSION_") for reception in system.receptions)
    if _is_encoded(system) and _OF_FLAG.get(name, encoding) is not encoding:
        right = _CAST_FLAG if encoding is ParameterEncoding.C_CAST else _BYTE_FLAG
        hint = f"name {right} instead, or write encoding: {_OF_FLAG[name]} in parameters.yaml"
        yield _finding(answer, name, _WORDS[encoding], hint, system)
    elif name == f"{_PREFIX}FTP":
        yield _finding(answer, name, "each request for files is refused", "leave it out")
    elif name in _OF_MISSIONS and not missions:
        told = "missions are refused: no table of receives/ takes their messages"
        yield _finding(answer, name, told, "leave it out, or take MISSION_COUNT and MISSION_ITEM_INT in receives/")


def _is_encoded(system: System) -> bool:
    """Return whether parameters have an encoding that others may take for another; not where it was misspelt."""
    return system.has_whole_parameters and not system.spec.parameters.has_unread("encoding")


def _autopilot(answer: Answer, encoding: ParameterEncoding, system: System) -> Iterator[Diagnostic]:
    enum = system.dialect.enums.get(answer.covers.field.definition.enum or "MAV_AUTOPILOT")
    for number in set(answer.always or ()):
        name = next((entry.name for entry in enum.entries if entry.value == number), str(number)) if enum else ""
        is_cast = name == _CAST_AUTOPILOT
        if name == _SAYS_NOTHING or is_cast is (encoding is ParameterEncoding.C_CAST):
            continue
        other, of_whom = ("c_cast", "it") if is_cast else ("bytewise", f"all but {_CAST_AUTOPILOT}")
        hint = f"write encoding: {other} in parameters.yaml, as stations take parameters of {of_whom}"
        yield _finding(answer, name, _WORDS[encoding], hint, system)


def _finding(answer: Answer, name: str, words: str, hint: str, system: System | None = None) -> Diagnostic:
    """Return the finding; with the system it points at a parameter that is read wrongly, too."""
    related: tuple[tuple[Place, str], ...] = ()
    if system is not None:
        whole = next(each for each in system.parameters.values() if each.spec.type is not ParameterType.REAL32)
        related = ((whole.spec.at("type"), f"{whole.name} would be read and set wrongly"),)
    return Diagnostic(
        answer.covers.written.place, RULE, f"{answer.covers.label} says {name}, and {words}", hint, related
    )
