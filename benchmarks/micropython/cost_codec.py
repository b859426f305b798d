"""The generated codec: values to a frame in three ways, and a frame to an object. See counting.py."""

import counting
import messages
from mavlink import Link

NAMES = ("current_consumed", "energy_consumed", "temperature", "voltages[0]", "current_battery", "battery_remaining")

sent = messages.BatteryStatus(live=NAMES)
written = messages.BatteryStatus()
arriving = messages.BatteryStatus(live=NAMES)
link = Link(None, messages=(arriving,))
frame = bytes(link.encode(sent.update(id=1, battery_function=1, type=1)))


def live_values_to_frame(rounds):
    """Six values go into `live`, then the frame is made."""
    encode = link.encode
    live = sent.live
    for _ in range(rounds):
        live[0] = 1234
        live[1] = 4567
        live[2] = 2345
        live[3] = 11700
        live[4] = 1520
        live[5] = 67
        encode(sent)


def keywords_to_frame(rounds):
    """Six values are given by keywords, then the frame is made."""
    encode = link.encode
    update = written.update
    voltages = (11700, None, None, None, None, None, None, None, None, None)
    for _ in range(rounds):
        update(
            current_consumed=1234,
            energy_consumed=4567,
            temperature=2345,
            voltages=voltages,
            current_battery=1520,
            battery_remaining=67,
        )
        encode(written)


def set_field(rounds):
    """One field is set by its name."""
    put = written.set
    for _ in range(rounds):
        put("temperature", 2345)


def read_field(rounds):
    """One field is read as an attribute."""
    for _ in range(rounds):
        written.temperature  # noqa: B018  reading is the workload


def frame_to_object(rounds):
    """A frame arrives and is received into an object."""
    put = link.put
    receive = link.receive
    for _ in range(rounds):
        put(frame)
        while receive() is not None:
            pass


frame_to_object(1)
if arriving.type != 1:
    raise SystemExit("the frame was not received")
counting.count(
    live=live_values_to_frame, keywords=keywords_to_frame, set=set_field, read=read_field, parse=frame_to_object
)
