"""The flag by which HEARTBEAT tells ground stations that the vehicle is armed."""

from collections.abc import Iterator, Sequence

from codegen.model.answers.answer import Answer
from codegen.model.answers.known import Known, Stored
from codegen.model.system import PopulatedMessage
from codegen.model.vehicle import QuantityKind

HEARTBEAT = "HEARTBEAT"
FIELD = "base_mode"
FLAG = "MAV_MODE_FLAG_SAFETY_ARMED"
ARMED = "vehicle.armed"
_BIT = 0x80


def armed_flag(messages: Sequence[PopulatedMessage]) -> tuple[bool, bool] | None:
    """Return whether the flag is set while disarmed, and while armed; None where something else decides over it."""
    found = [answer for message in messages if message.wire.name == HEARTBEAT for answer in _answers(message)]
    if len(found) != 1 or any(quantity.kind is not QuantityKind.BOOLEAN for quantity in found[0].quantities):
        return None
    flags = []
    for armed in (0, 1):
        bits = {_bit(found[0], others, armed) for others in ("clear", "set")}
        if len(bits) > 1:
            return None
        flags.append(bits.pop())
    return flags[0], flags[1]


def _answers(message: PopulatedMessage) -> Iterator[Answer]:
    return (answer for answer in message.answers if answer.covers.field.name == FIELD)


def _bit(answer: Answer, others: str, armed: int) -> bool:
    """Return whether the flag is set while all other booleans are ``clear`` or ``set``."""
    booleans: dict[str, Stored] = {
        quantity.decided_by: quantity.derivation.deciding(0, 1)[others] for quantity in answer.quantities
    }
    known: Known = {**booleans, ARMED: armed}
    return any(isinstance(value, int) and value & _BIT for value in answer.values(known, 0, 0))
