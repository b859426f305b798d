"""The periods of a program's jobs are those of the rates that vehicle.yaml states."""

from pathlib import Path

from codegen.diagnostics import Report
from codegen.project.systems import read_systems

SPECS = Path(__file__).resolve().parents[2] / "specs" / "codegen.yaml"


def test_a_job_is_due_as_often_as_its_rate_says() -> None:
    programs = [system.program for system in read_systems(str(SPECS), Report())]
    periods = [(each.control_us, each.links_us, each.report_ms, each.measure_us) for each in programs if each]
    assert periods == [(2_500, 10_000, 10_000, None), (50_000, 50_000, 10_000, 100_000)]  # 400, 100; 20, 20 and 10 Hz
