"""Parameters of the vehicle that the services are tested with: every case that the protocol knows, in few rows."""

import dialect

# name: (type, default, smallest, largest, step, after a restart)
_TABLE = {
    "BATT_CAPACITY": (dialect.MAV_PARAM_TYPE_INT32, 3300, 0, 100000, 1, False),
    "BATT_LOW_VOLT": (dialect.MAV_PARAM_TYPE_REAL32, 10.5, 0, 60, 0.01, False),
    "BATT_VOLT_MULT": (dialect.MAV_PARAM_TYPE_REAL32, 3.95, 1, 10, 0.0001, True),
    "NAME_OF_SIXTEEN_": (dialect.MAV_PARAM_TYPE_INT8, -5, -128, 127, 1, False),
    "SR0_EXTRA1": (dialect.MAV_PARAM_TYPE_INT16, 2, 0, 50, 1, False),
}
NAMES = tuple(sorted(_TABLE))
COUNT = len(NAMES)


class Parameters:
    """Values by name, with the checks of the rendered module."""

    def __init__(self):
        self.changes = 0
        self._values = {name: _TABLE[name][1] for name in NAMES}

    def get(self, name):
        """Return the value in force."""
        return self._values[name]

    def set(self, name, value):
        """Take a value over, rounded to its step; return whether it was accepted."""
        if name not in _TABLE or value is None:
            return False
        smallest, largest = self.limits(name)
        if not smallest <= value <= largest:
            return False
        step = _TABLE[name][4]
        value = round(value / step) * step
        self.changes += value != self._values[name]
        self._values[name] = value
        return True

    def limits(self, name):
        """Return the smallest and the largest value."""
        return _TABLE[name][2], _TABLE[name][3]

    def type_of(self, name):
        """Return the MAV_PARAM_TYPE."""
        return _TABLE[name][0]

    def is_after_reboot(self, name):
        """Tell whether a new value counts from the next start."""
        return _TABLE[name][5]


def name_of(index):
    """Return the name with an index."""
    return NAMES[index]


def index_of(name):
    """Return the index of a name, None if there is none."""
    return NAMES.index(name) if name in NAMES else None


def facts_of(_name):
    """Return the numbers in the line of a parameter: there are no values that are not all within the limits."""
    return []
