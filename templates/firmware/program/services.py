"""Answers to what ground stations send: what is addressed to this vehicle goes to the service that it is for."""

import time

import dialect
import messages
from commands import Commands
from listeners import Listeners
from micropython import const
from parameter_service import ParameterService

_HEAD = const(12)  # bytes of an FTP payload before its data: sequence (2), session, opcode, size, request's opcode, ...


class FtpHead(messages.FileTransferProtocol):
    """FILE_TRANSFER_PROTOCOL up to the first byte of its data: all that is read of a request and sent in a refusal.

    MAVLink 2 truncates the zeros behind it.
    """

    LENGTH = 16
    BASE_LENGTH = 16
    FIELDS = "target_network:B target_system:B target_component:B payload:13B"


def receivable():
    """Return a new message of each kind that Services answers, for a link to receive into."""
    return (
        messages.Heartbeat(unknown=False),
        messages.Ping(unknown=False),
        messages.ParamRequestRead(unknown=False),
        messages.ParamRequestList(unknown=False),
        messages.ParamSet(unknown=False),
        messages.RequestDataStream(unknown=False),
        messages.CommandInt(unknown=False),
        messages.CommandLong(unknown=False),
        FtpHead(unknown=False),
    )


class Services:
    """The services of one connection.

    `ground_station` is (system, component) of the ground station that was heard last, None before the first, and
    `heard_ms` the time.ticks_ms() of its last HEARTBEAT. `listeners` are all that are heard.
    By the ids of messages, `for_all` take those without a target, `for_target` those that are for this vehicle.
    """

    def __init__(self, vehicle, connection):
        self._connection = connection
        self.commands = Commands(vehicle, connection)
        self.parameters = ParameterService(vehicle, connection)
        self.ground_station = None
        self.heard_ms = None
        self.listeners = Listeners(vehicle.SILENCE_MS)
        self._pong = messages.Ping(unknown=False)
        self._refusal = FtpHead(unknown=False)
        self.for_all = {messages.Heartbeat.ID: self._hear, messages.Ping.ID: self._answer_ping}
        self.for_target = {
            messages.CommandLong.ID: self.commands.handle,
            messages.CommandInt.ID: self.commands.handle,
            messages.ParamRequestList.ID: self.parameters.list,
            messages.ParamRequestRead.ID: self.parameters.read,
            messages.ParamSet.ID: self.parameters.set,
            messages.RequestDataStream.ID: self._request_stream,
            FtpHead.ID: self._refuse_file,
        }

    def run(self):
        """Go on with what takes several passes."""
        self.parameters.run()
        self.listeners.forget_silent(time.ticks_ms())

    def handle(self, message):
        """Answer a message, if it is for this vehicle and not its own."""
        connection = self._connection
        if message.source_system == connection.system_id and message.source_component == connection.component_id:
            return
        handler = self.for_all.get(message.ID)
        if handler is None and self._is_addressed(message):
            handler = self.for_target.get(message.ID)
        if handler is not None:
            handler(message)

    def _is_addressed(self, message):
        # 0 addresses every system, or every component.
        if message.ID not in self.for_target or message.raw("target_system") not in (0, self._connection.system_id):
            return False
        return message.raw("target_component") in (0, self._connection.component_id)

    def _hear(self, message):
        if message.raw("type") == dialect.MAV_TYPE_GCS:
            self.ground_station = (message.source_system, message.source_component)
            self.heard_ms = time.ticks_ms()
            if self.listeners.hear(message.source_system, message.source_component, self.heard_ms):
                self._connection.streams.connect()

    def _answer_ping(self, message):
        # An addressed PING is the answer to one: it has come back, and is not answered again.
        if message.raw("target_system") or message.raw("target_component"):
            return
        self._pong.wire[:] = message.wire
        self._pong.update(target_system=message.source_system, target_component=message.source_component)
        self._connection.link.send(self._pong)  # a late answer would measure the wait: better none

    def _request_stream(self, message):
        rate_hz = message.raw("req_message_rate") if message.raw("start_stop") else 0
        self._connection.streams.request(message.raw("req_stream_id"), rate_hz)

    def _refuse_file(self, message):
        """Refuse a request for files, so that who asks turns to other ways at once, as to the parameter protocol.

        Requests are repeated until they are answered: a refusal that the port did not take needs no second try.
        """
        request = message.raw("payload")
        if request[3] >= dialect.MAV_FTP_OPCODE_ACK or self._connection.link.version == 1:
            return  # an answer, or MAVLink 1, which would take all 251 bytes of the payload
        sequence = (request[0] | request[1] << 8) + 1
        payload = [0] * (_HEAD + 1)
        payload[0] = sequence & 0xFF
        payload[1] = (sequence >> 8) & 0xFF
        payload[2] = request[2]
        payload[3] = dialect.MAV_FTP_OPCODE_NAK
        payload[4] = 1  # byte of data: the reason
        payload[5] = request[3]
        payload[_HEAD] = dialect.MAV_FTP_ERR_UNKNOWNCOMMAND
        self._refusal.update(
            target_system=message.source_system, target_component=message.source_component, payload=payload
        )
        self._connection.link.send(self._refusal)
