# ruff: noqa: T201  what is printed is the answer
"""Hours of the rover's program with stations that come, go, move and ask, and bytes that nobody asked for.

Arguments: simulated hours, in how many of them the heap settles, the seed of the bytes, the seconds of an hour. Under
MicroPython, with the firmware, the mocks and the generated tests on its path. It prints a line of JSON for each hour,
and what went wrong.
"""

import gc
import json
import sys

import dialect
from program_bench import SECOND_US, TURN_MS_US, id_of, messages, new_craft, run, sequence_of
from program_facts import MESSAGES, PARAMETERS
from station_checks import HOME, Air, Scene, address

HOURS, SETTLED, SEED, HOUR_S = (int(argument) for argument in sys.argv[1:])
FIRST, SECOND, GUEST = 1, 2, 3  # stations that stay, and one that comes and goes
STRANGER = 66  # sends what is no message
ROAMING = (10, 40)  # addresses of one that moves on every ten minutes
BURST = 170  # bytes of the stranger every ten seconds: some ten million in a week
CAPACITY = "BATT_CAPACITY"  # set every minute
GUEST_S = (600, 1800)  # of each hour the seconds in which the guest is there


class Late(Scene):
    """The same, but the board has started so many microseconds before."""

    def __init__(self, at_us):
        self.air = Air()
        self.craft = new_craft(ports=[self.air], at_us=at_us)
        self.stations = {}


class Soak:
    """The vehicle, its stations, and what was counted in the hour at hand."""

    def __init__(self):
        self.scene = Late(max(0, TURN_MS_US - HOURS * HOUR_S * SECOND_US // 2))
        self.craft = self.scene.craft
        self.faults = []
        self.random = SEED or 1
        self.last = {}  # of each station that stays the number of its last frame
        self.counts = {}
        self.listed = set()  # names of the parameters that the guest got

    def fail(self, *words):
        """Note what is wrong, a few times."""
        if len(self.faults) < 20:
            self.faults.append(" ".join([str(word) for word in words]))

    def drawn(self, most):
        """Return a number of a simple generator, below `most`."""
        self.random = (self.random * 1103515245 + 12345) & 0x3FFFFFFF
        return (self.random >> 8) % most

    def hostile(self):
        """Return bytes that are no message: random ones, among them starts of frames, and a frame with a wrong byte."""
        scene = self.scene
        frame = bytearray(scene.station(FIRST).link.encode(messages.Ping(unknown=False)))
        frame[self.drawn(len(frame) - 1) + 1] ^= 1 + self.drawn(255)
        noise = bytearray(BURST - len(frame))
        for at in range(len(noise)):
            noise[at] = (0xFD, 0xFE, 0xFF)[self.drawn(3)] if self.drawn(8) == 0 else self.drawn(256)
        return bytes(noise) + bytes(frame)

    def second(self, index):
        """Let a second of the hour pass, and look at what came back."""
        scene = self.scene
        minute, second = index // 60, index % 60
        present = [FIRST, SECOND]
        if GUEST_S[0] <= index < GUEST_S[1]:
            present.append(GUEST)
        for number in present:
            scene.beat(number)
        roaming = scene.station(ROAMING[0] + minute // 10 % ROAMING[1], 7)
        roaming.send(messages.Heartbeat, type=dialect.MAV_TYPE_GCS, autopilot=dialect.MAV_AUTOPILOT_INVALID)
        if index % 10 == 5:
            scene.air.arrived.append((address(STRANGER), self.hostile()))
        if index == GUEST_S[0] + 5:
            scene.station(GUEST).send(messages.ParamRequestList)
        if second == 20:
            scene.station(FIRST).send(messages.Ping, target_system=0, target_component=0, seq=minute)
        if second == 40:
            scene.station(SECOND).send(messages.ParamSet, param_id=CAPACITY, param_value=3000 + minute % 2)
        run(self.craft, SECOND_US)
        self.look()

    def look(self):
        """Count the frames that came, by station and message, and note gaps in their numbers."""
        taken = self.scene.air.taken
        for number in (FIRST, SECOND):
            for frame in taken.get(address(number), ()):
                sequence = sequence_of(frame)
                if number in self.last and sequence != (self.last[number] + 1) & 0xFF:
                    self.fail("a gap in the frames for", number, "from", self.last[number], "to", sequence)
                self.last[number] = sequence
                key = number, id_of(frame)
                self.counts[key] = self.counts.get(key, 0) + 1
        for frame in taken.get(address(GUEST), ()):
            if id_of(frame) == messages.ParamValue.ID:
                self.listed.add(bytes(frame[18:34]))
        if address(STRANGER) in taken or HOME in taken:
            self.fail("somebody is answered whom nobody heard")
        self.scene.air.taken = {}

    def check_rate(self, number, message, rate, instances):
        """Note where a stream came at another rate than its own, of each of the instances that are on."""
        count = self.counts.get((number, message), 0)
        turns = [of for of in range(instances + 1) if abs(count - of * rate * HOUR_S) <= max(1, of)]
        if not turns or (message == messages.Heartbeat.ID and turns != [1]):
            self.fail("message", message, "came", count, "times to", number)

    def check(self, number, message, expected):
        """Note where a station got another number of answers than it has to get."""
        count = self.counts.get((number, message), 0)
        if count != expected:
            self.fail("message", message, "came", count, "times in place of", expected, "to", number)

    def hour(self):
        """Let an hour pass and return what was counted; what is not as it has to be is noted."""
        self.counts = {}
        self.listed = set()
        for index in range(HOUR_S):
            self.second(index)
        for number in (FIRST, SECOND):
            for message, facts in MESSAGES.items():
                if facts["rate"] and not facts["on_connection"]:
                    self.check_rate(number, message, facts["rate"], facts["instances"])
            self.check(number, messages.ParamValue.ID, HOUR_S // 60)
        self.check(FIRST, messages.Ping.ID, HOUR_S // 60)
        if len(self.listed) != len(PARAMETERS):
            self.fail("the guest got", len(self.listed), "of", len(PARAMETERS), "parameters")
        faults, missed = self.craft.connections[0].faults, self.craft.scheduler.overruns
        if faults or missed:
            self.fail(faults, "faults,", missed, "slots missed:", self.craft.texts.get(self.craft.texts.last))
        ring = self.craft.texts._ring  # of texts the bench keeps more than a board does, longer and shorter ones
        for at in range(len(ring)):
            ring[at] = None
        gc.collect()
        gc.collect()
        return gc.mem_alloc()


def main():
    """Let the hours pass across the turn of ticks_ms()."""
    soak = Soak()
    soak.scene.seconds(20, FIRST, SECOND)
    soak.scene.air.taken = {}
    used = []
    for hour in range(HOURS):
        used.append(soak.hour())
        print(json.dumps({"hour": hour + 1, "heap": used[-1], "faults": soak.faults}))
    settled = used[SETTLED:]
    if settled and max(settled) - min(settled) > 512:
        soak.fail("the heap goes from", min(settled), "to", max(settled))
    print(json.dumps({"hours": HOURS, "heap": used[-1], "faults": soak.faults}))


main()
