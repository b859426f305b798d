# Generated from templates/codec/message.py: do not edit.
# Inputs: 75bc6c95852d4b78
"""The base class of all messages; messages.py derives a class for each."""

from array import array
from struct import pack_into

_type = type  # found here, it is found sooner than among the built-in names
keep = getattr(object, "__setattr__", setattr)  # a small port has none, and then does not ask __setattr__ either
_NOTHING_LIVE = array("i")
_fields = None  # the module: names of fields take memory, it is read when the first one is used


class Message:
    """One message.

    Attributes with the names of fields read and write them, as get() and set() do; there are no others to write. What
    is an attribute of each message, and what is a word of Python, has "_" behind it: `message.wire_` is a field `wire`.
    So have the keywords of update(), where the field is `self` or a word of Python. `wire`
    is the payload, without truncation: all fields in wire order. `live` holds the values of the live fields, see
    __init__(). `source_...` tells where a received message comes from.
    """

    NAME = ""
    ID = 0
    CRC_EXTRA = 0
    BASE_LENGTH = 0  # bytes of payload without extension fields: all that MAVLink 1 sends
    LENGTH = 0
    FIELDS = None  # name:code in wire order; see fields, and for the classes in messages.py message_fields
    TARGETS = ()  # where its payload has the target system and component, as far as it has them
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
        places, count = _read_fields().places(self, live) if live else (b"\0\0\0\0\4\0\1", 0)
        start = 9 + len(places)
        image = bytearray(start + ((length + 15) & -16))  # frames_plain says what it holds
        pack_into("<IBB", image, 0, self.ID | self.CRC_EXTRA << 24, length, self.BASE_LENGTH)
        image[9:start] = places
        keep(self, "_image", image)
        keep(self, "wire", memoryview(image)[start : start + length])
        keep(self, "live", array("i", [0] * count) if count else _NOTHING_LIVE)
        keep(self, "_take", None)  # what takes it on a link of a vehicle, see reception.py
        if unknown:
            _read_fields().forget(self)

    def __getattr__(self, name):
        return (_fields or _read_fields()).attribute(self, name)

    def __setattr__(self, name, value):
        _read_fields().assign(self, name, value)

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
        return (_fields or _read_fields()).get(self, name)

    def raw(self, name):
        """Return a field as get() does, but as it stands on the wire even if that means unknown."""
        return _read_fields().raw(self, name)

    def set(self, name, value):
        """Write a field: a number, as many numbers as the array has, or ASCII text or bytes, filled up with NUL.

        None makes a field, or an element, unknown. ValueError: the field cannot carry the value, and keeps what it
        had. KeyError: there is no such field.
        """
        field = self._layout or _read_fields().lay_out(self)
        if name not in field:
            raise _fields.missing(self, name)
        field = field[name]
        low = field[4]
        if _type(value) is _type(low) and not field[2] and low <= value <= field[5]:
            pack_into(field[0], self.wire, field[1], value)
        else:
            _fields.set(self, name, field, value)
        if self.live:
            _fields.take_live(self, field)

    def update(self, **values):
        """Write several fields, see set(), all of them or, if one is refused, none; return the message itself."""
        (_fields or _read_fields()).update(self, values)
        return self


def _read_fields():
    global _fields  # noqa: PLW0603  an import takes long, even where it finds the module in memory
    if _fields is None:
        import fields  # noqa: PLC0415

        _fields = fields
    return _fields
