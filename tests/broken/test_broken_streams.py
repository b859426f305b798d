"""Streams and messages that do not fit the links, the protocol or the dialect of the project."""

import pytest
from test_broken_reaches import check

CASES = {
    "a stream without messages": (
        [("streams.yaml", "streams:\n", "streams:\n  SPARE: {doc: Nothing., rate: 1 Hz}\n")],
        0,
        "specs/streams.yaml:3:3: warning unused-stream: no message belongs to the stream SPARE",
    ),
    "a stream that links cannot follow": (
        [("vehicle.yaml", "  links: 100 Hz", "  links: 40 Hz")],
        1,
        "specs/streams.yaml:3:3: error stream-beyond-links: HEARTBEAT goes up to 50 Hz",
    ),
    "the old protocol": (
        [("codegen.yaml", "protocol: 2", "protocol: 1")],
        1,
        "error needs-mavlink-2: BATTERY_STATUS_V2 has the id 369",
    ),
    "an unfinished message": (
        [
            (
                "dialects/corrections_rfc_0018.yaml",
                '    set: {wip: ""}',
                "    set: {description: Facts about a battery.}",
            )
        ],
        0,
        "warning unstable-message: BATTERY_INFO is work in progress",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_is_reported(name, tmp_path, monkeypatch, capsys):
    """The rule at its place; what only may go wrong is a warning."""
    changes, code, wanted = CASES[name]
    found, out = check(tmp_path, monkeypatch, capsys, changes)
    assert wanted in out
    assert found == code
