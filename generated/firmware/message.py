# Generated from templates/codec/message.py: do not edit.
# Inputs: 1b6b775a0e90ec62
"""What all messages have in common; messages.py derives a class for each."""

from array import array
from struct import pack_into, unpack_from

_NOTHING_LIVE = array("i")
_type = type  # found here, it is found sooner than among the built-in names
_keep = getattr(object, "__setattr__", setattr)  # a small port has none, and then does not ask __setattr__ either
_fields = None  # the module: names of fields take memory, it is read when the first one is used


class Message:
    """One message.

    Attributes with the names of fields read and write them, as get() and set() do; there are no others to write. `wire`
    is the payload, without truncation: all fields in wire order. `live` holds the values of the live fields, see
    __init__(). `source_...` tells where a received message comes from.
    """

    NAME = ""
    ID = 0
    CRC_EXTRA = 0
    BASE_LENGTH = 0  # bytes of payload without extension fields: all that MAVLink 1 sends
    LENGTH = 0
    FIELDS = ""  # name:code in wire order; see fields
    DEFAULTS = {}  # what fields hold at first instead of 0: the version of the dialect

    _layout = None  # what fields.layout() returns, once it is needed

    def __init__(self, live=(), unknown=True):
        """Make a message; what the dialect has a value for "unknown" for is unknown at first, everything else is 0.

        `live` names fields that change often, whole numbers of up to 32 bits. Their values, one for each element, stand
        in the array `live`: every frame that is encoded takes them from there, every frame that is received puts them
        there. Write its elements, `live[0] = 5`. They are not checked: what a field cannot carry wraps, and a uint32
        above 2 ** 31 - 1 is negative, as an int32 of the same bits. `unknown=False` starts with zeros only.
        ValueError: a field cannot be live. KeyError: there is no such field.
        """
        length = self.LENGTH
        places, start, count = _read_fields().places(self, live) if live else (b"", 16, 0)
        image = bytearray(start + ((length + 15) & -16))  # frames_plain says what it holds
        image[0] = self.ID & 0xFF
        image[1] = (self.ID >> 8) & 0xFF
        image[2] = self.ID >> 16
        image[3] = self.CRC_EXTRA
        image[4] = length
        image[5] = self.BASE_LENGTH
        image[9 : 9 + len(places)] = places
        image[13] = start >> 2
        image[start - 1] = 1
        _keep(self, "_image", image)
        _keep(self, "wire", memoryview(image)[start : start + length])
        _keep(self, "_live", array("i", [0] * count) if live else _NOTHING_LIVE)
        _keep(self, "live", self._live)
        if unknown and ("=" in self.FIELDS or self.DEFAULTS):
            _read_fields().forget(self)

    def __getattr__(self, name):
        try:
            return self.get(name)
        except KeyError:
            raise AttributeError(name) from None

    def __setattr__(self, name, value):
        try:
            self.set(name, value)
        except KeyError:
            raise AttributeError(name) from None

    def __repr__(self):
        return _read_fields().text(self)

    @property
    def source_sequence(self):
        """Sequence number of the frame that this message came with."""
        return self._image[6]

    @property
    def source_system(self):
        """System id of the sender."""
        return self._image[7]

    @property
    def source_component(self):
        """Component id of the sender."""
        return self._image[8]

    def names(self):
        """Return the names of the fields in wire order."""
        return _read_fields().names(self)

    def get(self, name):
        """Return a field, or None if it is unknown: what stands on the wire is what the dialect has for that.

        A number, a tuple for an array, None for each unknown element in it. Characters come as text up to the first
        NUL, as bytes if they are not ASCII, and never as None. KeyError: there is no such field.
        """
        field = (self._layout or _lay_out(self))[name]
        if field[2] or self._live:
            return _fields.get(self, field)
        value = unpack_from(field[0], self.wire, field[1])[0]
        return None if field[3] and _fields.is_unknown(value, field[3][0]) else value

    def raw(self, name):
        """Return a field as get() does, but as it stands on the wire even if that means unknown."""
        field = (self._layout or _lay_out(self))[name]
        if field[2] or self._live:
            return _fields.raw(self, field)
        return unpack_from(field[0], self.wire, field[1])[0]

    def set(self, name, value):
        """Write a field: a number, as many numbers as the array has, or ASCII text or bytes, filled up with NUL.

        None makes a field, or an element, unknown. ValueError: the field cannot carry the value, and keeps what it
        had. KeyError: there is no such field.
        """
        field = (self._layout or _lay_out(self))[name]
        low = field[4]
        if _type(value) is _type(low) and not field[2] and low <= value <= field[5]:
            pack_into(field[0], self.wire, field[1], value)
        else:
            _fields.set(self, name, field, value)
        if self._live:
            _fields.take_live(self, field)

    def update(self, **values):
        """Write several fields, one after the other, see set(); return the message itself."""
        layout = self._layout or _lay_out(self)
        wire = self.wire
        live = self._live
        kind_of = _type
        for name in values:  # noqa: PLC0206  items() would make a tuple of each
            # What set() does, without a call for each field and what it would look up again.
            value = values[name]
            field = layout[name]
            low = field[4]
            if kind_of(value) is kind_of(low) and not field[2] and low <= value <= field[5]:
                pack_into(field[0], wire, field[1], value)
            else:
                _fields.set(self, name, field, value)
            if live:
                _fields.take_live(self, field)
        return self


def _read_fields():
    global _fields  # noqa: PLW0603  an import takes long, even where it finds the module in memory
    if _fields is None:
        import fields  # noqa: PLC0415

        _fields = fields
    return _fields


def _lay_out(message):
    layout = _read_fields().layout(type(message))
    _keep(message, "_layout", layout)
    return layout
