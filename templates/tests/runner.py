"""Runs the generated cases on whatever interpreter reads this file: CPython, MicroPython on a host, or a board.

As a program under MicroPython: `micropython runner.py cases.json`, with the firmware and the mocks on MICROPYPATH. It
prints one JSON object: the frames and values that the firmware produced, by the names of the cases.
"""

import json
import sys

import mock_time

mock_time.install()

from board import Board  # noqa: E402  the clock has to be in place before the firmware looks at it
from fields import layout_of  # noqa: E402
from mavlink import Link  # noqa: E402
from mock_board import MockBoard  # noqa: E402
from parameters import Parameters  # noqa: E402
from state import SystemState  # noqa: E402
from telling import tell  # noqa: E402

import streams  # noqa: E402
import telemetry  # noqa: E402

_LEFT = 0xA5  # a byte of a message before, which is in no value that stands for unknown
_FLOATS = {"nan": float("nan"), "inf": float("inf"), "-inf": -float("inf")}


class Wire:
    """A stream that takes everything and keeps the last frame."""

    def __init__(self):
        self.frame = b""

    def write(self, data):
        self.frame = bytes(data)
        return len(data)


def component_of(state, name, instances, instance):
    """Return the component that a message of this instance reports."""
    component = getattr(state, name)
    return component if instances[name] == 1 else component[instance]


def state_of(case, instances):
    """Return a fresh state as a case has it."""
    state = SystemState(log=silent)
    for name, attribute, value, *instance in case["set"]:
        component = component_of(state, name, instances, instance[0] if instance else 0)
        setattr(component, attribute, _FLOATS.get(value, value) if isinstance(value, str) else value)
    return state


def soil(message, texts):
    """Leave a payload as messages before may have left it, but for texts: behind their ends nothing is written.

    `texts` names the fields of bytes that carry one.
    """
    kept = bytes(message.wire)
    for at in range(message.LENGTH):
        message.wire[at] = _LEFT
    for name, (form, start, count, _, _, _) in layout_of(type(message)).items():
        if form[-1] == "s" or name in texts:
            message.wire[start : start + count] = kept[start : start + count]


def frames_of(case, instances, count, texts, links):
    """Return the frames of a case as hexadecimal text, one per link; None where the message does not go over it.

    `count` is 2 where a message is about a page of an instance, 1 where it is about an instance, else 0; `texts` are
    its fields of bytes that carry a text. Each frame is made in both ways, straight from the state and of the message
    that is built; where these differ, both are told.
    """
    state = state_of(case, instances)
    about = (case["instance"], case.get("page", 0))[:count]
    about = about if any(about) else ()  # the first one needs not be named
    name = case.get("table", case["message"]).lower()
    build = getattr(telemetry, "build_" + name)
    message = build(state, *about)
    if message is not None:
        soil(message, texts)
        build(state, *about)
    encode = getattr(telemetry, "encode_" + name)
    frames = []
    for link in links:
        if message is None:  # it is withheld
            frames.append(encode(link, state, *about) and "a frame")
            continue
        fits = link.version == 2 or message.ID < 256
        if fits:
            link.sequence = 0
            if link.version == 2:
                for at in range(12, len(link._frame) - 15):
                    link._frame[at] = _LEFT  # as the frames before may have left it
            frame = bytes(encode(link, state, *about)).hex()
            link.send(message)
            assert link.sequence == 1
            if frame != link.stream.frame.hex():
                frame += " or " + link.stream.frame.hex()
        frames.append(frame if fits else None)
    return frames


def convert(case, instances):
    """Return what the state keeps after one reading of a case's count with its parameters."""
    parameters = Parameters()
    for name, steps in case["parameters"].items():
        setattr(parameters, name, steps)
    board = MockBoard(log=silent, parameters=parameters)
    getattr(board, case["setter"])(case["count"])
    state = SystemState(parameters, log=silent)
    getattr(state, "update_" + case["component"])(board)
    return getattr(component_of(state, case["component"], instances, 0), case["attribute"])


def silent(*_words):
    """Log nothing."""


def frames(cases):
    """Yield name and frames of each case."""
    links = [Link(Wire(), streams.SYSTEM_ID, streams.COMPONENT_ID, version) for version in (2, 1)]
    if streams.VERSION == 2:
        links[0] = streams.open_link(Wire())  # which has views of those lengths alone that it is said to need
    instances = cases["instances"]
    about, texts = cases["about"], cases["texts"]
    for case in cases["messages"]:
        table = case.get("table", case["message"])
        yield case["name"], frames_of(case, instances, about.get(table, 0), texts.get(table, ()), links)


def main(path):
    with open(path, encoding="utf-8") as file:
        cases = json.loads(file.read())  # load() asks the system for every single byte
    print('{"frames": ')
    tell(frames(cases))
    print(', "conversions": ')
    tell((case["name"], convert(case, cases["instances"])) for case in cases["conversions"])
    print("}")


if __name__ == "__main__" and issubclass(MockBoard, Board):
    main(sys.argv[1])
