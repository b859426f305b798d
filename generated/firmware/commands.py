# Generated from specs/vehicle.yaml, dialect common: do not edit.
# Inputs: ab31c14dcbb9b504
"""Commands (COMMAND_LONG and COMMAND_INT): each gets one COMMAND_ACK, whatever its parameters are."""

from struct import pack_into, unpack_from

import messages
from micropython import const

# Numbers of the dialect.
_COMMAND_ACK_COMMAND_AT = const(0)
_COMMAND_ACK_RESULT_AT = const(2)
_COMMAND_ACK_TARGET_COMPONENT_AT = const(9)
_COMMAND_ACK_TARGET_SYSTEM_AT = const(8)
_COMMAND_LONG_COMMAND_AT = const(28)
_COMMAND_LONG_PARAM1_AT = const(0)
_MAV_CMD_COMPONENT_ARM_DISARM = const(400)
_MAV_CMD_GET_MESSAGE_INTERVAL = const(510)
_MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN = const(246)
_MAV_CMD_PREFLIGHT_STORAGE = const(245)
_MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES = const(520)
_MAV_CMD_REQUEST_MESSAGE = const(512)
_MAV_CMD_REQUEST_PROTOCOL_VERSION = const(519)
_MAV_CMD_RUN_PREARM_CHECKS = const(401)
_MAV_CMD_SET_MESSAGE_INTERVAL = const(511)
_MAV_RESULT_ACCEPTED = const(0)
_MAV_RESULT_DENIED = const(2)
_MAV_RESULT_FAILED = const(4)
_MAV_RESULT_TEMPORARILY_REJECTED = const(1)
_MAV_RESULT_UNSUPPORTED = const(3)
_MAV_SEVERITY_ERROR = const(3)
_REBOOT_SHUTDOWN_ACTION_NONE = const(0)
_REBOOT_SHUTDOWN_ACTION_REBOOT = const(1)
_REBOOT_SHUTDOWN_CONDITIONS_FORCE = const(20190226)

_LARGEST_ID = const(0xFFFFFF)  # of a message in MAVLink 2
_LARGEST_INTERVAL_US = const(0x3FFFFFFF)  # 18 minutes: what a board counts without making an object


class Command:
    """One command: its number and the seven parameters, whole or not, finite or not."""

    def __init__(self, message):
        self.message = message
        self.number = unpack_from("<H", message.wire, _COMMAND_LONG_COMMAND_AT)[0]
        self.system = message.source_system
        self.component = message.source_component
        # COMMAND_INT has the same layout, but for x and y in place of parameters 5 and 6.
        form = "<4f2if" if message.ID == messages.CommandInt.ID else "<7f"
        self._params = unpack_from(form, message.wire, _COMMAND_LONG_PARAM1_AT)

    def param(self, number):
        """Return parameter 1 to 7 as it was sent."""
        return self._params[number - 1]

    def whole(self, number, smallest, largest):
        """Return parameter 1 to 7 if it is a whole number within these limits, else None."""
        value = self.param(number)
        if not smallest <= value <= largest or int(value) != value:  # NaN is not within any limits
            return None
        return int(value)


class Commands:
    """Does what commands ask for and acknowledges it.

    By the numbers of commands, `table` has what does them. That returns a MAV_RESULT and what is to be sent after the
    COMMAND_ACK, if anything: a function that returns whether the port took it, and its argument.
    """

    def __init__(self, vehicle, connection):
        self._vehicle = vehicle
        self._connection = connection
        self._ack = messages.CommandAck(unknown=False)
        self.table = {
            _MAV_CMD_REQUEST_MESSAGE: self._request_message,
            _MAV_CMD_SET_MESSAGE_INTERVAL: self._set_interval,
            _MAV_CMD_GET_MESSAGE_INTERVAL: self._get_interval,
            _MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES: self._request_capabilities,
            _MAV_CMD_REQUEST_PROTOCOL_VERSION: self._request_protocol_version,
            _MAV_CMD_COMPONENT_ARM_DISARM: self._arm_disarm,
            _MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN: self._reboot,
            _MAV_CMD_PREFLIGHT_STORAGE: self._do_rarely,
            _MAV_CMD_RUN_PREARM_CHECKS: self._do_rarely,
        }

    def handle(self, message):
        """Do what a COMMAND_LONG or COMMAND_INT asks for and answer it."""
        command = Command(message)
        result, follow_up = _MAV_RESULT_FAILED, None
        try:
            result, follow_up = self._do(command)
        finally:  # what raises is a fault of the vehicle: who asked learns that it failed
            self._connection.deliver(self._send_ack, (command, result))
        if follow_up is not None:
            self._connection.deliver(follow_up[0], follow_up[1])

    def _do(self, command):
        method = self.table.get(command.number)
        return (_MAV_RESULT_UNSUPPORTED, None) if method is None else method(command)

    def _send_ack(self, answer):
        command, result = answer
        wire = self._ack.wire
        pack_into("<H", wire, _COMMAND_ACK_COMMAND_AT, command.number)
        wire[_COMMAND_ACK_RESULT_AT] = result
        wire[_COMMAND_ACK_TARGET_SYSTEM_AT] = command.system
        wire[_COMMAND_ACK_TARGET_COMPONENT_AT] = command.component
        return self._connection.send(self._ack)

    def _request_message(self, command):
        message_id = command.whole(1, 0, _LARGEST_ID)
        if message_id == messages.MessageInterval.ID:
            return self._interval_of(command, 2)
        asked = command.param(2)  # the number of an instance, where the message is about one of several
        number = 0 if asked != asked else command.whole(2, 0, 255)  # noqa: PLR0124  NaN is not given: all, as 0 is
        if number is None or (message_id is not None and not self._connection.streams.has(message_id, number)):
            return _MAV_RESULT_DENIED, None
        return self._answer_with(message_id, number)

    def _request_capabilities(self, command):
        return self._answer_if_asked(command, "AutopilotVersion")

    def _request_protocol_version(self, command):
        return self._answer_if_asked(command, "ProtocolVersion")

    def _answer_if_asked(self, command, name):
        """Parameter 1 says whether to send the message: 1 or 0. Not every vehicle has a class for it."""
        message_id = getattr(getattr(messages, name, None), "ID", None)
        is_asked = command.whole(1, 0, 1)
        if is_asked is None:
            return _MAV_RESULT_DENIED, None
        return self._answer_with(message_id) if is_asked else (_MAV_RESULT_ACCEPTED, None)

    def _answer_with(self, message_id, number=0):
        if message_id is None or self._connection.streams.interval_us(message_id) == 0:
            return _MAV_RESULT_DENIED, None  # not a message of this vehicle
        if self._connection.streams.is_withheld(message_id):
            return _MAV_RESULT_TEMPORARILY_REJECTED, None  # what it tells is unknown
        return _MAV_RESULT_ACCEPTED, (self._send_message, (message_id, number))

    def _send_message(self, asked):
        """Send a message once, all instances or the one that is asked for; return whether the port took any of them.

        If it took none, they are sent again and do not count as lost, see Connection.send(). If it took some, the
        others are lost: on a slow link there might never be room for all at once.
        """
        link = self._connection.link
        sequence = link.sequence
        errors = link.tx_errors
        self._connection.streams.send(*asked)
        failed = link.tx_errors - errors
        if failed == 0 or (link.sequence - sequence) & 0xFF != failed:
            return True
        link.sequence = sequence
        link.tx_errors = errors
        return False

    def _set_interval(self, command):
        message_id = command.whole(1, 0, _LARGEST_ID)
        interval_us = _interval(command.param(2))
        if message_id is None or interval_us is None:
            return _MAV_RESULT_DENIED, None
        if not self._connection.streams.set_interval(message_id, interval_us):
            return _MAV_RESULT_DENIED, None  # not a message of this vehicle
        return _MAV_RESULT_ACCEPTED, None

    def _get_interval(self, command):
        return self._interval_of(command, 1)

    def _interval_of(self, command, number):
        import rare_commands  # noqa: PLC0415  with the first of them: few ask

        return rare_commands.interval_of(self._connection, command, number)

    def _arm_disarm(self, command):
        is_arming = command.whole(1, 0, 1)
        if is_arming is None:
            return _MAV_RESULT_DENIED, None
        is_forced = command.param(2) == self._vehicle.FORCE_ARM
        return self._result_of(self._vehicle.arm(is_forced) if is_arming else self._vehicle.disarm(is_forced))

    def _reboot(self, command):
        """Start again, if the vehicle is disarmed. Vehicle.reboot() leaves the COMMAND_ACK time to go out."""
        action = command.whole(1, 0, 0xFF)
        if action is None:
            return _MAV_RESULT_DENIED, None
        if action == _REBOOT_SHUTDOWN_ACTION_NONE:
            return _MAV_RESULT_ACCEPTED, None
        if action != _REBOOT_SHUTDOWN_ACTION_REBOOT:
            return _MAV_RESULT_UNSUPPORTED, None
        # On boards 20190226 arrives whole: a float of 32 bits carries even numbers up to 2 ** 25.
        return self._result_of(self._vehicle.reboot(command.param(6) == _REBOOT_SHUTDOWN_CONDITIONS_FORCE))

    def _do_rarely(self, command):
        import rare_commands  # noqa: PLC0415  with the first of them: few ask

        return rare_commands.do(self._vehicle, command), None

    def _result_of(self, why_not):
        """Return the result of what came back with None, or with a text why it was not done."""
        if why_not is None:
            return _MAV_RESULT_ACCEPTED, None
        self._vehicle.texts.say(_MAV_SEVERITY_ERROR, why_not)
        return _MAV_RESULT_FAILED, None


def _interval(asked):
    """Return an interval in whole microseconds, -1 and 0 as they are, or None; 1000000 / 3 is what people ask for."""
    if asked in (-1, 0):
        return int(asked)
    return int(asked) if 1 <= asked <= _LARGEST_INTERVAL_US else None
