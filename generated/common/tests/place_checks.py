# Generated from templates/tests/program/place_checks.py: do not edit.
# Inputs: 31d2d93a70ae6ea1
"""The places that a port has for stations: each is of who is heard, and given away when others need it."""

from program_bench import main
from stations import Stations


class Known:
    """A station as the model of a check has it."""

    def __init__(self, number):
        self.number = number
        self.address = None
        self.is_heard = False
        self.heard_ms = 0


class Made:
    """A station as the places want it, with the number in which it was made; it counts how often it connects."""

    def __init__(self, number):
        self.number = number
        self.address = None
        self.is_heard = False
        self.heard_ms = 0
        self.streams = self
        self.connects = 0

    def connect(self):
        """Count it."""
        self.connects += 1


class Places:
    """A model of who is served at a port with four places: what Stations says of itself, in lists."""

    def __init__(self, home):
        self.home = home
        self.made = 0
        self.refused = 0
        self.connects = {}
        self.known = [self.new()]

    def new(self):
        """Return a new station."""
        self.made += 1
        return Known(self.made - 1)

    def hear(self, address, now_ms):
        """Return the number of the station that is heard, None where there is no place."""
        found = [each for each in self.known if each.address == address]
        if not found:
            free = [each for each in self.served() if each.address is None]
            if free:
                free[0].address = address
                found = free
            else:
                silent = min(self.known, key=lambda each: each.heard_ms)
                if len(self.known) == 4 and now_ms - silent.heard_ms < 3000:
                    self.refused += 1
                    return None
                self.put(self.new())
                found = self.known[-1:]
                found[0].address = address
        found[0].heard_ms = now_ms
        if not found[0].is_heard:
            found[0].is_heard = True
            self.connects[found[0].number] = self.connects.get(found[0].number, 0) + 1
            self.known = [each for each in self.known if each.address is not None]
        return found[0].number

    def put(self, station):
        """Give a station a place, that of who is silent for longest if there is no other one."""
        if len(self.known) == 4:
            self.known.remove(min(self.known, key=lambda each: each.heard_ms))
        self.known.append(station)

    def forget_silent(self, now_ms, silence_ms):
        """Serve nobody who is silent, but the declared address where nobody is left."""
        for each in [each for each in self.known if each.is_heard and now_ms - each.heard_ms >= silence_ms]:
            each.is_heard = False
            if not self.served() and self.home not in [known.address for known in self.known]:
                self.put(self.new())

    def served(self):
        """Return those who are served, in their order."""
        heard = [each for each in self.known if each.is_heard]
        return heard or [each for each in self.known if each.address in (None, self.home)][:1]


class Declared:
    """A port with a declared address."""

    def __init__(self, home):
        self.home = home


def places_are_of_who_is_heard():
    """Four of those who are heard are served, by lot over minutes, also where ticks start again: as a model says."""
    for home in (None, ("10.0.0.1", 1)):
        lot, model, made = 7, Places(home), []

        def make():
            made.append(Made(len(made)))  # noqa: B023
            return made[-1]  # noqa: B023

        stations = Stations(Declared(home), make, 5000)
        counts = [0] * 6
        now_ms = 0x3FFFFFFF - 400000
        for turn in range(1500):
            lot = lot * 1103515245 + 12345 & 0x3FFFFFFF
            steps = (1, 70, 400, 990, 2999, 1, 5001, 10) if turn // 50 % 2 else (1000, 500, 500, 0, 0, 1500, 0, 5000)
            now_ms += steps[lot >> 20 & 7]
            if turn % 3 == 2:
                stations.forget_silent(now_ms & 0x3FFFFFFF)
                model.forget_silent(now_ms, 5000)
            else:
                address = ("10.0.0." + str(1 + (lot >> 10 & 0xFF) % (6 if turn // 100 % 2 else 4)), 1)
                found = stations.hear(address, now_ms & 0x3FFFFFFF)
                expected = model.hear(address, now_ms)
                assert (found and found.number) == expected, (turn, address, found and found.number, expected)
                assert found is None or (found.address, found.heard_ms) == (address, now_ms & 0x3FFFFFFF)
            served = model.served()
            assert [each.number for each in stations.served] == [each.number for each in served], turn
            assert [each.address for each in stations.served] == [each.address for each in served], turn
            assert (stations.refused, len(made)) == (model.refused, model.made), turn
            counts[len(served) if served[0].is_heard else 0] += 1
        assert [each.connects for each in made] == [model.connects.get(number, 0) for number in range(len(made))]
        assert model.refused > 5, model.refused
        assert min(counts[:5]) > 5, counts


CHECKS = ((places_are_of_who_is_heard, "services.stations"),)

if __name__ == "__main__":
    main(CHECKS)
