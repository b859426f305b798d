"""Feeds frames to the receiver, on whatever interpreter reads this file, and prints what came of them as JSON.

`receiver_run.py facts.json frames`, with the receiver's folder on the path: frames are lines with the name of a message
and the frame as hexadecimal text. Each goes into a receiver of its own and is answered with a line; then some of them
go through checks together, each of which is answered with a line as well.
"""

import json
import sys

NOW_MS = 5000
STEP = 20  # each so many frames one goes through the checks
TURN_MS = 1 << 30  # the clock of a board starts again
NOISE = bytes([0xFD, 9, 0, 0, 0xFE, 1, 0x55, 0xFD, 0xFE])


def attributes_of(view, names):
    """Return what the attributes say, by name."""
    return {name: getattr(view, name) for name in names}


def one_frame(new, facts, name, frame):
    """Return what a frame alone says, by attribute; None if the receiver did not take it for one message."""
    receiver = new()
    if receiver.feed(frame, NOW_MS) != 1 or len(receiver.views()) != 1:
        return None
    view = receiver.views()[0]
    assert view.messages == (name,), view.messages
    return attributes_of(view, facts["messages"][name]["attributes"])


def nothing_of_a_cut_frame(new, _facts, frames):
    """A frame without its end says nothing, and with it everything; in pieces of one byte as well."""
    for _, frame in frames:
        receiver = new()
        assert receiver.feed(frame[:-1], NOW_MS) == 0
        assert receiver.views() == []
        assert receiver.feed(frame[-1:], NOW_MS) == 1
        receiver = new()
        assert sum([receiver.feed(frame[at : at + 1], NOW_MS) for at in range(len(frame))]) == 1


def noise_is_passed_over(new, _facts, frames):
    """Between bytes that look like the start of frames each frame is found; one with a wrong byte is not."""
    receiver = new()
    for _, frame in frames:
        wrong = bytearray(frame)
        wrong[-3] ^= 0x40
        receiver.feed(NOISE + wrong + NOISE + frame, NOW_MS)
    receiver.feed(bytes(300), NOW_MS)
    assert receiver.receiver.received == len(frames)


def silence_makes_it_unknown(new, facts, frames):
    """After the time of staleness every quantity is None, and known again with the next frame; on each clock."""
    limit = facts["stale_ms"]
    name, frame = frames[0]
    names = facts["messages"][name]["attributes"]
    for start in (0, NOW_MS, TURN_MS - limit // 2, TURN_MS - 1):
        receiver = new()
        receiver.feed(frame, start)
        view = receiver.views()[0]
        known = attributes_of(view, names)
        assert not view.is_stale()
        receiver.feed(None, (start + limit) % TURN_MS)
        assert not view.is_stale()
        assert view.age_ms() == limit
        assert attributes_of(view, names) == known
        receiver.feed(None, (start + limit + 1) % TURN_MS)
        assert view.is_stale()
        assert [value for value in attributes_of(view, names).values() if value is not None] == []
        assert view.time_left_s() is None
        receiver.feed(frame, (start + limit + 2) % TURN_MS)
        assert attributes_of(view, names) == known


def one_view_for_all_messages(new, _facts, frames):
    """Whatever reports one number makes one view."""
    receiver = new()
    for _, frame in frames:
        receiver.feed(frame, NOW_MS)
    seen = {(view.system, view.number) for view in receiver.views()}
    assert len(seen) == len(receiver.views())
    for view in receiver.views():
        assert receiver.view(view.system, view.number) is view
        assert not view.is_contested


CHECKS = (nothing_of_a_cut_frame, noise_is_passed_over, silence_makes_it_unknown, one_view_for_all_messages)


def outcome(check, new, facts, frames):
    """Return None if a check passes, else what went wrong."""
    try:
        check(new, facts, frames)
    except AssertionError as error:
        return f"{check.__name__}: {error!r}"
    return None


def main(facts_path, frames_path):
    """Print what each frame says, and what came of the checks."""
    with open(facts_path) as file:
        facts = json.loads(file.read())
    new = getattr(__import__(facts["module"]), facts["class"])
    frames = []
    with open(frames_path) as file:
        lines = file.read().split("\n")  # by lines the system would be asked for every single byte
    for number, line in enumerate(lines[:-1]):
        name, frame = line.split()
        frame = bytes.fromhex(frame)
        print(json.dumps(one_frame(new, facts, name, frame)))
        if number % STEP == 0:
            frames.append((name, frame))
    for check in CHECKS:
        print(json.dumps(outcome(check, new, facts, frames)))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
