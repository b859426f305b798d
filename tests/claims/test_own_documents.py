"""A project's own documents beside its tables: a default, a range, a rate or a number that is out of date is found."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[2]
STORAGE = "NFR-00061-parameter-storage.md"
SERVICES = "FR-00070-ground-station-services.md"
TELEMETRY = "FR-00068-battery-status-telemetry.md"
VOLTAGE = "FR-00069-voltage-conversion.md"
DECISION = "ADR-97ebh-battery-telemetry-architecture.md"
PACKS = "FR-00073-several-batteries.md"
PACK = "FR-00074-smart-battery.md"

EDITS = [
    (TELEMETRY, "default 2 Hz", "default 4 Hz", "claim-parameter: SR0_EXTRA1 has the default 2 Hz, not 4"),
    (TELEMETRY, "range 0 to 50 Hz, and 0", "range 0 to 40 Hz, and 0", "claim-parameter: SR0_EXTRA1 has the maximum 50 Hz, not 40"),
    (VOLTAGE, "the default 3.95, the range 1 to 10", "the default 4.95, the range 1 to 10", "has the default 3.95, not 4.95"),
    (VOLTAGE, "the range 1 to 10 and", "the range 2 to 10 and", "claim-parameter: BATT_VOLT_MULT has the minimum 1, not 2"),
    (VOLTAGE, "steps of 0.0001.", "steps of 0.001.", "claim-parameter: BATT_VOLT_MULT has the step 0.0001, not 0.001"),
    (STORAGE, "| 20 | BATT_ARM_VOLT |", "| 0 | BATT_ARM_VOLT |", "claim-parameter: BATT_ARM_VOLT has the index 20, not 0"),
    (STORAGE, "| BATT_ARM_VOLT | MAV_PARAM_TYPE_REAL32, 9 |", "| BATT_ARM_VOLT | MAV_PARAM_TYPE_INT8, 2 |", "BATT_ARM_VOLT is REAL32, not INT8"),
    (STORAGE, "All 39 parameters", "All 13 parameters", "claim-parameter: there are 10 or 39 parameters, not 13"),
    (SERVICES, "The list of 39 parameters", "The list of 13 parameters", "claim-parameter: there are 10 or 39 parameters, not 13"),
    (DECISION, "is streamed at 2 Hz", "is streamed at 3 Hz", "claim-rate: BATTERY_STATUS is sent at 0.5 Hz or 2 Hz, not 3 Hz"),
    (VOLTAGE, "| 3000 | 3.95 | 9.549451 | 9549 |", "| 3000 | 3.95 | 9.549451 | 9559 |", "claim-example: count 3000 is 9549 mV, not 9559"),
    (VOLTAGE, "| 13.035 V |", "| 14.035 V |", "claim-example: full scale is 13.035 V or 3.300 V, not 14.035"),
    (STORAGE, "All 39 parameters, v2 | 1443 bytes", "All 39 parameters, v2 | 999 bytes", "the list of 39 parameters is 1443 bytes, not 999"),
    (TELEMETRY, "| 12000 | 12000 |", "| 12000 | 12001 |", "claim-example: voltages[0] of 12000 is 12000, not 12001"),
    (TELEMETRY, "at 2 Hz, v2 | 96 bytes/s", "at 2 Hz, v2 | 97 bytes/s", "claim-example: BATTERY_STATUS at 2 Hz is 96 bytes/s, not 97"),
    (DECISION, "2 Hz costs 96 bytes/s", "2 Hz costs 97 bytes/s", "97 bytes/s are 48.5 bytes at 2 Hz"),
    (DECISION, "2 Hz costs 96 bytes/s", "2 Hz costs 160 bytes/s", "no message of the document has frames of that size"),
    (DECISION, "`SR0_EXTRA1`, 0 to 50 Hz", "`SR0_EXTRA1`, 0 to 40 Hz", "SR0_EXTRA1 has the maximum 50 Hz, not 40"),
    (PACKS, "beyond the 13.035 V", "beyond the 14.035 V", "claim-full-scale: full scale is 13.035 V, not 14.035"),
    (PACKS, "FR-00074.5", "FR-00074.95", "claim-reference: FR-00074 has no criterion 95"),
    (PACK, "HEARTBEAT is sent at 1 Hz", "HEARTBEAT is sent at 3 Hz", "claim-rate: HEARTBEAT is sent at 1 Hz, not 3 Hz"),
    (PACK, "HEARTBEAT is sent at 1 Hz", "HEARTBEAT is sent twice per second", "HEARTBEAT is sent at 1 Hz, not 2 Hz"),
    (PACK, "HEARTBEAT is sent at 1 Hz", "HEARTBEAT (0) goes out every 500 ms", "HEARTBEAT is sent at 1 Hz, not 2 Hz"),
    (PACK, "HEARTBEAT is sent at 1 Hz", "HEARTBEAT is sent every three seconds", "1 Hz, not every three seconds"),
    (PACK, "HEARTBEAT is sent at 1 Hz", "HEARTBEAT is sent once a minute", "HEARTBEAT is sent at 1 Hz, not once a minute"),
    (DECISION, "`SR0_EXTRA1`, 0 to 50 Hz", "`SR0_EXTRA1` is from 0 to 40 Hz", "SR0_EXTRA1 has the maximum 50 Hz, not 40"),
    (TELEMETRY, "range 0 to 50 Hz, and 0", "range 0..40 Hz, and 0", "claim-parameter: SR0_EXTRA1 has the maximum 50 Hz, not 40"),
]  # fmt: skip


def rounds() -> Iterator[list[tuple[str, str, str, str]]]:
    """The edits, so that each document has at most one in each round: one check finds those of a round."""
    left = EDITS
    while left:
        first = {edit[0]: edit for edit in reversed(left)}
        yield list(first.values())
        left = [edit for edit in left if edit not in first.values()]


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The shipped specification, to be changed and put back."""
    folder = tmp_path_factory.mktemp("own")
    shutil.copytree(ROOT / "specs", folder / "specs")
    return folder


@pytest.mark.parametrize("edits", list(rounds()), ids=lambda edits: f"{len(edits)} documents")
def test_what_is_out_of_date_is_found(
    project: Path, capsys: pytest.CaptureFixture[str], edits: list[tuple[str, str, str, str]]
) -> None:
    """Each as somebody forgets it when a table changes."""
    texts = {}
    for document, old, new, _ in edits:
        path = project / "specs" / "requirements" / document
        texts[path] = path.read_text()
        assert texts[path].count(old) >= 1
        path.write_text(texts[path].replace(old, new))
    try:
        assert main(["check", "--project", str(project)]) == 1
    finally:
        for path, text in texts.items():
            path.write_text(text)
    found = capsys.readouterr().out.splitlines()
    for document, _, _, says in edits:
        assert any(document in line and says in line for line in found), says
