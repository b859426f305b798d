"""The boat's own code: what its sensors say. Here it goes around a buoy, so that there is something to see."""

from math import cos, pi, sin

from vehicle import Vehicle

GPS_FIX_TYPE_3D_FIX = 3
BUOY_LAT, BUOY_LON = 54.3233, 10.1394
RADIUS_M = 50.0
METRES_OF_A_DEGREE = 111320.0


class Boat(Vehicle):
    """The generated program with the boat's sensors."""

    angle = 0.0

    def measure(self):
        """Called 10 times per second: read the sensors here, and set what they say."""
        self.angle = (self.angle + 0.02) % (2 * pi)  # once around in half a minute
        gps, attitude = self.state.gps, self.state.attitude
        gps.fix = GPS_FIX_TYPE_3D_FIX
        gps.lat = BUOY_LAT + RADIUS_M * cos(self.angle) / METRES_OF_A_DEGREE
        gps.lon = BUOY_LON + RADIUS_M * sin(self.angle) / METRES_OF_A_DEGREE / 0.583
        gps.alt = 0.4
        gps.hdop = 0.9
        gps.satellites = 11
        attitude.roll = -0.1
        attitude.pitch = 0.02 * sin(8 * self.angle)
        attitude.yaw = self.angle + pi / 2 if self.angle < pi / 2 else self.angle - 3 * pi / 2
        attitude.yaw_speed = 0.2
        self.state.sounder.depth = 6.0 + 2 * cos(self.angle)
