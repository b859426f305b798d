"""A name whose declaration cannot be read is reported once: nothing that uses it is told that it does not exist."""

import pytest
from test_broken_tables import Case, check_place, name_of

STATE = "state.yaml"
COUNTS = "        counts_returns_of: absent\n"

CASES = [
    Case("missing-key", STATE, f"{COUNTS}        back_from: 2.0", "        back_from: §2.0", "back_from wants counts_returns_of, which is missing"),
    Case("wrong-type", STATE, COUNTS, COUNTS.replace("absent", "§.nan"), "counts_returns_of wants text"),
    # quantities that tables, failsafes, texts and other quantities name
    Case("missing-key", STATE, "      voltage:\n        doc: Voltage of the whole pack.\n", "      §voltage:\n", "doc is missing"),
    Case("missing-key", STATE, "      swaps:\n        doc: How often a pack was put in since the start, and so may be another one.\n", "      §swaps:\n", "doc is missing"),
    Case("missing-key", STATE, "      consumed:\n        doc: Charge drawn since the start, or since the pack was put in.\n", "      §consumed:\n", "doc is missing"),
]  # fmt: skip


@pytest.mark.parametrize("case", CASES, ids=name_of)
def test_is_reported_once(case, tmp_path, monkeypatch, capsys):
    """The rule, the place and the words are right, and it is the one finding."""
    check_place(case, tmp_path, monkeypatch, capsys)
