"""The boat's own code: what the sensors say put together, the helm, the way back, the pump and the lights."""

import time
from math import atan2, cos, pi, sin

from vehicle import Vehicle

MANUAL, HOLD, RTL = 0, 4, 11
AMIDSHIPS_US = STOP_US = 1500
HALF_US = 500  # from the middle to either end
HALF_SPEED_US = 1700
_RADIANS = pi / 180
_METRES = 0.0111319  # of one 1e-7 degree of latitude
_THERE_M = 5


class Boat(Vehicle):
    """The generated program with what only this boat has."""

    home = None  # latitude and longitude in 1e-7 degrees, where the boat was armed
    pump_since_ms = None
    pump_ms = 0
    lights_percent = 0

    def measure(self):
        """Make of speed, course and felt wind what is sent: 10 times per second."""
        gps, motion, wind, heading = self.state.gps, self.state.motion, self.state.wind, self.state.attitude.heading
        if gps.speed is None or gps.course is None:
            motion.north = motion.east = wind.north = wind.east = None
            return
        motion.north = gps.speed * cos(gps.course * _RADIANS)
        motion.east = gps.speed * sin(gps.course * _RADIANS)
        if wind.speed is None or wind.angle is None or heading is None:
            wind.north = wind.east = None
            return
        felt_from = (heading + wind.angle) * _RADIANS
        wind.north = motion.north - wind.speed * cos(felt_from)
        wind.east = motion.east - wind.speed * sin(felt_from)

    def control(self):
        """Move rudder and motor, 50 times per second; what nobody asks for stands still."""
        vehicle, helm = self.state.vehicle, self.state.helm
        rudder, throttle = self._wanted() if vehicle.mode_number != RTL else self._homeward()
        if throttle is None or vehicle.mode_number == HOLD or not self.is_armed:
            throttle = STOP_US
        helm.rudder_us = AMIDSHIPS_US if rudder is None else min(2000, max(1000, rudder))
        helm.throttle_us = min(2000, max(1000, throttle))

    def _wanted(self):
        """Return what the channels ask for, else the stick: pulses in us for rudder and motor, None for nothing."""
        rc, stick = self.state.rc, self.state.stick
        rudder, throttle = rc.rudder_us, rc.throttle_us
        if rudder is not None or throttle is not None:
            return rudder, throttle
        turn, ahead = stick.turn_number, stick.ahead_number
        return (
            None if turn is None else AMIDSHIPS_US + turn * HALF_US // 1000,
            None if ahead is None else STOP_US + ahead * HALF_US // 1000,
        )

    def _homeward(self):
        """Return the pulses that bring the boat to where it was armed; None for both when it is there, or lost."""
        gps, heading = self.state.gps, self.state.attitude.heading
        lat, lon = gps.lat_dege7, gps.lon_dege7
        if self.home is None or lat is None or lon is None or heading is None:
            return None, None
        north = (self.home[0] - lat) * _METRES
        east = (self.home[1] - lon) * _METRES * cos(self.home[0] * 1e-7 * _RADIANS)
        if north * north + east * east < _THERE_M * _THERE_M:
            return None, None
        wrong = (atan2(east, north) / _RADIANS - heading + 540) % 360 - 180  # degrees to starboard
        return AMIDSHIPS_US + int(wrong * HALF_US / 90), HALF_SPEED_US

    def check_arming(self):
        """Return why the boat must not set out: it has to know where it comes back to."""
        if self.state.gps.lat_dege7 is None:
            return "Position unknown"
        return None

    def on_arm(self):
        """Remember where home is."""
        self.home = (self.state.gps.lat_dege7, self.state.gps.lon_dege7)

    def stop_motors(self):
        """Stop the propeller: control() has failed, or the program ends."""
        self.state.helm.throttle_us = STOP_US

    def pump(self, duration):
        """Begin to pump for so many seconds (MAV_CMD_USER_1)."""
        self.state.bilge.pumping = True
        self.pump_since_ms = time.ticks_ms()
        self.pump_ms = int(duration * 1000)

    def pump_progress(self):
        """Return how far it is in per cent, None at the end."""
        passed_ms = time.ticks_diff(time.ticks_ms(), self.pump_since_ms)
        if passed_ms < self.pump_ms:
            return 100 * passed_ms // self.pump_ms
        self.state.bilge.pumping = False
        return None

    def pump_cancel(self):
        """Stop the pump before its time (COMMAND_CANCEL)."""
        self.state.bilge.pumping = False

    def set_lights(self, level):
        """Set the lights, in per cent (MAV_CMD_USER_2)."""
        self.lights_percent = level
