# Generated from templates/firmware/crc.py: do not edit.
# Inputs: 93954959dcc4db5d
"""MAVLink's checksum, CRC-16/MCRF4XX, in the fastest form that this interpreter can run.

CPython has no module `micropython` (ImportError), a port without native code cannot compile viper (SyntaxError) and
refuses a compiled crc_viper.mpy (ValueError): they take the plain form.
"""

from crc_table import TABLE, is_entry

try:
    from crc_viper import update, write_frame
except (ImportError, SyntaxError, ValueError):
    from crc_plain import update, write_frame

__all__ = ("START", "TABLE", "is_entry", "update", "write_frame")

START = 0xFFFF
