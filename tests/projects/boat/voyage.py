"""Runs the boat's firmware, in `generated` of the folder that it is started in, and prints the frames as JSON.

`voyage.py` prints {name: frame as hexadecimal digits, or null where it is withheld}. test_boat.py knows what is right.
"""

import json
import sys

sys.path[:0] = ["generated/firmware", "generated/mocks"]

import mock_time  # noqa: E402

mock_time.install()
import telemetry  # noqa: E402
from mavlink import Link  # noqa: E402
from state import SystemState  # noqa: E402

frames = {}
link = Link(None)


def launched():
    """Return the state of a boat that nobody has told anything."""
    mock_time.set_ticks_us(0)
    return SystemState(log=lambda *_: None)


def tell(name, encode, state):
    """Keep the frame that goes out now."""
    frame = encode(link, state)
    frames[name] = None if frame is None else bytes(frame).hex()


def pass_ms(duration):
    """Let time pass."""
    mock_time.advance_us(duration * 1000)


def position(state):
    """Set all that GPS_RAW_INT needs."""
    gps = state.gps
    gps.lat_dege7, gps.lon, gps.alt, gps.ellipsoid, gps.accuracy = -353632621, 139.69, 12.5, -33.25, 1.75


def sail():
    """Positions: exact, at and beyond the limits, unknown, old."""
    state, encode = launched(), telemetry.encode_gps_raw_int
    gps = state.gps
    tell("nothing known", encode, state)
    state.clock.boot_us = 1000000
    position(state)
    tell("position", encode, state)
    gps.fix, gps.hdop, gps.speed, gps.course, gps.satellites = 3, 1.2, 2.57, 359.99, 17
    tell("under way", encode, state)
    state.clock.boot_us = 1790000000123456
    gps.lon, gps.lat, gps.alt_mm, gps.ellipsoid_mm = -179.9999999, 89.9999999, -2000000000, 2147483647
    gps.accuracy_mm, gps.hdop, gps.speed, gps.course, gps.satellites = 4294967295, 700, 700, 360, 255
    tell("at the limits", encode, state)
    gps.lon, gps.lat = 180.5, -1000
    tell("beyond the earth", encode, state)
    position(state)
    gps.hdop = gps.speed = gps.course = gps.satellites = None
    tell("no receiver", encode, state)
    for name in ("lat", "lon", "alt", "ellipsoid", "accuracy"):
        position(state)
        setattr(gps, name, None)
        tell("without " + name, encode, state)
    position(state)
    gps.satellites = 9
    pass_ms(2000)
    tell("after 2 s", encode, state)
    pass_ms(1)
    tell("after more than 2 s", encode, state)
    position(state)
    tell("again", encode, state)
    state.clock.boot_us = 2**64 - 1
    pass_ms(1)
    tell("when the clock begins again", encode, state)


def roll():
    """Angles as floats, the end of the milliseconds."""
    state, encode = launched(), telemetry.encode_attitude
    attitude = state.attitude
    state.clock.boot_us = 4294967295999
    attitude.roll, attitude.pitch, attitude.yaw = 0.1, -0.6, 3.5
    attitude.roll_speed, attitude.pitch_speed = 1e-30, -1e30
    tell("without a rate", encode, state)
    attitude.yaw_speed = 16777217.0
    tell("attitude", encode, state)
    pass_ms(1)
    attitude.roll = -7
    tell("capsized, a millisecond later", encode, state)
    pass_ms(1001)
    tell("no attitude for a second", encode, state)


def sound():
    """Depths, rounded and limited."""
    state, encode = launched(), telemetry.encode_distance_sensor
    sounder = state.sounder
    tell("no depth", encode, state)
    sounder.depth = 12.345
    tell("depth", encode, state)
    sounder.variance, sounder.quality = 25, 0
    state.parameters.sndr_max = 2050
    sounder.depth = 120
    tell("too deep", encode, state)
    sounder.depth, sounder.quality, sounder.variance = 0.2, 101, 40
    tell("aground", encode, state)
    pass_ms(3001)
    tell("no echo for three seconds", encode, state)


def blow():
    """The wind, once it is known when it blows."""
    state, encode = launched(), telemetry.encode_wind_cov
    state.wind.north, state.wind.east = 3.5, -0.1
    tell("no time", encode, state)
    state.clock.unix_us = 1790000000000000
    pass_ms(2500)
    state.wind.east = 0.1
    tell("wind", encode, state)
    pass_ms(501)
    tell("half of the wind", encode, state)


def steer():
    """Tell the requests of the remote control, and their end."""
    state, encode = launched(), telemetry.encode_rc_channels
    remote = state.remote
    tell("no remote control", encode, state)
    remote.channels, remote.steering, remote.throttle, remote.mode, remote.rssi = 8, 1500, 3000, 0, 255
    tell("remote control", encode, state)
    pass_ms(500)
    remote.throttle = 1100
    remote.rssi = None
    pass_ms(1)
    tell("one stick", encode, state)


def name():
    """The two named values do not wait for each other."""
    state = launched()
    state.helm.angle = -12.5
    tell("rudder", telemetry.encode_rudder, state)
    tell("no bilge", telemetry.encode_bilge_water, state)
    state.bilge.level, state.helm.angle = 0.1, 50
    tell("bilge", telemetry.encode_bilge_water, state)
    tell("hard over", telemetry.encode_rudder, state)
    pass_ms(1001)
    tell("no rudder for a second", telemetry.encode_rudder, state)


for leg in (sail, roll, sound, blow, steer, name):
    leg()
sys.stdout.write(json.dumps(frames))
