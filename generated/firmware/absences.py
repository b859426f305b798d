# Generated from specs/vehicle.yaml, dialect common: do not edit.
# Inputs: b4b77e9ad30fcdc3
"""Answers about what this vehicle does not have: whoever asks for it waits for an answer, and asks again without one.

services.py loads this module with the first such question. Its messages are known by numbers alone, fields by their
places: classes would take more of the heap than the answers are worth.
"""

from message import Message, keep
from micropython import const

# Numbers of the dialect.
_COMMAND_ACK_COMMAND_AT = const(0)
_COMMAND_ACK_RESULT_AT = const(2)
_MAV_MISSION_ACCEPTED = const(0)
_MAV_MISSION_INVALID_SEQUENCE = const(13)
_MAV_MISSION_UNSUPPORTED = const(3)
_MAV_RESULT_UNSUPPORTED = const(3)
_MISSION_ACK_MISSION_TYPE_AT = const(3)
_MISSION_ACK_TYPE_AT = const(2)
_MISSION_CLEAR_ALL_MISSION_TYPE_AT = const(2)
_MISSION_COUNT_COUNT_AT = const(0)
_MISSION_COUNT_MISSION_TYPE_AT = const(4)
_MISSION_REQUEST_INT_MISSION_TYPE_AT = const(4)
_MISSION_REQUEST_LIST_MISSION_TYPE_AT = const(2)
_MISSION_REQUEST_PARTIAL_LIST_MISSION_TYPE_AT = const(6)

# By their ids: CRC_EXTRA, length without and with extension fields, where the target system and component stand.
_KINDS = {
    11: (89, 6, 6, (4,)),  # SET_MODE
    37: (212, 6, 7, (4, 5)),  # MISSION_REQUEST_PARTIAL_LIST
    38: (9, 6, 7, (4, 5)),  # MISSION_WRITE_PARTIAL_LIST
    40: (230, 4, 5, (2, 3)),  # MISSION_REQUEST
    43: (132, 2, 3, (0, 1)),  # MISSION_REQUEST_LIST
    44: (221, 4, 5, (2, 3)),  # MISSION_COUNT
    45: (232, 2, 3, (0, 1)),  # MISSION_CLEAR_ALL
    47: (153, 3, 4, (0, 1)),  # MISSION_ACK
    51: (196, 4, 5, (2, 3)),  # MISSION_REQUEST_INT
    77: (143, 3, 10, (8, 9)),  # COMMAND_ACK
    117: (128, 6, 6, (4, 5)),  # LOG_REQUEST_LIST
    118: (56, 14, 14, ()),  # LOG_ENTRY
}
_MISSION_COUNT = const(44)
_MISSION_ACK = const(47)
_LOG_ENTRY = const(118)
_COMMAND_ACK = const(77)


class Bare(Message):
    """A message that is known by its id, with zeros."""

    def __init__(self, number):
        extra, base_length, length, targets = _KINDS[number]
        keep(self, "ID", number)
        keep(self, "CRC_EXTRA", extra)
        keep(self, "BASE_LENGTH", base_length)
        keep(self, "LENGTH", length)
        keep(self, "TARGETS", targets)
        Message.__init__(self, unknown=False)


class Absences:
    """Answers the questions of a connection."""

    def __init__(self, connection):
        self._connection = connection
        for number, answer in (
            (43, self.count_none),
            (44, self.refuse_upload),
            (45, self.clear),
            (40, self.refuse_item),
            (51, self.refuse_item),
            (37, self.refuse_part),
            (38, self.refuse_part),
            (117, self.list_no_logs),
            (11, self.refuse_mode),
        ):
            connection.services.take(Bare(number), answer)

    def count_none(self, question):
        """MISSION_REQUEST_LIST: of whatever type the list is, nothing is in it."""
        answer = Bare(_MISSION_COUNT)
        answer.wire[_MISSION_COUNT_MISSION_TYPE_AT] = question.wire[_MISSION_REQUEST_LIST_MISSION_TYPE_AT]
        self._reply(question, answer)

    def refuse_upload(self, question):
        """MISSION_COUNT: there is no room for what would be sent; to send nothing clears the list."""
        wire = question.wire
        count = wire[_MISSION_COUNT_COUNT_AT] | wire[_MISSION_COUNT_COUNT_AT + 1]
        result = _MAV_MISSION_UNSUPPORTED if count else _MAV_MISSION_ACCEPTED
        self._acknowledge(question, result, wire[_MISSION_COUNT_MISSION_TYPE_AT])

    def clear(self, question):
        """MISSION_CLEAR_ALL: the list is empty already."""
        kind = question.wire[_MISSION_CLEAR_ALL_MISSION_TYPE_AT]
        self._acknowledge(question, _MAV_MISSION_ACCEPTED, kind)

    def refuse_item(self, question):
        """MISSION_REQUEST_INT and MISSION_REQUEST, which have the same layout: no item has that number."""
        kind = question.wire[_MISSION_REQUEST_INT_MISSION_TYPE_AT]
        self._acknowledge(question, _MAV_MISSION_INVALID_SEQUENCE, kind)

    def refuse_part(self, question):
        """MISSION_REQUEST_PARTIAL_LIST and MISSION_WRITE_PARTIAL_LIST, of one layout: no list has parts."""
        kind = question.wire[_MISSION_REQUEST_PARTIAL_LIST_MISSION_TYPE_AT]
        self._acknowledge(question, _MAV_MISSION_UNSUPPORTED, kind)

    def _acknowledge(self, question, result, kind):
        answer = Bare(_MISSION_ACK)
        answer.wire[_MISSION_ACK_TYPE_AT] = result
        answer.wire[_MISSION_ACK_MISSION_TYPE_AT] = kind
        self._reply(question, answer)

    def list_no_logs(self, question):
        """LOG_REQUEST_LIST: a LOG_ENTRY of zeros says that there are none."""
        self._reply(question, Bare(_LOG_ENTRY))

    def refuse_mode(self, question):
        """SET_MODE: there are no modes to change to; ArduPilot, too, answers with its id in place of a command's."""
        answer = Bare(_COMMAND_ACK)
        answer.wire[_COMMAND_ACK_COMMAND_AT] = question.ID
        answer.wire[_COMMAND_ACK_RESULT_AT] = _MAV_RESULT_UNSUPPORTED
        self._reply(question, answer)

    def _reply(self, question, answer):
        """Send an answer to who has asked; not each of them has a target."""
        if answer.TARGETS:
            answer.wire[answer.TARGETS[0]] = question.source_system
            answer.wire[answer.TARGETS[1]] = question.source_component
        self._connection.deliver(self._connection.send, answer)
