# ruff: noqa: T201  what is printed is the answer
"""Lets pieces of a file arrive at the rover's program, one in each pass, and writes down the PINGs that it answers.

Arguments: the file, each piece with its length of two bytes before it; the file for the numbers of the PINGs; `bytes`
or `datagrams`, which says what the port brings. With firmware, mocks and tests of a build on the path of modules.
"""

import json
import sys

import messages
from program_bench import Port, new_craft, run_passes
from station_checks import Air, address

MOST = 256 + 280  # bytes that a pass may look at: its share, and the frame that it began with the last of them
LAST_PASSES = 400  # until what is not whole was given up, and all is answered


def end_of(port):
    """Return a port, a function that lets a piece arrive at it, and one that returns the frames that it took."""
    if port == "bytes":
        end = Port()

        def taken():
            found, end.frames = end.frames, []
            return found

        return end, end.arrives, taken
    end = Air()

    def arrives(piece):
        end.arrived.append((address(1), piece))

    def taken_from_air():
        found = end.taken.get(address(1), [])
        end.taken = {}
        return found

    return end, arrives, taken_from_air


def answered(taken_frames, out):
    """Write down the numbers of the PINGs among frames."""
    for frame in taken_frames:
        if frame[7] == messages.Ping.ID and not frame[8] and not frame[9]:
            payload = frame[10 : 10 + frame[1]] + bytes(14)
            out.write(f"{int.from_bytes(payload[8:12], 'little')}\n")


def main():
    """Let all pieces arrive."""
    end, arrives, taken = end_of(sys.argv[3])
    craft = new_craft(ports=[end])
    connection = craft.connections[0]
    state = connection.link._state  # frames_plain says what it holds
    most = 0
    with open(sys.argv[1], "rb") as pieces, open(sys.argv[2], "w") as out:
        head = pieces.read(2)
        while head:
            arrives(pieces.read(head[0] | head[1] << 8))
            run_passes(craft, 1)
            most = max(most, state[15])
            answered(taken(), out)
            head = pieces.read(2)
        for _ in range(LAST_PASSES):
            run_passes(craft, 1)
            answered(taken(), out)
    known = {}
    for number, message in connection.link._messages.items():
        link = connection.link
        known[number] = (message or link._classes.get(number) or link._make(number)).CRC_EXTRA
    said = craft.texts.get(craft.texts.last)
    form = "machine code" if "frames_viper" in sys.modules else "plain"
    answer = {"form": form, "work": most, "most": MOST, "known": known}
    answer.update({"faults": connection.faults, "said": str(said)})
    print(json.dumps(answer))


main()
