"""The names of the clocks that the firmware counts."""

CLOCK = "clock"
"""The component of the state that tables reach by ``{clock: boot}`` and ``{clock: unix}``."""
BOOT, UNIX = "boot", "unix"
SYSTEM_TIME = "SYSTEM_TIME"
"""The message by which ground stations say the time since 1970, where a table has it."""
