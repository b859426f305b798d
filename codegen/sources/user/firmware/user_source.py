"""A sensor that a class of the user's code reads: its read() returns a number, or a tuple of them, or None."""

from array import array

from conversion import to_steps
from polling import UNKNOWN, Fault


class UserSource:
    """The class `name` of a module, made without arguments.

    `scales` has numerator and denominator of the steps in one unit of each number, `limits` the fewest and the most
    steps that can be: what lies beyond is unknown.
    """

    def __init__(self, module, name, scales, limits):
        self.values = array("i", [UNKNOWN] * len(scales))
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
        if len(self.values) == 1:
            self._put(0, found)
        elif found is None:
            for at in range(len(self.values)):
                self.values[at] = UNKNOWN
        else:
            if len(found) != len(self.values):
                raise Fault(f"read() gave {len(found)} numbers, not {len(self.values)}")
            for at in range(len(self.values)):
                self._put(at, found[at])
        return True

    def _put(self, at, value):
        scale = self._scales[at]
        steps = to_steps(value, scale[0], scale[1])
        limits = self._limits[at]
        self.values[at] = UNKNOWN if steps is None or not limits[0] <= steps <= limits[1] else steps
