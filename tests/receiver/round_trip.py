"""Random states: firmware, frame, receiver, and back; `round_trip.py generated-folder`, under CPython.

Firmware and receiver have modules of the same names, which are imported one after the other.
"""

import importlib
import json
import sys
import time
from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st

from codegen.model.program_folders import program_folders

GENERATED = Path(sys.argv[1])
LARGEST = 2**30 - 1
FACTS = json.loads((GENERATED / "tests" / "receiver_facts.json").read_text())
time.ticks_ms = lambda: 0
time.ticks_us = lambda: 0
time.ticks_diff = lambda later, earlier: later - earlier


def loaded(folders, *names):
    """Modules of some folders, after which no other module of theirs is in the way."""
    before, path = set(sys.modules), list(sys.path)
    sys.path[:0] = program_folders(str(GENERATED)).of(*folders)
    modules = [importlib.import_module(name) for name in names]
    sys.path[:] = path
    for name in set(sys.modules) - before:
        found = getattr(sys.modules[name], "__file__", None) or ""
        if found.startswith(str(GENERATED)):
            del sys.modules[name]
    return modules


telemetry, state_module, mavlink = loaded(["firmware", "mocks"], "telemetry", "state", "mavlink")
(receiving,) = loaded(["receiver"], FACTS["module"])
sys.path.insert(0, str(GENERATED / "receiver"))  # fields, which is imported at the first use of one, has no state
LINKS = [mavlink.Link(None, 7, 9, version) for version in (2, 1)]

NUMBERS = st.one_of(
    st.none(),
    st.integers(-LARGEST, LARGEST),
    st.integers(-70000, 70000),
    st.sampled_from([0, -1, 1, 32767, 32768, -32768, 65534, 65535, 65536, 655340, 655341, 2**24 + 1, 100, 101, 255]),
)


def component_of(state, name, instance):
    """One instance of a component, of which there may be a list."""
    component = getattr(state, name)
    return component[instance] if isinstance(component, list) else component


def agrees(value, stored, about):
    """Return whether the receiver says what the state kept, as far as the wire carries it."""
    if about.get("boolean"):
        return value is bool(stored)
    if stored is None:
        stored = about["stands_in"] and about["stands_in"] * about["steps"]
    if stored is None or value is None:
        return value is None and stored is None
    expected = min(max(stored / about["steps"], about["low"]), about["high"])
    return abs(value - expected) <= about["within"] + abs(expected) * 2**-23


def states(about):
    """A strategy for what the state keeps of each attribute of a message."""
    kinds = {name: st.booleans() if fact.get("boolean") else NUMBERS for name, fact in about["attributes"].items()}
    return st.fixed_dictionaries(kinds)


def check(name, about):
    """Whatever the state is, every attribute comes back."""

    @settings(max_examples=400, deadline=None, database=None, derandomize=True)
    @given(kept=states(about))
    def comes_back(kept):
        state = state_module.SystemState(log=lambda *_: None)
        component = component_of(state, FACTS["component"], 0)
        for attribute, value in kept.items():
            setattr(component, about["attributes"][attribute]["stored"], value)
        message = getattr(telemetry, f"build_{name.lower()}")(state)
        for link in LINKS:
            if link.version == 1 and message.ID > 255:
                continue
            receiver = getattr(receiving, FACTS["class"])()
            assert receiver.feed(bytes(link.encode(message)), 0) == 1
            (view,) = receiver.views()
            assert (view.system, view.components) == (7, (9,))
            for attribute, fact in about["attributes"].items():
                if not (link.version == 1 and fact["is_extension"]):
                    said = getattr(view, attribute)
                    assert agrees(said, kept[attribute], fact), (name, attribute, kept[attribute], said)

    comes_back()
    print(name)  # noqa: T201


for message_name, attributes in FACTS["messages"].items():
    check(message_name, attributes)
