"""The stations at the other ends of TCP connections: one for each, from its beginning to its end."""


class TcpStations:
    """The stations that are served, in `served`: one for each peer of a port; without a peer, one that has no address.

    A station that asks nothing gets what is sent, as one at the declared address of a UDP port does. `make` returns a
    new Station; `refused` stays 0: a connection for which there is no place is closed by the port.
    """

    def __init__(self, port, make, _silence_ms):
        self._make = make
        self.served = [make()]
        self.refused = 0
        port.listed = self

    def hear(self, peer, now_ms):
        """Return the station of a peer that a frame came from; None: it is there no more."""
        for station in self.served:
            if station.address is peer:
                station.heard_ms = now_ms
                if peer is not None:
                    peer.heard_ms = now_ms
                    peer.is_heard = True
                return station
        return None

    def join(self, peer):
        """Serve a new peer; return whether the one without an address became it."""
        station = self.served[0]
        is_first = station.address is None
        if not is_first:
            station = self._make()
            self.served.append(station)
        station.address = peer
        station.streams.connect()
        return is_first

    def leave(self, peer):
        """Serve a peer no more."""
        self.served[:] = [station for station in self.served if station.address is not peer]
        if not self.served:
            self.served.append(self._make())

    def forget_silent(self, _now_ms):
        """Forget nobody: the port closes the connection of who is silent."""
