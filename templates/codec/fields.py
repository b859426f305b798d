"""Single fields of a message by name, with equal strictness on CPython and MicroPython: for set-up, people and tests.

A class states its fields in wire order as words `name:code` or `name:<count>code`, with struct's codes ("s" is text of
`count` characters), and behind "=" what means unknown: `=V` in the field or in any element, `=V:` in element 0 for the
whole array, `=V1,,V3` element by element. Where it states none, they are those of its ID in message_fields: who needs
no names of fields does without that module, too.
"""

import struct
from struct import pack_into, unpack_from

from message import keep

_INFINITY = float("inf")
# Found here, they are found sooner than among the built-in names.
_bytes, _len, _list, _tuple, _type = bytes, len, list, tuple, type
_OWN = ("wire", "live")  # what a message keeps as attributes, and shows
_LAYOUTS = {}
_FORGOTTEN = {}  # payloads of messages that know nothing
_WHOLE = (("b", 8), ("h", 16), ("i", 32), ("q", 64))
# Of each code what a number of it is for struct, its bytes, and the limits of what is carried for sure, None for text;
# what is beyond those of floats struct has to be asked about.
_NUMBERS = {code: ("<" + code, bits // 8, -(1 << bits - 1), (1 << bits - 1) - 1) for code, bits in _WHOLE}
_NUMBERS.update({code.upper(): ("<" + code.upper(), bits // 8, 0, (1 << bits) - 1) for code, bits in _WHOLE})
_NUMBERS["f"] = ("<f", 4, -3.4028234e38, 3.4028234e38)
_NUMBERS["d"] = ("<d", 8, -1.7976931e308, 1.7976931e308)
_NUMBERS["s"] = (None, 1, None, None)
_live_fields = None  # the module


def layout(cls):
    """Return {name: (form, offset, count, sentinels, lowest, highest)} of a class, made at its first use.

    `form` is for struct. Count 0 is a scalar. Sentinels is empty without any; of an array it is bytes, the array with
    every element unknown, where one value speaks for any, else a tuple: a value or None for each element, or, longer
    by so many, the values of the first, or of all elements, for the whole array. An int or float, as the limits are,
    from lowest to highest is carried for sure; of text they are None.
    """
    if cls not in _LAYOUTS:
        _LAYOUTS[cls] = layout_of(cls)
    return _LAYOUTS[cls]


def lay_out(message):
    """Return the layout of a message's class, which the message keeps from now on."""
    found = layout(type(message))
    keep(message, "_layout", found)
    return found


def layout_of(cls):
    """Return the layout of a class without keeping it."""
    found = {}
    offset = 0
    for word in _words(cls):
        name, form = word.split(":", 1)
        form, _, unknown = form.partition("=")
        code = form[-1]
        count = int(form[:-1] or 0) or (1 if code == "s" else 0)
        scalar, size, low, high = _NUMBERS[code]
        sentinels = _sentinels(unknown, form, count)
        found[name] = ("<" + form if count else scalar, offset, count, sentinels, low, high)
        offset += size * (count or 1)
    return dict(**found)  # what are keywords is found sooner, and takes less memory


def names(message):
    """Return the names of the fields in wire order."""
    return [word.split(":")[0] for word in _words(_type(message))]


def _words(cls):
    """Return the words that state the fields of a class."""
    fields = cls.FIELDS
    if fields is None:
        import message_fields  # noqa: PLC0415  as live_fields

        fields = message_fields.FIELDS[cls.ID]
    return fields.split()


def text(message):
    """Return the message as people read it: its name and its fields in wire order."""
    return message.NAME + "(" + ", ".join(f"{name}={message.get(name)!r}" for name in names(message)) + ")"


def missing(message, name):
    """Return the error that a message has no such field."""
    from nearest import hint  # noqa: PLC0415  it takes heap only where somebody is told

    return KeyError(f"{message.NAME} has no field {name}{hint(name, names(message))}")


def get(message, name):
    """Return a field, None for what is unknown; Message.get() describes it."""
    field = message._layout or lay_out(message)
    if name not in field:
        raise missing(message, name)
    field = field[name]
    if message.live:
        put_live(message, field)
    if field[2]:
        return known(message.wire, field)
    value = unpack_from(field[0], message.wire, field[1])[0]
    if field[3] and (value == field[3][0] or (value != value and is_unknown(value, field[3][0]))):  # noqa: PLR0124  NaN
        return None
    return value


def attribute(message, name):
    """Return a field, as an attribute: AttributeError, there is no such field."""
    if name not in (message._layout or lay_out(message)):
        name = _without_suffix(message, name, AttributeError)
    return get(message, name)


def assign(message, name, value):
    """Write a field, as an attribute: AttributeError, there is no such field, or the name is that of something else."""
    if name in _OWN or hasattr(_type(message), name):
        hint = f": the field is {name}_" if name in names(message) else ""
        raise AttributeError(f"{message.NAME}.{name} is no field{hint}")
    if name not in (message._layout or lay_out(message)):
        name = _without_suffix(message, name, AttributeError)
    message.set(name, value)


def _without_suffix(message, name, kind):
    """Return the field that is written with "_" behind it; an error of a kind: there is none."""
    if name[-1:] != "_" or name[:-1] not in layout(_type(message)):
        raise kind(missing(message, name).args[0])
    return name[:-1]


def raw(message, name):
    """Return a field as it stands on the wire."""
    field = message._layout or lay_out(message)
    if name not in field:
        raise missing(message, name)
    field = field[name]
    if message.live:
        put_live(message, field)
    return read(message.wire, field)


def set(message, name, field, value):  # noqa: A001  what a message calls it too
    """Write a field; Message.set() describes it."""
    before = _bytes(message.wire)
    try:
        write(message.wire, field, value)
    except Exception as error:
        message.wire[:] = before
        raise _of_field(message, name, error) from None


def update(message, values):
    """Write several fields, all of them or none: what Message.set() does, without a call for each."""
    layout = message._layout or lay_out(message)
    wire = message.wire
    before = _bytes(wire)
    kind_of = _type
    try:
        for name in values:  # items() would make a tuple of each
            value = values[name]
            form, offset, count, _, low, high = layout[name]
            if kind_of(value) is kind_of(low) and not count and low <= value <= high:
                pack_into(form, wire, offset, value)
            else:
                write(wire, layout[name], value)
    except KeyError:
        wire[:] = before
        update(message, _renamed(message, name, values))
        return
    except Exception as error:
        wire[:] = before
        raise _of_field(message, name, error) from None
    if message.live:
        for name in values:
            take_live(message, layout[name])


def _renamed(message, name, values):
    """Return the values with one of them by the name of its field."""
    field = _without_suffix(message, name, KeyError)
    return {(field if key == name else key): value for key, value in values.items()}


def _of_field(message, name, error):
    """Return the error that tells which field cannot carry its value."""
    return ValueError(f"{message.NAME}.{name} {error}") if isinstance(error, ValueError) else error


def forget(message):
    """Make every field unknown that can be, and write the defaults; this is kept with the class."""
    cls = type(message)
    fields = layout(cls)
    if cls not in _FORGOTTEN:
        payload = bytearray(message.LENGTH)
        for field in fields.values():
            if field[3]:
                write(payload, field, None)
        for name, value in message.DEFAULTS.items():
            write(payload, fields[name], value)
        _FORGOTTEN[cls] = bytes(payload)
    message.wire[:] = _FORGOTTEN[cls]
    if message.live:
        for field in fields.values():
            take_live(message, field)


def read(payload, field):
    """Return a number, a tuple for an array, text up to the first NUL for characters; bytes if they are not ASCII."""
    values = unpack_from(field[0], payload, field[1])
    if not field[2]:
        return values[0]
    if field[4] is None:
        text = values[0].split(b"\0")[0]
        return text.decode() if _is_ascii(text) else text
    return values


def known(payload, field):
    """Return what read() does of an array or of text, with None for what is unknown."""
    value = read(payload, field)
    sentinels = field[3]
    if not sentinels or field[4] is None:
        return value
    if _type(sentinels) is _bytes:
        sentinels = unpack_from(field[0], sentinels)
    pairs = zip(value, sentinels)  # noqa: B905  MicroPython has no strict
    found = tuple([None if a == b or (a != a and is_unknown(a, b)) else a for a, b in pairs])  # noqa: PLR0124  NaN
    speaking = len(sentinels) - field[2]
    return found if not speaking else None if found.count(None) == speaking else value


def write(payload, field, value):
    """Write a number, as many numbers as the array has, or ASCII text or bytes, filled up with NUL; None is unknown.

    ValueError: the field cannot carry the value; some elements of an array may be written all the same.
    """
    if value is None:
        value = _unknown(field)
    if field[4] is None:
        payload[field[1] : field[1] + field[2]] = _characters(value, field[2])
    elif field[2]:
        _put_elements(payload, field, value)
    else:
        _demand(field, value)
        pack_into(field[0], payload, field[1], value)


def _unknown(field):
    """Return the value of a field that means unknown."""
    form, _, count, sentinels, low, _ = field
    if not sentinels:
        raise ValueError("has no value for unknown")
    if _type(sentinels) is _bytes:
        return sentinels if low is None else unpack_from(form, sentinels)
    values = [sentinel or 0 for sentinel in sentinels[: count or 1]]
    return bytes(values) if low is None else values if count else values[0]


def _put_elements(payload, field, values):  # noqa: C901  a call takes as long as two elements
    form, at, count, sentinels, low, high = field
    kind_of = _type
    if kind_of(values) is not _list and kind_of(values) is not _tuple:
        values = _elements(values)
    length = _len(values)
    if length != count:
        raise ValueError(f"takes {count} values, not {length}")
    if sentinels and None in values:
        if kind_of(sentinels) is _bytes:
            payload[at : at + _len(sentinels)] = sentinels
            form, length, _, _ = _NUMBERS[form[-1]]
            for value in values:
                if value is not None:
                    if kind_of(value) is not kind_of(low) or not low <= value <= high:
                        _demand(field, value)
                    pack_into(form, payload, at, value)
                at += length
            return
        if _len(sentinels) == count:
            pairs = zip(values, sentinels)  # noqa: B905  as above
            values = [sentinel if element is None else element for element, sentinel in pairs]
    for value in values:
        if kind_of(value) is not kind_of(low) or not low <= value <= high:
            _demand(field, value)
    pack_into(form, payload, at, *values)


def _elements(value):
    try:
        return _list(value)
    except TypeError:
        raise ValueError(f"is an array and cannot be {value!r}") from None


def _demand(field, value):
    """Refuse a number that the field cannot carry."""
    low, high = field[4], field[5]
    if _type(value) is _type(low) and low <= value <= high:
        return
    code = field[0][-1]
    # MicroPython's struct wraps what is too large, and its bool is no kind of int.
    if not (_carries_float(code, value) if code in "fd" else isinstance(value, (int, bool)) and low <= value <= high):
        raise ValueError(f"cannot carry {value!r}")


def places(message, names):
    """Return what a message's image has to hold about its live fields; live_fields describes it."""
    return _live().places(message, names)


def take_live(message, field):
    """Read the live values of a field from the payload, as a frame that is received does."""
    _live().take(message, field)


def put_live(message, field):
    """Write the live values of a field into the payload, as a frame that is encoded has them."""
    _live().put(message, field)


def _live():
    global _live_fields  # noqa: PLW0603  as in message
    if _live_fields is None:
        import live_fields  # noqa: PLC0415  it takes heap only where there are any

        _live_fields = live_fields
    return _live_fields


def _sentinels(text, form, count):
    if not text:
        return ()
    number = float if form[-1] in "fd" else int
    if text[-1] in ":*":
        return (number(text[:-1]),) * (1 if text[-1] == ":" else count) + (None,) * count
    if "," in text:
        values = [number(part) if part else None for part in text.split(",")]
        return tuple(values + [None] * (count - len(values)))
    if form[-1] == "s":
        return bytes([number(text)] * count)
    return struct.pack("<" + form, *[number(text)] * count) if count else (number(text),)


def is_unknown(value, sentinel):
    """Tell whether a number is what the dialect has for unknown, None for nothing."""
    return value == sentinel or (sentinel is not None and value != value and sentinel != sentinel)  # noqa: PLR0124  NaN


def _characters(value, size):
    if isinstance(value, str):
        text = value.encode()
        if not _is_ascii(text):
            raise ValueError(f"cannot carry {value!r}: text is ASCII")
    elif isinstance(value, (bytes, bytearray)):
        text = bytes(value)
    else:
        raise ValueError(f"cannot carry {value!r}: neither text nor bytes")
    if len(text) > size:
        raise ValueError(f"takes up to {size} characters, not {len(text)}")
    return text + bytes(size - len(text))


def _is_ascii(text):
    return all(byte < 0x80 for byte in text)


def _carries_float(code, value):
    # CPython refuses what is too large, MicroPython makes it infinite.
    if not isinstance(value, (int, float, bool)):
        return False
    carried = bytearray(8)
    try:
        number = float(value)
        # A double carries whole numbers that are no float of a board.
        pack_into("<" + code, carried, 0, value if code == "d" else number)
    except OverflowError:
        return False
    carried = unpack_from("<" + code, carried)[0]
    return abs(carried) != _INFINITY or (isinstance(value, float) and abs(value) == _INFINITY)
