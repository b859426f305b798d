"""The steady cycle of a whole vehicle leaves the heap alone; only MicroPython can tell."""

from micropython import heap_lock, heap_unlock, mem_total
from mavlink import Link
from program_bench import SECOND_US, Sink, analog, main, messages, mock_time, needs, new_craft, run
from program_facts import CONTROL_US, FAILSAFES, FORCE_ARM, MEASURED, STREAMS

LATE_US = 1000000
FORGIVEN = ("control", "measure")


def _fast(craft):
    """Set all streams to their highest rates, or to half of them and so on: what a link leaves out it tells."""
    budget = craft.connections[0]._budget  # the room in a pass, and how many messages were left out
    for slower in (1, 2, 4, 8, 16, 32):
        for stream in STREAMS:
            if stream["parameter"]:
                setattr(craft.parameters, stream["parameter"], stream["maximum"] // slower)
        run(craft, SECOND_US)
        if not budget[1]:
            return
        budget[1] = 0


def steady_cycle_allocates_nothing():
    """Whole passes, all streams as fast as the link carries them, under a locked heap: nothing is ever allocated."""
    for version in ("disarmed",) if FORCE_ARM is None else ("disarmed", "armed", "watching"):
        sink = Sink()
        craft = new_craft(ports=[sink])
        _fast(craft)
        if version != "disarmed":
            craft.arm(force=True)
        run(craft, 5 * SECOND_US)
        if version == "watching":
            for measured in MEASURED:
                analog(measured).source = 1
            for facts in FAILSAFES:
                craft.parameters.set(facts["after"].upper(), 120)
            run(craft, 15 * SECOND_US)
        count = sink.count
        allocated = _allocated(craft)
        assert allocated == 0, f"{version}: {allocated} bytes in 2 s"
        assert sink.count > count
        errors = [text for text in craft.said() if "failed:" in text[1] or "fault" in text[1]]
        assert errors == [], errors


def _allocated(craft):
    """Return how many bytes 800 passes allocate; MemoryError: something is allocated while the heap is locked."""
    waits = 0
    heap_lock()
    try:
        for _ in range(800):
            waits += craft.run_pass()
            mock_time.advance_us(CONTROL_US)
    finally:
        heap_unlock()
    before = mem_total()
    for turn in range(800):
        craft.run_pass()
        mock_time.advance_us(CONTROL_US)
        if turn % 200 == 0:  # what a watchdog looks at
            craft.scheduler.stalled(LATE_US, FORGIVEN)
    return mem_total() - before


class Asked:
    """The messages of a link by id, as its receiver has them, and how often it asked for one of these."""

    def __init__(self, by_id):
        self.values = by_id.values
        self.count = 0
        self._get = by_id.get

    def get(self, number):
        """Return one, or None."""
        self.count += 1
        return self._get(number)


def messages_are_found_at_once():
    """Machine code finds a message that arrives into one object in its rows; only others are asked for."""
    try:
        from frames_viper import decoder  # noqa: PLC0415  only here
    except (AttributeError, ImportError, NotImplementedError, SyntaxError, TypeError, ValueError):
        needs(False, "machine code")
    sender = Link(Sink(), 1, 1)
    for first in range(len(messages.ALL)):
        for count in (1, 2, 5, len(messages.ALL)):
            kept = (messages.ALL + messages.ALL)[first : first + count]
            link = Link(Sink(), 1, 1, 2, [kind(unknown=False) for kind in kept])
            link._messages = Asked(link._messages)
            receive = decoder(link)
            for kind in kept:
                link.put(bytes(sender.encode(kind(unknown=False))))
                assert receive().ID == kind.ID, kind.NAME
            assert link._messages.count == 0, (kept[0].NAME, count, link._messages.count)


CHECKS = (
    (steady_cycle_allocates_nothing, "control.memory", "component.steady", "component.allocation"),
    (messages_are_found_at_once,),
)

if __name__ == "__main__":
    main(CHECKS)
