# Generated from templates/firmware/program/stations.py: do not edit.
# Inputs: 06331de9c12d2c91
"""The stations at the other end of a port that tells them apart by their addresses."""

import time

from micropython import const

_MOST = const(4)
_GONE_MS = const(3000)  # a station that is silent for so long makes room where others wait


class Stations:
    """The stations that are served, in `served`: the declared address while none is heard, and else those heard.

    A station is heard while its frames arrive, and gone after `silence_ms`. It is remembered until its place is needed,
    so that it finds the rates that it has asked for when it comes back. `make` returns a new Station, `port` has the
    declared address as its `home`.
    """

    def __init__(self, port, make, silence_ms):
        self._port = port
        self._make = make
        self._silence_ms = silence_ms
        self.served = [make()]
        self._known = [self.served[0]]
        self.refused = 0  # frames of those for whom there is no place

    def hear(self, address, now_ms):
        """Return the station with an address that a frame came from; None: there is no place for it."""
        station = self._find(address) or self._add(address, now_ms)
        if station is None:
            self.refused += 1
            return None
        station.heard_ms = now_ms
        if not station.is_heard:
            station.is_heard = True
            station.streams.connect()
            self._serve_heard()
        return station

    def forget_silent(self, now_ms):
        """Serve nobody any more who is silent, and the declared address if there is nobody else."""
        for station in self._known:
            if station.is_heard and time.ticks_diff(now_ms, station.heard_ms) >= self._silence_ms:
                station.is_heard = False
                self._serve_heard()

    def _serve_heard(self):
        self.served[:] = [station for station in self._known if station.is_heard]
        if self.served:
            self._known = [station for station in self._known if station.address is not None]
        else:
            self.served.append(self._find(self._port.home) or self._put(self._make()))

    def _find(self, address):
        for station in self._known:
            if station.address == address:
                return station
        return None

    def _add(self, address, now_ms):
        """Return the station that gets an address, None if there are enough others."""
        station = self.served[0]
        if station.address is not None:  # else it is the declared one, which becomes that of who answers
            if len(self._known) == _MOST and time.ticks_diff(now_ms, self._oldest().heard_ms) < _GONE_MS:
                return None
            station = self._put(self._make())
        station.address = address
        return station

    def _put(self, station):
        """Remember a station, and forget who is silent for longest if there is no other place."""
        if len(self._known) == _MOST:
            self._known.remove(self._oldest())
        self._known.append(station)
        return station

    def _oldest(self):
        oldest = self._known[0]
        for station in self._known:
            if time.ticks_diff(station.heard_ms, oldest.heard_ms) < 0:
                oldest = station
        return oldest
