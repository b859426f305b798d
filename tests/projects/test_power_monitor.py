"""A pack of which voltage and current are measured, and a tank with a float: what was worked out by hand comes out.

What a count stands for: 3.3 V / 4095 are 0.80586 mV. Voltages times 5; amperes are 17 for each volt above 0.33 V;
percent are 40 for each volt above 0.4 V, and end at 0 and 100.
"""

import json
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent

# mV, cA, hundredths of a percent.
EXPECTED = {
    # 1.649597 V: 8.247985 V; 1.319597 * 17 = 22.433150 A; 1.249597 * 40 = 49.983883 %.
    "half": [8248, 2243, 4998],
    # 16.5 V; 410 counts are 0.330403 V, 0.006850 A; 496 are 0.399707 V, below empty.
    "no current": [16500, 1, 0],
    # -0.33 V * 17 = -5.61 A.
    "charging, empty": [0, -561, 0],
    # (3.3 - 0.33) * 17 = 50.49 A; 2.9 * 40 = 116 %.
    "full scale": [16500, 5049, 10000],
    # 3000 counts are 2.417582 V; 1000 are 0.805861 V, 16.234432 %.
    "one fails": [12088, 5049, 1623],
    "and again": [12092, 5049, None],
    "for the fourth time": [12088, None, 8070],
    # 0.805861 - 0.33 = 0.475861 V: 8.089634 A.
    "and comes back": [12088, 809, 8070],
    # (0.805861 - 1.65) * -20 = 16.882784 A.
    "the other way round, from the middle, at once": [12088, 1688, 8070],
    "voltage only": [12088, None, 8070],
    "nothing of the pack": [None, None, 8070],
}


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The project, built."""
    folder = tmp_path_factory.mktemp("power") / "monitor"
    subprocess.run(["cp", "-r", str(HERE / "power_monitor"), str(folder)], check=True)
    subprocess.run([str(BIN / "codegen"), "build"], cwd=folder, check=True, capture_output=True)
    return folder


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_what_was_measured_is_kept(project: Path, interpreter: str) -> None:
    """In machine code, and in plain Python with words of 32 bits and under CPython."""
    done = subprocess.run(
        [str(BIN / interpreter), "voyage.py"], cwd=project, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == EXPECTED


def test_with_words_of_32_bits_nothing_is_allocated(project: Path) -> None:
    """The checks of single readings, over all counts with the factors that make the largest numbers."""
    script = """
import json, sys
sys.path[:0] = ["generated/firmware", "generated/mocks", "generated/tests"]
import behaviour
checks = [check for _, check in behaviour.CHECKS if "pack_current_" in check.__name__ or "tank_" in check.__name__]
print(json.dumps({check.__name__: behaviour.outcome(check) for check in checks}))
"""
    (project / "on_32_bits.py").write_text(script)
    command = [str(BIN / "micropython32"), "on_32_bits.py"]
    done = subprocess.run(command, cwd=project, capture_output=True, text=True, check=False)
    found = json.loads(done.stdout)
    assert len(found) == 9
    assert set(found.values()) == {None}, found
