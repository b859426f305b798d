"""The checks of the program notice a fault that nothing else does: each of these makes the check beside it fail."""

from pathlib import Path

import pytest
from generated_suite import scripts_of

SCRIPTS = scripts_of(Path(__file__).resolve().parents[2] / "generated" / "tests")
INTERPRETERS = ("cpython", "micropython")

EARLIER = "storage what_an_earlier_release_has_saved_is_read"
INPUTS = "health faults_of_an_input_are_told_now_and_then"

# A check, and changes of modules: what is replaced by what, both where a fault is made alike in two places.
FAULTS = [
    ("order-of-bytes-of-a-slot", EARLIER, [("storage", '"<4sHHH"', '">4sHHH"')]),
    ("order-of-bytes-of-its-checksum", EARLIER, [("storage", '"<I"', '">I"')] * 2),
    ("what-the-checksum-is-of", EARLIER, [("storage", "image)[:-_CRC_SIZE]", "image)[4:-_CRC_SIZE]")] * 2),
    ("order-of-bytes-of-a-value", EARLIER, [("parameters", 'pack("<f"', 'pack(">f"')] * 2),
    (
        "view-that-nobody-needs",
        "link views_are_kept_of_what_goes_out",
        [("streams", "_LENGTHS = ((0, 54)", "_LENGTHS = ((0, 55)")],
    ),
    ("ticks-that-start-again", INPUTS, [("adc_faults", "- told_ms & _TICKS <", "- told_ms <")]),
    ("time-between-texts", INPUTS, [("adc_faults", "const(10000)", "const(10100)")]),
    ("faults-counted-again", INPUTS, [("adc_faults", "self._untold[instance] = 0", "pass")]),
    ("another-fault-that-waits", INPUTS, [("adc_faults", "and not is_first_late", "")]),
    (
        "converter-that-stays-away",
        "health a_converter_that_comes_back_is_used",
        [("adc_faults", "elif self._inputs.open(instance):", "elif False:")],
    ),
    (
        "half-a-round-of-the-ticks",
        "network a_try_waits_for_its_pause_and_no_longer",
        [("network_port", "if 0 < ahead_ms <= self.period_ms:", "if 0 < ahead_ms:")],
    ),
    (
        "password-of-another",
        "network ports_share_a_network_that_is_the_same",
        [("network_port", " and self._password == password", "")],
    ),
]


def found(interpreter: str, check: str) -> str:
    """Return what a check prints: its name, and what went wrong or null."""
    return SCRIPTS.run_under(interpreter, "checks_run.py", "0", check).strip()


@pytest.mark.parametrize("interpreter", INTERPRETERS)
def test_none_fails_as_it_is(interpreter: str) -> None:
    """What fails below fails because of the fault."""
    checks = sorted({fault[1] for fault in FAULTS})
    assert [line for check in checks if not (line := found(interpreter, check)).endswith(", null]")] == []


@pytest.mark.parametrize(("check", "changes"), [pytest.param(*fault[1:], id=fault[0]) for fault in FAULTS])
def test_fault_is_noticed(
    check: str, changes: list[tuple[str, str, str]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By the check that is about it."""
    for module, old, new in changes:
        changed = tmp_path / f"{module}.py"
        text = (changed if changed.exists() else SCRIPTS.path_of("firmware", changed.name)).read_text()
        assert old in text, f"{old!r} is not in {module}"
        changed.write_text(text.replace(old, new, 1))
    monkeypatch.setattr(SCRIPTS, "PATHS", [str(tmp_path), *SCRIPTS.PATHS])
    assert "Error" in found("cpython", check)
