# Generated from templates/tests/program/twin_checks.py: do not edit.
# Inputs: e581bc844abbb339
"""Somebody else with the ids of this program on its link: people are told, and of its own frames that come back not."""

from mavlink import Link
from program_bench import (
    OTHER_SYSTEM,
    OTHER_COMPONENT,
    COMPONENT_ID,
    SECOND_US,
    SYSTEM_ID,
    GroundStation,
    main,
    messages,
    new_craft,
    run,
)

_TOLD = f" {COMPONENT_ID} is in use by another: change one"


def _told(craft, seconds, each_second):
    """Return the seconds in which people were told."""
    found = []
    for second in range(seconds):
        before = craft.texts.last
        each_second()
        run(craft, SECOND_US)
        new = [craft.texts.get(number)[1] for number in range(before + 1, craft.texts.last + 1)]
        found += [second for text in new if text.endswith(_TOLD)]
    return found


def who_has_its_ids_is_told():
    """By a HEARTBEAT that it has not sent: at the second one, and every 30 s while they come; no one is answered."""
    craft = new_craft()
    twin = GroundStation(craft.port, system_id=SYSTEM_ID, component_id=COMPONENT_ID)

    def send():
        twin.link.sequence = craft.connections[0].link.sequence + 100
        twin.send(messages.Heartbeat)

    assert _told(craft, 65, send) == [1, 31, 61]
    assert _told(craft, 65, lambda: None) == []
    assert craft.connections[0].services.components.names[0] == 0, "it is nobody who listens"


def others_are_not():
    """Another component of the same system, or one of another system, whatever their sequence numbers are."""
    for system, component in ((SYSTEM_ID, OTHER_COMPONENT), (OTHER_SYSTEM, COMPONENT_ID)):
        craft = new_craft()
        other = GroundStation(craft.port)
        other.link = Link(other, system, component)
        other.link.sequence = 100
        assert _told(craft, 10, lambda: other.send(messages.Heartbeat)) == []  # noqa: B023


def frames_that_come_back_are_not():
    """A link that returns each frame, a second later."""
    craft = new_craft()
    returned = [0]

    def give_back():
        frames = craft.port.frames
        for frame in frames[returned[0] :]:
            craft.port.arrives(frame)
        returned[0] = len(frames)

    assert _told(craft, 65, give_back) == []
    assert returned[0] > 0


CHECKS = (
    (who_has_its_ids_is_told, "services.twins"),
    (others_are_not, "services.twins"),
    (frames_that_come_back_are_not, "services.twins"),
)

if __name__ == "__main__":
    main(CHECKS)
