"""A fingerprint follows the words of a claim, not where and how they are set."""

import pytest

from codegen.findings.fingerprint import fingerprint

CLAIM = "`BATTERY_STATUS` is **41 bytes**, 0xFF"
BEFORE = fingerprint("claim-size", "/a/b/notes.md", CLAIM)


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("/elsewhere/notes.md", CLAIM),
        ("/a/b/notes.md", "BATTERY_STATUS is\n  41   bytes, 0xff"),
        ("/a/b/notes.md", r"BATTERY\_STATUS is __41 bytes__, 0Xff"),
    ],
)
def test_it_survives_moves_and_markup(file: str, text: str) -> None:
    assert fingerprint("claim-size", file, text) == BEFORE


@pytest.mark.parametrize(
    ("rule", "file", "text"),
    [
        ("claim-rate", "/a/b/notes.md", CLAIM),
        ("claim-size", "/a/b/others.md", CLAIM),
        ("claim-size", "/a/b/notes.md", CLAIM.replace("41", "42")),
        ("claim-size", "/a/b/notes.md", CLAIM.replace("BATTERY_STATUS", "BATTERYSTATUS")),
    ],
)
def test_it_changes_with_what_is_claimed(rule: str, file: str, text: str) -> None:
    assert fingerprint(rule, file, text) != BEFORE


def test_it_is_twelve_hex_digits_for_any_text() -> None:
    found = fingerprint("a-b", "", "\udcff\0")
    assert len(found) == 12
    assert int(found, 16) >= 0
