"""Answers to what ground stations send: what is addressed to this vehicle goes to the service that it is for."""

import struct
from time import ticks_diff, ticks_ms

import dialect
import messages
from commands import Commands
from listeners import Listeners
from micropython import const
from parameter_service import ParameterService

_COMPONENTS = const(12)  # that are told apart on one link, beside ground stations
_SENDER = const(23)  # where the state of a link has system << 8 | component of who has sent what arrived last
_HEAD = const(12)  # bytes of an FTP payload before its data: sequence (2), session, opcode, size, request's opcode, ...


class FtpHead(messages.FileTransferProtocol):
    """FILE_TRANSFER_PROTOCOL up to the first byte of its data: all that is read of a request and sent in a refusal.

    MAVLink 2 truncates the zeros behind it.
    """

    LENGTH = 16
    BASE_LENGTH = 16
    FIELDS = "target_network:B target_system:B target_component:B payload:13B"


def receivable(*others):
    """Return what a link receives into: of what comes all the time a message that is used again, of the rest classes.

    That is what Services answers, and `others`, which are used again, too.
    """
    often = (messages.Heartbeat, messages.Ping, messages.CommandLong)
    found = [kind(unknown=False) for kind in often + others]
    rare = (
        messages.ParamRequestRead,
        messages.ParamRequestList,
        messages.ParamSet,
        messages.RequestDataStream,
        messages.CommandInt,
        FtpHead,
    )
    found.extend(rare)
    return found


def _both(first, second):
    def take(message):
        first(message)
        second(message)

    return take


class Services:
    """The services of one connection.

    `ground_station` is (system, component) of the ground station that was heard last, None before the first.
    `listeners` are all ground stations that are heard, `components` all others: to each that appears goes what is sent
    on connection.
    What arrives goes to those who take it: take() adds one.
    """

    def __init__(self, vehicle, connection):
        self._vehicle = vehicle
        self._connection = connection
        self._received = connection.link._state  # frames_plain says what it holds
        self.commands = Commands(vehicle, connection)
        self.parameters = ParameterService(vehicle, connection)
        self.ground_station = None
        self.listeners = Listeners(vehicle.SILENCE_MS)
        self.components = Listeners(vehicle.SILENCE_MS, _COMPONENTS)
        self._takers = {}  # by the ids of messages: who takes them, and where those for this vehicle have their target
        for kind, taker in (
            (messages.Heartbeat, self._hear),
            (messages.Ping, self._answer_ping),
            (messages.CommandLong, self.commands.handle),
            (messages.CommandInt, self.commands.handle),
            (messages.ParamRequestList, self.parameters.list),
            (messages.ParamRequestRead, self.parameters.read),
            (messages.ParamSet, self.parameters.set),
            (messages.RequestDataStream, self._request_stream),
            (FtpHead, self._refuse_file),
        ):
            self.take(kind, taker)

    def take(self, kind, taker):
        """Call taker(message) with each message of a class that is for this vehicle, after those who take it already.

        The link has to receive it, see receivable(). What is for everybody, or names no target, is for this vehicle.
        """
        self.take_any(kind.ID, taker, kind.TARGETS)

    def take_any(self, number, taker, targets=()):
        """Call taker(message) with each message with an id, whoever it is for, unless take() was asked, too."""
        found = self._takers.get(number)
        if found is not None:
            taker, targets = _both(found[0], taker), targets or found[1]
        self._takers[number] = taker, targets

    def expect(self, ids):
        """Receive messages with these ids, too: absences.py answers that the vehicle has nothing of the kind."""
        self._connection.link.expect(ids, self._question)

    def run(self):
        """Go on with what takes several passes, for the station at hand."""
        self.parameters.run()

    def handle(self, message):
        """Give a message to who takes it, if it is for this vehicle and not its own; 0 addresses everybody."""
        connection = self._connection
        sent = message._image  # frames_plain says what it holds
        if sent[7] == connection.system_id and sent[8] == connection.component_id:
            return
        found = self._takers.get(message.ID)
        if found is not None:
            taker, targets = found
            if not targets or self._is_addressed(message.wire, targets):
                taker(message)

    def _is_addressed(self, wire, targets):
        target = wire[targets[0]]
        if target != 0 and target != self._connection.system_id:  # noqa: PLR1714  a tuple would take heap
            return False
        if len(targets) == 1:
            return True
        target = wire[targets[1]]
        return target == 0 or target == self._connection.component_id  # noqa: PLR1714  as above

    def _question(self, number):
        """Return a message for a question about what is not here; who answers it is loaded with the first."""
        import absences  # noqa: PLC0415  most vehicles never need it

        if number not in self._takers:
            absences.Absences(self._connection)
        return absences.Bare(number)

    def _hear(self, message):
        name = self._received[_SENDER]
        now_ms = ticks_ms()
        is_station = message.wire[dialect.HEARTBEAT_TYPE_AT] == dialect.MAV_TYPE_GCS
        known = self.listeners if is_station else self.components
        if known.last == name and ticks_diff(now_ms, known.heard_ms) < known.silence_ms:
            known.heard_ms = now_ms
            return
        if known.hear(name, now_ms):
            self._connection.streams.connect()
            if is_station:
                self._vehicle.remind()
        if is_station:
            self.ground_station = (name >> 8, name & 0xFF)

    def _answer_ping(self, message):
        # An addressed PING is the answer to one: it has come back, and is not answered again.
        wire = message.wire
        if wire[dialect.PING_TARGET_SYSTEM_AT] or wire[dialect.PING_TARGET_COMPONENT_AT]:
            return
        wire[dialect.PING_TARGET_SYSTEM_AT] = message.source_system
        wire[dialect.PING_TARGET_COMPONENT_AT] = message.source_component
        self._connection.link.send(message)  # a late answer would measure the wait: better none
        wire[dialect.PING_TARGET_SYSTEM_AT] = wire[dialect.PING_TARGET_COMPONENT_AT] = 0  # as it came, for who is next

    def _request_stream(self, message):
        wire = message.wire
        rate_hz = 0
        if wire[dialect.REQUEST_DATA_STREAM_START_STOP_AT]:
            rate_hz = struct.unpack_from("<H", wire, dialect.REQUEST_DATA_STREAM_REQ_MESSAGE_RATE_AT)[0]
        self._connection.streams.request(wire[dialect.REQUEST_DATA_STREAM_REQ_STREAM_ID_AT], rate_hz)

    def _refuse_file(self, message):
        """Refuse a request for files, so that who asks turns to other ways at once, as to the parameter protocol.

        Requests are repeated until they are answered: a refusal that the port did not take needs no second try.
        """
        at = dialect.FILE_TRANSFER_PROTOCOL_PAYLOAD_AT
        request = message.wire[at:]
        if request[3] >= dialect.MAV_FTP_OPCODE_ACK or self._connection.link.version == 1:
            return  # an answer, or MAVLink 1, which would take all 251 bytes of the payload
        sequence = (request[0] | request[1] << 8) + 1
        refusal = FtpHead(unknown=False)  # few ask: kept, it would take more of the heap than it is worth
        wire = refusal.wire
        wire[dialect.FILE_TRANSFER_PROTOCOL_TARGET_SYSTEM_AT] = message.source_system
        wire[dialect.FILE_TRANSFER_PROTOCOL_TARGET_COMPONENT_AT] = message.source_component
        payload = wire[at:]
        payload[0] = sequence & 0xFF
        payload[1] = (sequence >> 8) & 0xFF
        payload[2] = request[2]
        payload[3] = dialect.MAV_FTP_OPCODE_NAK
        payload[4] = 1  # byte of data: the reason
        payload[5] = request[3]
        payload[_HEAD] = dialect.MAV_FTP_ERR_UNKNOWNCOMMAND
        self._connection.link.send(refusal)
