"""A sensor that a class of the user's code reads: its read() returns a number, or a tuple of them, or None."""

from array import array

from conversion import LARGEST, to_steps
from polling import UNKNOWN, Fault

_MOST = 0x100000000  # steps that are rounded before they are compared with the limits


class UserSource:
    """The class `name` of a module, made without arguments.

    `scales` has numerator and denominator of the steps in one unit of each number, `limits` the fewest and the most
    steps that can be: what lies beyond is unknown. A number that needs more than a small integer has two of `values`:
    its halves of 16 bits, the low one first.
    """

    def __init__(self, module, name, scales, limits):
        self._places = []  # of the first value of each number
        count = 0
        for low, high in limits:
            self._places.append(count)
            count += 2 if high > LARGEST or low < -LARGEST else 1
        self.values = array("i", [UNKNOWN] * count)
        self._module = module
        self._name = name
        self._scales = scales
        self._limits = limits
        self._read = None

    def begin(self):
        """Make a new object of the class."""
        module = __import__(self._module, None, None, [self._name])
        self._read = getattr(module, self._name)().read

    def poll(self, _now_ms):
        """Read it; what is None, NaN or beyond its limits is unknown."""
        found = self._read()
        count = len(self._scales)
        if count == 1:
            self._put(0, found)
        elif found is None:
            for at in range(len(self.values)):
                self.values[at] = UNKNOWN
        else:
            if len(found) != count:
                raise Fault(f"read() gave {len(found)} numbers, not {count}")
            for at in range(count):
                self._put(at, found[at])
        return True

    def _put(self, at, value):
        scale = self._scales[at]
        low, high = self._limits[at]
        place = self._places[at]
        steps = to_steps(value, scale[0], scale[1], _MOST)
        if steps is None or not low <= steps <= high:
            self.values[place] = UNKNOWN
        elif high > LARGEST or low < -LARGEST:
            self.values[place] = steps & 0xFFFF
            self.values[place + 1] = steps >> 16 & 0xFFFF
        else:
            self.values[place] = steps
