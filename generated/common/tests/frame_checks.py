# Generated from templates/tests/program/frame_checks.py: do not edit.
# Inputs: c19c42b91bad1a59
"""Links by themselves: frames that they make and take, what they refuse, and signatures."""

from invented import Invented, Tiny, Wire, error_of
from mavlink import Link
from program_bench import main
from receiver import Receiver
from sender import Sender


def links_that_cannot_be():
    """ValueError for ids, versions and lengths that MAVLink does not have; the first and the last that it has are."""
    source, versions = "a source has ids from 1 to 255", "MAVLink has the versions 1 and 2"
    length = "a payload has 1 to 255 bytes"
    for given, reason in (
        ((0, 1, 2), source),
        ((256, 1, 2), source),
        ((1, 0, 2), source),
        ((1, 256, 2), source),
        ((1, 1, 0), versions),
        ((1, 1, 3), versions),
        ((1, 1, 2, (), 0), length),
        ((1, 1, 2, (), 256), length),
        ((1, 1, 1, (), 255, Stamp()), "MAVLink 1 has no signatures"),
    ):
        assert error_of(ValueError, Link, Wire(), *given) == reason, given
    message = Tiny(unknown=False).update(a=1)
    for system, component, version, longest in ((1, 255, 1, 8), (255, 1, 2, 255), (255, 255, 2, 8), (1, 1, 1, 255)):
        link = Link(Wire(), system, component, version, (), longest)
        assert (link.version, link.signing, link.sequence, link.tx_errors) == (version, None, 0, 0)
        frame = bytes(link.encode(message))
        at = 5 if version == 2 else 3
        assert tuple(frame[at : at + 2]) == (system, component)
        assert frame[0] == (0xFD if version == 2 else 0xFE)
        assert len(frame) == (12 + 1 if version == 2 else 8 + 8), frame
    plain = Sender(Wire())
    assert (plain.version, tuple(bytes(plain.encode(message))[5:7])) == (2, (1, 1))
    assert Link(Wire(), 1, 1, 2, (), 1).version == 2
    few = Link(Wire(), 1, 1, 2, (), 8, None, ((0, 1), (8, 8)))
    for text in ("", "a", "ab", "abc", "a"):
        frame = few.encode(Tiny(unknown=False).update(a=1, c=text))
        assert len(frame) == 12 + (5 + len(text) if text else 1), bytes(frame)
    assert error_of(ValueError, Receiver, (), None, 279) == "a frame has up to 280 bytes"
    assert Receiver((), None, 280).received == 0
    assert error_of(ValueError, Link(Wire(), 1, 1, 2, (), 7).encode, Tiny(unknown=False).update(c="abc"))


def what_a_stream_does_not_take_is_counted():
    """A part of a frame, nothing, None and an OSError; the number of the next frame goes on all the same."""
    wire = Wire(5, 0, None, OSError(5), 14, 13)
    link = Link(wire)
    message = Tiny(unknown=False).update(a=1)
    found = []
    for sequence in range(7):
        assert link.sequence == sequence
        found.append((link.send(message), link.tx_errors))
    assert found == [(5, 1), (0, 2), (0, 3), (0, 4), (14, 5), (13, 5), (13, 5)], found
    assert [frame[4] for frame in wire.frames] == list(range(7))
    link.sequence = 256 + 7
    assert link.sequence == 7
    wire.takes.append(ValueError("broken"))
    assert error_of(ValueError, link.send, message) == "broken"


def what_arrives_is_bytes():
    """Any kind of bytes, None for none; what is left of earlier ones comes first, and no byte is lost."""
    frames = b""
    for number in range(40):
        wire = Wire()
        Link(wire).send(Tiny(unknown=False).update(a=number + 1, c="abc"))
        frames += wire.frames[0]
    for kind in (bytes, bytearray, memoryview):
        for piece in (3, 100, 300, 700):
            link = Link(Wire(), 1, 1, 2, (Tiny,))
            found = []
            for at in range(0, len(frames), piece):
                arrived = link.feed(kind(frames[at : at + piece]))
                if at // piece % 3 > 0:  # else they come with the next call
                    found += [message.a for message in arrived]
            found += [message.a for message in link.feed(None)]
            assert found == list(range(1, 41)), (kind, piece, found)
            assert (link.received, link.signed, link.refused, link.crc_errors) == (40, 0, 0, 0)
    for wrong in ("text", 5, [1]):
        assert error_of(TypeError, link.feed, wrong) == "what arrives is bytes or like them"
    link = Link(Wire(), 1, 1, 2, (Tiny,))
    link.put(frames[:-1])
    count = 0
    while link.receive() is not None:
        count += 1
    assert count == 39, count
    link.give_up()
    assert link.receive() is None
    assert [message.a for message in link.feed(frames[-1:] + frames[:20])] == [1]
    assert link.crc_errors == 0
    link.give_up()  # nothing is begun
    assert [message.a for message in link.feed(frames[:20])] == [1]
    link = Link(Wire(), 1, 1, 2, (Tiny,))
    data = bytearray(frames + frames)
    link.put(data)
    data[len(frames) :] = b""  # the caller may make them shorter
    assert [message.a for message in link.feed(None)] == list(range(1, 41))
    assert [message.a for message in link.feed(frames)] == list(range(1, 41))


def messages_are_made_for_those_that_are_expected():
    """For each frame with an id that none is for yet one that a function makes; others go on as they are."""
    wire, made = Wire(), []
    Link(wire).send(Tiny(unknown=False).update(a=5))
    Link(wire).send(Invented(unknown=False).update(flag=6))
    kept = Invented(unknown=False)
    link = Link(Wire(), 1, 1, 2, (kept,))

    def make(number):
        made.append(Tiny(unknown=False))
        assert number == Tiny.ID
        return made[-1]

    link.expect((Invented.ID, Tiny.ID), make)
    for count in (1, 2):
        found = list(link.feed(wire.frames[0] + wire.frames[1]))
        assert len(made) == count
        assert found[0] is made[-1]
        assert found[1] is kept
        assert (found[0].a, found[1].flag) == (5, 6)


class Stamp:
    """A signature of the same thirteen bytes for each frame; `asked` are those that it was asked about."""

    unsigned = (Invented.ID,)

    def __init__(self, key=1):
        self.key = key
        self.asked = []

    def sign(self, frame):
        """Put the bytes at the end of a frame."""
        frame[-13:] = bytes([self.key] * 13)

    def accepts(self, frame):
        """Return whether they are its own."""
        self.asked.append(bytes(frame))
        return bytes(frame[-13:]) == bytes([self.key] * 13)


def signatures_are_made_and_judged():
    """A link that signs takes signed frames that it accepts, unsigned ones of a few messages, and counts the others."""
    own, other = Stamp(), Stamp(2)
    link = Link(Wire(), 1, 1, 2, (Tiny, Invented(unknown=False)), 255, own)
    assert link.signing is own
    message, free = Tiny(unknown=False).update(a=9, c="abc"), Invented(unknown=False).update(wide=3)
    frames = {}
    for name, signing in (("own", own), ("other", other), ("none", None)):
        wire = Wire()
        sender = Link(wire, 7, 8, 2, (), 255, signing)
        sender.send(message)
        sender.send(free)
        frames[name] = wire.frames
        extra = 13 if signing else 0
        assert [frame[2] for frame in wire.frames] == [1 if signing else 0] * 2
        assert [len(frame) for frame in wire.frames] == [20 + extra, 13 + extra]
    found = [(type(each), each.source_system) for each in link.feed(frames["own"][0] + frames["own"][1])]
    assert found == [(Tiny, 7), (Invented, 7)]
    assert own.asked == frames["own"]
    assert (link.received, link.signed, link.refused) == (2, 2, 0)
    assert list(link.feed(frames["other"][0])) == []
    assert list(link.feed(frames["none"][0])) == []
    assert (link.received, link.signed, link.refused) == (2, 2, 2)
    assert [type(each) for each in link.feed(frames["none"][1])] == [Invented]
    assert (link.received, link.signed, link.refused, link.crc_errors) == (3, 2, 2, 0)
    damaged = bytearray(frames["own"][0])
    damaged[12] ^= 1
    assert list(link.feed(damaged + bytes(300))) == []
    assert (link.received, link.refused, link.crc_errors) == (3, 2, 1)
    open_link = Link(Wire(), 1, 1, 2, (Tiny,))
    assert [each.a for each in open_link.feed(frames["own"][0] + frames["other"][0])] == [9, 9]
    assert (open_link.received, open_link.signed, open_link.refused) == (2, 2, 0)


CHECKS = (
    (links_that_cannot_be,),
    (what_a_stream_does_not_take_is_counted,),
    (what_arrives_is_bytes,),
    (messages_are_made_for_those_that_are_expected,),
    (signatures_are_made_and_judged,),
)

if __name__ == "__main__":
    main(CHECKS)
