"""Somebody else with the ids of this program on its link: people are told, and of its own frames that come back not."""

from binascii import hexlify
from struct import calcsize

from fields import layout_of
from mavlink import Link
from program_bench import (
    COMPONENT_ID,
    OTHER_COMPONENT,
    OTHER_SYSTEM,
    SECOND_US,
    SYSTEM_ID,
    GroundStation,
    machine,
    main,
    messages,
    mock_time,
    needs,
    new_craft,
    payload_of,
    run,
)
from program_facts import MESSAGES
from stand_ins import Texts, Thing

import twins

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


def twins_are_known_by_chips_and_numbers():
    """Another chip under the same ids, or with a number of this vehicle, is told of, twice a minute."""
    chip = hexlify(machine.unique_id())
    size = len(chip) + 2
    for places in ((4, 0), (4, None)):
        told = Texts()
        at_hand = Thing(component_id=7, link=Thing(sequence=9), stations=[], station=None)
        watch = twins.TwinWatch(at_hand, told, "COMPONENT", ((77, 3, size, places[1]), (78, 1, 2, 0)), "NUMBER", (2, 5))
        mock_time.set_ticks_us(0)

        def heard(number, component, wire):
            before = len(told.told)  # noqa: B023
            watch.look_at(Thing(ID=number, wire=wire, source_sequence=0), component)  # noqa: B023
            return [text for _, text in told.told[before:]]  # noqa: B023

        own = bytes(3) + chip + bytes(2)
        assert heard(77, 7, own) == []
        assert heard(78, 7, b"\x00" + chip[:2]) == []
        assert heard(79, 7, bytes(99)) == []
        expected = ["warning: COMPONENT 7 is in use by another: change one"]
        for place in range(3, 3 + size):
            mock_time.advance_us(30000000)
            other = own[:place] + bytes([own[place] ^ 1]) + own[place + 1 :]
            assert heard(77, 7, other) == expected, place
            mock_time.advance_us(29999000)
            assert heard(77, 7, other) == [], "it was told just now"
        for number, texts in ((2, 1), (3, 0), (5, 1), (0, 0)):
            mock_time.advance_us(30000000)
            found = heard(77, 9, bytes([number]) + bytes(99))
            is_told = texts if places[1] is not None else 0
            assert found == [f"warning: NUMBER {number} is in use by component 9: change one"] * is_told, (
                number,
                found,
            )
    mock_time.set_ticks_us(0)


def what_is_watched_is_what_goes_out():
    """The whole field that has the chip, the one that has the number of the instance, and its own numbers alone."""
    craft = new_craft()
    watch = craft.connections[0].twins
    needs(watch._kinds, "a message that has the chip")
    for number, start, count, place in watch._kinds:
        layout = layout_of(next(each for each in messages.ALL if number == each.ID))
        sizes = {field[1]: calcsize(field[0]) for field in layout.values()}
        assert sizes[start] == count, (number, start, count)
        if place is None or not watch._numbers:  # with numbers that are fixed nothing is watched
            continue
        assert sizes[place] == 1, (number, place)
        craft.port.frames = []
        craft.connections[0].streams.send(number)
        told = [payload_of(frame) for frame in craft.port.frames]
        found = [payload[place] if place < len(payload) else 0 for payload in told]
        assert found, number
        assert [each for each in found if each not in watch._numbers] == [], (found, watch._numbers)
        assert len(watch._numbers) == MESSAGES[number]["instances"], watch._numbers


def frames_that_come_back_are_own():
    """A HEARTBEAT with a number that one of the links has sent of late is its own: two others in a row are told."""
    at_hand = Thing(component_id=7, link=Thing(sequence=70), stations=[], station=Thing(sequence=0))
    at_hand.stations = [at_hand.station, Thing(sequence=200)]
    for sequence, is_own in (
        (69, True),
        (6, True),
        (5, False),
        (70, False),
        (199, True),
        (136, True),
        (135, False),
        (200, False),
    ):
        told = Texts()
        watch = twins.TwinWatch(at_hand, told, "COMPONENT", ())
        own, other = (Thing(ID=messages.Heartbeat.ID, wire=b"", source_sequence=each) for each in (69, sequence))
        counts = []
        for each, component in ((other, 8), (other, 7), (own, 7), (other, 7), (other, 8), (other, 7)):
            watch.look_at(each, component)
            counts.append(len(told.told))
        assert counts == [0, 0, 0, 0, 0, 0 if is_own else 1], (sequence, counts)


CHECKS = (
    (twins_are_known_by_chips_and_numbers, "services.twins"),
    (what_is_watched_is_what_goes_out, "services.twins"),
    (frames_that_come_back_are_own, "services.twins"),
    (who_has_its_ids_is_told, "services.twins"),
    (others_are_not, "services.twins"),
    (frames_that_come_back_are_not, "services.twins"),
)

if __name__ == "__main__":
    main(CHECKS)
