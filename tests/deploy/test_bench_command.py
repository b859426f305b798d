"""codegen bench with the real mpremote: a board on a pseudo terminal runs its self-test, and trace takes the result."""

import json
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from as_written import compiled_as_written
from board_on_pty import powered
from in_process import build, codegen

from codegen.cli import main
from codegen.model.bench_record import MEASURES

ROOT = Path(__file__).resolve().parents[2]
PICO = {"_machine": "Raspberry Pi Pico 2 W with RP2350"}
COUNTS = [*[2000] * 5, *[2010] * 5]
"""Readings are the mean of five: there are two values, ten counts apart or, where fives of both are mixed, less."""


@pytest.fixture(scope="module", autouse=True)
def as_written() -> Iterator[None]:
    """What is measured is no matter here."""
    with compiled_as_written():
        yield


def deployed(project: Path, image: Path) -> Path:
    """A flash that has the program of a project, which is built first."""
    build(project)
    with powered(image, told=PICO) as board:
        done = codegen(project, "deploy", "--log", "0", "--port", board.port)
        assert done.returncode == 0, done.stdout + done.stderr
    return image


@pytest.fixture(scope="module")
def rover(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """The rover's project, and a flash with its program."""
    folder = tmp_path_factory.mktemp("rover")
    shutil.copytree(ROOT / "specs", folder / "specs")
    return folder, deployed(folder, folder / "flash")


@pytest.fixture
def bench(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Any:
    """Run codegen bench against a flash; the exit code, the record or None, and what was said."""

    def command(project: Path, image: Path, **settings: Any) -> tuple[int, Any, str]:
        out = tmp_path / "bench.json"
        with powered(Path(shutil.copy(image, tmp_path / "flash")), told=PICO, **settings) as board:
            code = main(["bench", "--project", str(project), "--port", board.port, "--seconds", "1", "--out", str(out)])
        told = capsys.readouterr()
        return code, json.loads(out.read_text()) if out.exists() else None, told.out + told.err

    return command


def test_board_is_measured_and_trace_takes_it(
    rover: tuple[Path, Path], bench: Any, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    """Each measure is there, noise is that of the input; a criterion is shown by it until the specification changes."""
    code, record, said = bench(*rover, counts=COUNTS)
    assert code == 0, said
    assert set(record["measures"]) == set(MEASURES)
    assert 0 < record["measures"]["adc.noise_counts"] == record["measures"]["adc.span_counts"] / 2 <= 5
    assert record["measures"]["heap.steady_bytes"] == 0
    assert record["measures"]["loop.seconds"] == 1
    assert set(record["details"]["frame.mean_us"]) >= {"heartbeat", "battery_status", "battery_cell_voltages"}
    assert record["measures"]["frame.mean_us"] == max(record["details"]["frame.mean_us"].values())
    assert record["board"] == PICO["_machine"]
    assert "battery[1] gives no reading" in said
    assert f"frame.longest_us{'':>2}" in said
    results = tmp_path / "bench.json"
    trace = ["trace", "FR-00068.11", "--project", str(rover[0]), "--results", str(results)]
    main(trace)
    assert f"codegen bench on {PICO['_machine']}  (1 case; 1 passed)" in capsys.readouterr().out
    results.write_text(json.dumps({**record, "inputs": "0" * 16}))
    main(trace)
    assert f"codegen bench on {PICO['_machine']}  (1 case; 1 of another specification)" in capsys.readouterr().out


def test_what_is_not_deployed_is_not_measured(rover: tuple[Path, Path], bench: Any, tmp_path: Path) -> None:
    """A board with other files than the specification makes says nothing about it."""
    project = tmp_path / "changed"
    shutil.copytree(rover[0], project)
    parameters = project / "specs" / "parameters.yaml"
    parameters.write_text(parameters.read_text().replace("default: 3.95", "default: 4", 1))
    code, record, said = bench(project, rover[1], counts=COUNTS)
    assert code == 1
    assert record is None
    assert "error not-deployed: the board has not what the specification makes now: " in said


def test_what_fails_on_the_board_is_told(rover: tuple[Path, Path], bench: Any) -> None:
    """Without a converter no reading is good: that is a note, and no measure is made up."""
    code, record, said = bench(*rover)
    assert code == 0, said
    assert not any(name.startswith("adc.") for name in record["measures"])
    assert "note: battery[0] gives no reading" in said


def test_project_without_a_program_is_measured(bench: Any, tmp_path: Path) -> None:
    """Readings, messages and their heap are measured all the same if the main loop is the user's."""
    project = tmp_path / "project"
    shutil.copytree(ROOT / "tests" / "projects" / "minimal", project)
    code, record, said = bench(project, deployed(project, tmp_path / "image"), counts=COUNTS)
    assert code == 0, said
    assert {"frame.mean_us", "receive.mean_us", "set.mean_us", "heap.free_bytes"} <= set(record["measures"])
    assert record["measures"]["heap.steady_bytes"] == 0
    assert "loop.seconds" not in record["measures"]


def test_page_lists_each_measure() -> None:
    """docs/bench.md, which bench-measure names, has what can be compared."""
    page = (ROOT / "docs" / "bench.md").read_text()
    for name, words in MEASURES.items():
        assert f"| `{name}` | {words} |" in page


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "error bench-format: it is no JSON"),
        ("[" * 100_000, "error bench-format: it is nested too deeply"),
        ("[1]", "error bench-format: it has no format 1"),
        ('{"format": 1}', "error bench-format: it has no project"),
    ],
)
def test_what_codegen_bench_has_not_written_is_refused(
    text: str, message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A file that ends with .json and is none of codegen bench's is told, and shows nothing."""
    results = tmp_path / "bench.json"
    results.write_text(text)
    assert main(["trace", "--project", str(ROOT), "--results", str(results)]) == 2
    assert message in capsys.readouterr().out


def test_measure_that_does_not_exist_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A document that compares a misspelled measure would never be shown: it is a warning with the nearest name."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    document = tmp_path / "specs" / "requirements" / "FR-00068-battery-status-telemetry.md"
    document.write_text(document.read_text().replace("`frame.mean_us < 100`", "`frame.mean_ms < 100`"))
    record = {"format": 1, "measures": {"frame.mean_us": 90.0}, "inputs": "", "program": "", "project": "pico-trail"}
    texts = dict.fromkeys(("codegen", "firmware", "board", "micropython", "taken", "ports"), "")
    results = tmp_path / "bench.json"
    results.write_text(json.dumps({**record, **texts}))
    main(["trace", "--project", str(tmp_path), "--results", str(results)])
    assert "warning bench-measure: codegen bench has no frame.mean_ms" in capsys.readouterr().out
