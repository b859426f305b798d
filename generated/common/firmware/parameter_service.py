# Generated from templates/firmware/program/parameter_service.py.j2, dialect common: do not edit.
# Inputs: c7b5183e7852930d
"""The parameter protocol: ground stations read parameters, one or all, and set them.

Values are C casts: PARAM_VALUE and PARAM_SET carry the number itself as a float, whatever type the parameter has. The
HEARTBEAT of an ArduPilot vehicle (MAV_AUTOPILOT_ARDUPILOTMEGA) says so.
"""

from struct import pack_into, unpack_from

import messages
import parameters
from micropython import const

# Numbers of the dialect.
_MAV_PARAM_ERROR_DOES_NOT_EXIST = const(1)
_MAV_PARAM_ERROR_READ_ONLY = const(5)
_MAV_PARAM_ERROR_VALUE_OUT_OF_RANGE = const(2)
_MAV_SEVERITY_NOTICE = const(5)
_PARAM_ERROR_ERROR_AT = const(20)
_PARAM_ERROR_PARAM_ID_AT = const(4)
_PARAM_ERROR_PARAM_INDEX_AT = const(0)
_PARAM_ERROR_TARGET_COMPONENT_AT = const(3)
_PARAM_ERROR_TARGET_SYSTEM_AT = const(2)
_PARAM_REQUEST_READ_PARAM_ID_AT = const(4)
_PARAM_REQUEST_READ_PARAM_INDEX_AT = const(0)
_PARAM_SET_PARAM_ID_AT = const(6)
_PARAM_SET_PARAM_VALUE_AT = const(0)
_PARAM_VALUE_PARAM_COUNT_AT = const(4)
_PARAM_VALUE_PARAM_ID_AT = const(8)
_PARAM_VALUE_PARAM_INDEX_AT = const(6)
_PARAM_VALUE_PARAM_TYPE_AT = const(24)
_PARAM_VALUE_PARAM_VALUE_AT = const(0)

_NO_INDEX = const(0xFFFF)  # PARAM_VALUE that is not part of the list
_BY_NAME = const(-1)  # index of requests that name the parameter
_NAME_SIZE = const(16)


class ParameterService:
    """Parameters of the vehicle over one connection."""

    def __init__(self, vehicle, connection):
        self._vehicle = vehicle
        self._connection = connection
        self._value = messages.ParamValue(unknown=False)  # each sets all fields

    def run(self):
        """Send the next value of a list that was asked for: one in a pass, so that streams have their turn."""
        station = self._connection.station
        index = station.parameter
        if index is None:
            return
        if index == parameters.COUNT:
            station.parameter = None
        elif self._send_value((parameters.name_of(index), index)):
            station.parameter = index + 1

    def list(self, _message):
        """PARAM_REQUEST_LIST: begin to send all values, from the first."""
        self._connection.station.parameter = 0

    def read(self, message):
        """PARAM_REQUEST_READ: send one value, chosen by its index or by its name."""
        asked = index = unpack_from("<h", message.wire, _PARAM_REQUEST_READ_PARAM_INDEX_AT)[0]
        name = _name(message.wire, _PARAM_REQUEST_READ_PARAM_ID_AT)
        if index == _BY_NAME:
            index = parameters.index_of(name)
        if index is not None and 0 <= index < parameters.COUNT:
            self._connection.deliver(self._send_value, (parameters.name_of(index), index))
        else:
            self._refuse(message, name, asked, _MAV_PARAM_ERROR_DOES_NOT_EXIST)

    def set(self, message):
        """PARAM_SET: take a value over; what is in force afterwards is the answer, whether it was accepted or not."""
        name = _name(message.wire, _PARAM_SET_PARAM_ID_AT)
        if parameters.index_of(name) is None:
            is_readable = name and max(name) < "\x80"
            self._say(f"{name} is no parameter" if is_readable else "a parameter of this name does not exist")
            self._refuse(message, name, _BY_NAME, _MAV_PARAM_ERROR_DOES_NOT_EXIST)
            return
        changes = self._vehicle.parameters.changes
        value = unpack_from("<f", message.wire, _PARAM_SET_PARAM_VALUE_AT)[0]
        if self._vehicle.restart_ms is not None:  # it could come too late to be saved
            self._say("the vehicle is about to restart")
            self._refuse(message, name, _BY_NAME, _MAV_PARAM_ERROR_READ_ONLY)
        elif not self._vehicle.parameters.set(name, value):
            from accepted_values import refusal  # noqa: PLC0415  rarely wanted

            self._say(refusal(self._vehicle.parameters, name, value))
            # Before the value: a ground station that takes the value for the answer would not see the reason.
            self._refuse(message, name, _BY_NAME, _MAV_PARAM_ERROR_VALUE_OUT_OF_RANGE)
        self._connection.deliver(self._send_value, (name, _NO_INDEX))
        if changes != self._vehicle.parameters.changes:
            self._tell_change(name)

    def announce(self, name, asking):
        """Send a value that a station has set to all others of this connection."""
        self._connection.deliver_to_others(asking, self._send_value, (name, _NO_INDEX))

    def _tell_change(self, name):
        if self._vehicle.parameters.is_after_reboot(name):
            self._say(f"{name} counts from the next start")
        for connection in self._vehicle.connections:
            connection.services.parameters.announce(name, self._connection.station)

    def _say(self, text):
        self._vehicle.texts.say(_MAV_SEVERITY_NOTICE, text)

    def _send_value(self, which):
        """Send (name, index) with the value that is in force now; return whether the port took it."""
        name, index = which
        wire = self._value.wire
        pack_into("<f", wire, _PARAM_VALUE_PARAM_VALUE_AT, self._vehicle.parameters.get(name))
        pack_into("<H", wire, _PARAM_VALUE_PARAM_COUNT_AT, parameters.COUNT)
        pack_into("<H", wire, _PARAM_VALUE_PARAM_INDEX_AT, index)
        _put_name(wire, _PARAM_VALUE_PARAM_ID_AT, name)
        wire[_PARAM_VALUE_PARAM_TYPE_AT] = self._vehicle.parameters.type_of(name)
        return self._connection.send(self._value)

    def _refuse(self, message, name, index, error):
        # MAVLink 1 has no PARAM_ERROR: its id is above 255.
        if self._connection.link.version == 1:
            return
        refusal = messages.ParamError(unknown=False)
        wire = refusal.wire
        pack_into("<h", wire, _PARAM_ERROR_PARAM_INDEX_AT, index)
        wire[_PARAM_ERROR_TARGET_SYSTEM_AT] = message.source_system
        wire[_PARAM_ERROR_TARGET_COMPONENT_AT] = message.source_component
        _put_name(wire, _PARAM_ERROR_PARAM_ID_AT, name)
        wire[_PARAM_ERROR_ERROR_AT] = error
        self._connection.deliver(self._connection.send, refusal)


def _name(wire, at):
    """Return the name in a payload, up to the first NUL; each byte is a character, whatever it is."""
    return "".join([chr(byte) for byte in bytes(wire[at : at + _NAME_SIZE]).split(b"\0")[0]])


def _put_name(wire, at, name):
    for place in range(_NAME_SIZE):
        wire[at + place] = ord(name[place]) if place < len(name) else 0
