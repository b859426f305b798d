"""The names of the clocks that the firmware counts."""

CLOCK = "clock"
"""The component of the state that tables reach by ``{clock: boot}`` and ``{clock: unix}``."""
BOOT, UNIX = "boot", "unix"
