"""The checksum and the frame around a payload in plain Python: for CPython and ports without native code.

Does exactly what crc_viper does.
"""


def update(crc, table, data, start, end):
    """Return `crc` carried on over data[start:end]."""
    for index in range(start, end):
        crc = table[(crc ^ data[index]) & 0xFF] ^ (crc >> 8)
    return crc


def write_frame(crc, table, payload, frame, header, length, sequence, message_id, extra):
    """Write what changes from frame to frame, in MAVLink 2 (10 bytes of header) or MAVLink 1 (6 bytes).

    That is the length, the sequence number, the message id, payload[:length] and the checksum over all but the first
    byte, with CRC_EXTRA at its end. Returns the length of the payload: MAVLink 2 leaves out zeros at the end of it,
    but never the first byte.
    """
    if header == 10:
        while length > 1 and payload[length - 1] == 0:
            length -= 1
        frame[4] = sequence
        frame[7] = message_id & 0xFF
        frame[8] = (message_id >> 8) & 0xFF
        frame[9] = message_id >> 16
    else:
        frame[2] = sequence
        frame[5] = message_id
    frame[1] = length
    for index in range(1, header):
        crc = table[(crc ^ frame[index]) & 0xFF] ^ (crc >> 8)
    for index in range(length):
        byte = payload[index]
        frame[header + index] = byte
        crc = table[(crc ^ byte) & 0xFF] ^ (crc >> 8)
    crc = table[(crc ^ extra) & 0xFF] ^ (crc >> 8)
    frame[header + length] = crc & 0xFF
    frame[header + length + 1] = crc >> 8
    return length
