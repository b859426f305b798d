"""The sensor of angles, a BNO055 on the I2C bus, which finds its attitude itself."""

from math import pi

from machine import I2C, Pin

_ADDRESS = 0x28
_CHIP_ID, _IS_BNO055 = 0x00, 0xA0
_MODE, _NINE_AXES = 0x3D, b"\x0c"
_GYRO_Z = 0x18  # 1/16 degree per second; then the angles in 1/16 degree: heading, roll, pitch
_DEGREES = 1 / 16
_RADIANS = pi / 180 / 16


class Imu:
    """Reads angles and yaw rate; `sources: imu` of specs/board.yaml asks for them."""

    def __init__(self):
        self._bus = I2C(0, sda=Pin(21), scl=Pin(22), freq=400000)
        if self._bus.readfrom_mem(_ADDRESS, _CHIP_ID, 1)[0] != _IS_BNO055:
            raise OSError("no BNO055")
        self._bus.writeto_mem(_ADDRESS, _MODE, _NINE_AXES)
        self._read = bytearray(8)

    def read(self):
        """Return roll, pitch and yaw in radians, the heading in degrees and the yaw rate in radians per second."""
        read = self._read
        self._bus.readfrom_mem_into(_ADDRESS, _GYRO_Z, read)
        heading = _signed(read, 2) % 5760
        yaw = heading - 5760 if heading > 2880 else heading
        return (
            _signed(read, 4) * _RADIANS,
            _signed(read, 6) * _RADIANS,
            yaw * _RADIANS,
            heading * _DEGREES,
            -_signed(read, 0) * _RADIANS,  # its axis points up, that of MAVLink down
        )


def _signed(read, at):
    number = read[at] | read[at + 1] << 8
    return number - 0x10000 if number & 0x8000 else number
