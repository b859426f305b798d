# Generated from templates/codec/message.py: do not edit.
# Inputs: e215123e9bc6c13b
"""What all messages have in common; messages.py derives a class for each."""

from array import array

_NOTHING_LIVE = array("i")


class Message:
    """One message.

    `wire` is the payload, without truncation: all fields in wire order. Attributes with the names of fields read them;
    they do not write, set() does. `live` holds the values of the live fields, see __init__(). `source_...` tells where
    a received message comes from.
    """

    NAME = ""
    ID = 0
    CRC_EXTRA = 0
    BASE_LENGTH = 0  # bytes of payload without extension fields: all that MAVLink 1 sends
    LENGTH = 0
    FIELDS = ""  # name:code in wire order; see fields
    DEFAULTS = {}  # what fields hold at first instead of 0: the version of the dialect

    def __init__(self, live=(), unknown=True):
        """Make a message; what the dialect has a value for "unknown" for is unknown at first, everything else is 0.

        `live` names fields that change often, whole numbers of up to 32 bits. Their values, one for each element, stand
        in the array `live`: every frame that is encoded takes them from there, every frame that is received puts them
        there. Write its elements, `live[0] = 5`; another array has no effect. They are not checked: what a field
        cannot carry wraps, and a uint32 above 2 ** 31 - 1 is negative, as an int32 of the same bits. `unknown=False`
        starts with zeros only. ValueError: a field cannot be live. KeyError: there is no such field.
        """
        places = _fields().places(self, live) if live else ()
        start = (13 + 2 * len(places)) & -4
        self._image = image = bytearray(start + ((self.LENGTH + 3) & -4))  # frames_plain says what it holds
        self.wire = memoryview(image)[start : start + self.LENGTH]
        self.live = self._live = array("i", [0] * len(places)) if live else _NOTHING_LIVE
        image[0] = self.ID & 0xFF
        image[1] = (self.ID >> 8) & 0xFF
        image[2] = self.ID >> 16
        image[3] = self.CRC_EXTRA
        image[4] = self.LENGTH
        image[5] = self.BASE_LENGTH
        image[6] = len(places)
        for index, place in enumerate(places):
            image[10 + 2 * index] = place & 0xFF
            image[11 + 2 * index] = place >> 8
        if unknown and "=" in self.FIELDS:
            _fields().forget(self)
        if unknown:
            self.update(**self.DEFAULTS)

    def __getattr__(self, name):
        try:
            return self.get(name)
        except KeyError:
            raise AttributeError(name) from None

    def __repr__(self):
        return _fields().text(self)

    @property
    def source_sequence(self):
        """Sequence number of the frame that this message came with."""
        return self._image[7]

    @property
    def source_system(self):
        """System id of the sender."""
        return self._image[8]

    @property
    def source_component(self):
        """Component id of the sender."""
        return self._image[9]

    def names(self):
        """Return the names of the fields in wire order."""
        return _fields().names(self)

    def get(self, name):
        """Return a field, or None if it is unknown: what stands on the wire is what the dialect has for that.

        A number, a tuple for an array, None for each unknown element in it. Characters come as text up to the first
        NUL, as bytes if they are not ASCII, and never as None. KeyError: there is no such field.
        """
        return _fields().get(self, name)

    def raw(self, name):
        """Return a field as get() does, but as it stands on the wire even if that means unknown."""
        return _fields().raw(self, name)

    def set(self, name, value):
        """Write a field: a number, as many numbers as the array has, or ASCII text or bytes, filled up with NUL.

        None makes a field, or an element, unknown. ValueError: the field cannot carry the value, and keeps what it
        had. KeyError: there is no such field.
        """
        _fields().set(self, name, value)

    def update(self, **values):
        """Write several fields, one after the other, see set(); return the message itself."""
        for name, value in values.items():
            self.set(name, value)
        return self


def _fields():
    # Names of fields take memory: they are read when the first one is used.
    import fields  # noqa: PLC0415

    return fields
