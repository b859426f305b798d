# Generated from templates/firmware/crc_table.py: do not edit.
# Inputs: b9ff355ddcd9a4a5
"""The table of CRC-16/MCRF4XX, one 16 bit entry for each value of a byte (512 bytes of memory)."""

from array import array


def _spread(byte):
    """Divide by the polynomial 0x8408 (x^16 + x^12 + x^5 + 1, bits reflected), eight steps at once."""
    return (byte << 8) ^ (byte << 3) ^ (byte >> 4)


def is_entry(value):
    """Tell whether a value of 16 bits is in the table: its high byte says which entry it would have to be."""
    high = value >> 8
    return value == _spread(high ^ (high >> 5))


TABLE = array("H", [_spread(byte ^ ((byte << 4) & 0xFF)) for byte in range(256)])
