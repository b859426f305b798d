"""The heap over a simulated day of requests, answers and texts; only MicroPython has one to measure."""

import gc

from program_bench import SECOND_US, TURN_MS_US, Sink, main, messages, new_craft, run
from program_facts import COMPONENT_ID, SYSTEM_ID

import dialect

STEP_US = 12800000  # between two passes, each of which has something to send
DAY_US = 86400 * SECOND_US
OFTEN = 24  # so many rounds of other requests between two lists of parameters; a quarter of the day has fifteen


class Busy(Sink):
    """A port on which a frame of a ground station arrives with every second pass."""

    def __init__(self, frames):
        Sink.__init__(self)
        self._frames = frames
        self._turn = 0

    def readinto(self, buffer):
        """Give one frame in two passes."""
        self._turn += 1
        if self._turn % 2:
            return 0
        frame = self._frames[self._turn // 2 % len(self._frames)]
        buffer[: len(frame)] = frame
        return len(frame)


def _requests():
    """Return frames of a ground station that goes on asking, now and then for all parameters: that takes longest."""
    from mavlink import Link  # noqa: PLC0415  only here

    link = Link(Sink(), 255, 190)
    target = {"target_system": SYSTEM_ID, "target_component": COMPONENT_ID}
    made = [
        messages.Heartbeat(unknown=False).update(type=dialect.MAV_TYPE_GCS),
        messages.Ping(unknown=False).update(seq=7),
        messages.CommandLong(unknown=False).update(command=410, **target),
        messages.CommandLong(unknown=False).update(command=dialect.MAV_CMD_REQUEST_MESSAGE, param1=148, **target),
        messages.RequestDataStream(unknown=False).update(req_message_rate=2, start_stop=1, **target),
    ]
    often = [bytes(link.encode(message)) for message in made] + [b"\xfd\x09noise"]
    rarely = bytes(link.encode(messages.ParamRequestList(unknown=False).update(**target)))
    return often * OFTEN + [rarely]


def heap_is_constant_over_a_day():
    """After a day of requests, answers and texts as much memory is in use as after its first minutes."""
    port = Busy(_requests())
    craft = new_craft(ports=[port], at_us=TURN_MS_US - DAY_US // 2)
    used = []
    for _ in range(4):
        run(craft, DAY_US // 4, STEP_US)
        gc.collect()
        used.append(gc.mem_alloc())
    assert max(used[1:]) - min(used[1:]) <= 512, used
    assert craft.connections[0].faults == 0, craft.said()


CHECKS = ((heap_is_constant_over_a_day, "control.memory"),)
LONG = (heap_is_constant_over_a_day,)

if __name__ == "__main__":
    main(CHECKS)
