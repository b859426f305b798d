"""Converts fields back into numbers, names and texts. None is unknown throughout."""

TURN = 1 << 30  # ticks_ms() starts again after so many milliseconds, 12.4 days
MOST_ELEMENTS = 256  # messages count them in a byte
_HALF = TURN >> 1


def elapsed(now_ms, then_ms):
    """Return the milliseconds from one time to another, 0 if it lies ahead; right up to six days.

    time.ticks_ms() of a board starts again, clocks of a host do not: this rule holds for both.
    """
    difference = ((now_ms - then_ms + _HALF) & (TURN - 1)) - _HALF
    return difference if difference > 0 else 0


def scaled(value, numerator, denominator):
    """Return a number in another unit."""
    return None if value is None else value * numerator / denominator


def plausible(value, low, high):
    """Return a number that lies within limits, each of which may be None: what nothing can be is unknown."""
    if value is None or (low is not None and value < low) or (high is not None and value > high):
        return None
    return value


def element(values, index):
    """Return one element of an array, which may be unknown as a whole."""
    return None if values is None else values[index]


def joined(values, first, count, unused):
    """Return the sum of elements up to the first one that is not in use: a value that was spread over them."""
    if values[first] == unused:
        return None
    total = 0
    for index in range(first, first + count):
        if values[index] == unused:
            break
        total += values[index]
    return total


def added(first, second):
    """Return the sum of what two fields hold; the second one alone says nothing."""
    return None if first is None else first + (second or 0)


def values_of(values, first, count, unused, numerator, denominator, keep=False):
    """Return single values in another unit, as a tuple: up to the first one that is not in use, or with gaps."""
    found = []
    for index in range(first, first + count):
        if values[index] != unused:
            found.append(values[index] * numerator / denominator)
        elif keep:
            found.append(None)
        else:
            break
    return tuple(found)


def single(values, full):
    """Return single values; None if there is none, or if one goes on in the next: then they are one value."""
    return None if not values or full in values[:-1] else values


def page(first, values):
    """Return the values of a page by the number of the first one; none where nothing has so many."""
    return {first: values} if first < MOST_ELEMENTS else {}


def finite(said):
    """Make everything unknown in what a message said that is infinite, or no number."""
    for name, value in said.items():
        if isinstance(value, float) and value - value != 0:
            said[name] = None
    return said


def text(value):
    """Return a text up to its first NUL; an empty one says nothing. What is not UTF-8 comes as bytes."""
    if isinstance(value, tuple):
        end = value.index(0) if 0 in value else len(value)
        value = bytes(value[:end])
    if isinstance(value, bytes):
        try:
            return str(value, "utf-8") or None
        except ValueError:
            return value
    return value or None


def entry(names, value):
    """Return the name of a number, or the number itself where the dialect has none for it."""
    return value if value is None else names.get(value, value)


def flags(names, value):
    """Return the names of the bits that are set, as a tuple; what has no name comes as one hexadecimal number."""
    if value is None:
        return None
    found = []
    rest = value
    for bits, name in names:
        if value & bits == bits:
            found.append(name)
            rest &= ~bits
    if rest:
        found.append(hex(rest))
    return tuple(found)


def is_entry(value, number):
    """Return whether a number is this one; enums keep 0 for what is not defined."""
    return None if not value else value == number


def is_set(value, bits):
    """Return whether all of the bits are set."""
    return None if value is None else value & bits == bits
