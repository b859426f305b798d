# Generated from specs/parameters.yaml: do not edit.
# Inputs: 740f6ca613b06785
"""Parameters of the vehicle, kept as whole steps so that arithmetic with them is exact."""

from conversion import to_steps

# name: (attribute, smallest, largest, numerator, denominator); steps * numerator / denominator is the value
_TABLE = {
    "BATT_VOLT_MULT": ("batt_volt_mult", 10000, 100000, 1, 10000),
    "SR0_EXTRA1": ("sr0_extra1", 0, 50, 1, 1),
}


class Parameters:
    """The parameters, at first with their defaults."""

    def __init__(self):
        # Pack voltage over the voltage at the ADC pin, set by the divider and calibrated against a meter.
        self.batt_volt_mult = 39500  # 3.95, in steps of 0.0001
        # Rate of the EXTRA1 stream; 0 switches it off.
        self.sr0_extra1 = 2  # 2 Hz

    def names(self):
        """Return the names in their order."""
        return sorted(_TABLE)

    def get(self, name):
        """Return the value of a parameter. KeyError: there is no such parameter."""
        return self.value(name, getattr(self, _TABLE[name][0]))

    def value(self, name, steps):
        """Return what so many steps of a parameter are worth."""
        return steps * _TABLE[name][3] / _TABLE[name][4]

    def set(self, name, value):
        """Take a value over, rounded to the nearest step; return whether it was accepted.

        Unknown names, NaN and values outside the limits change nothing.
        """
        if name not in _TABLE:
            return False
        attribute, smallest, largest, numerator, denominator = _TABLE[name]
        steps = to_steps(value, denominator, numerator)
        if steps is None or not smallest <= steps <= largest:
            return False
        setattr(self, attribute, steps)
        return True
