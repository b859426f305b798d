# Generated from templates/codec/checksum.py: do not edit.
# Inputs: 1f5524b27d9f6edc
"""The table of MAVLink's checksum, CRC-16/MCRF4XX."""

from array import array

# Entry 256 + n carries a byte n on over one step, entry n over two: so two bytes take two look-ups and no shift.
TABLE = array("H", bytes(1024))  # 512 zeros; a list of them is a large piece of a heap that is in use
for _byte in range(256):
    # Divided by the polynomial 0x8408 (x^16 + x^12 + x^5 + 1, bits reflected), eight steps at once.
    _spread = _byte ^ ((_byte << 4) & 0xFF)
    TABLE[256 + _byte] = (_spread << 8) ^ (_spread << 3) ^ (_spread >> 4)
for _byte in range(256):
    TABLE[_byte] = TABLE[256 + (TABLE[256 + _byte] & 0xFF)] ^ (TABLE[256 + _byte] >> 8)
