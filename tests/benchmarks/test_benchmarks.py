"""The benchmarks run, their contestants agree byte for byte, and the report is honest. No time is judged here."""

import json
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import pytest
import report
import results

BENCHMARKS = Path(__file__).resolve().parents[2] / "benchmarks"

OVER_C = {
    "frame": {"values_over_c", "state_over_c", "bytecode_values_over_c", "bytecode_state_over_c"},
    "parse": {"objects_over_c", "classes_over_c", "bytecode_over_c"},
}
KEYS = {
    "frame": {
        *OVER_C["frame"],
        "pack_over_values",
        "pack_over_state",
        "pack_over_bytecode_values",
        "fresh_pack_over_values",
        "fresh_pack_table_over_values",
        "pymavlink_over_cpython",
        "plain_pymavlink_over_cpython",
        "values_allocated",
        "state_allocated",
        "bytecode_values_allocated",
        "bytecode_state_allocated",
        "pack_allocated",
    },
    "parse": {
        *OVER_C["parse"],
        "objects_over_machine",
        "bytecode_over_machine",
        "cpython_over_pymavlink",
        "cpython_over_plain_pymavlink",
        "objects_allocated",
        "bytecode_allocated",
        "classes_allocated",
        "machine_allocated",
    },
    "generator": {
        "codec_common_over_mavgen",
        "codec_common_memory_over_mavgen",
        "codec_common_on_disk_over_mavgen",
        "codec_common_over_hasty",
        "codec_common_memory_over_hasty",
        "codec_common_first_over_mavgen",
        "codec_common_first_over_hasty",
        "build_first_over_mavgen",
        "build_edited_first_over_mavgen",
        "build_cold_over_mavgen",
        "build_unchanged_over_mavgen",
        "build_edited_over_mavgen",
        "check_over_mavgen",
        "check_edited_over_mavgen",
        "check_table_over_mavgen",
        "check_first_over_mavgen",
        "diff_over_mavgen",
        "diff_first_over_mavgen",
        "diff_releases_over_mavgen",
        "diff_releases_first_over_mavgen",
        "version_over_python",
        "help_over_python",
        "slope_10_20",
        "slope_20_30",
        "time_10_20",
        "time_20_30",
    },
    "size": {
        f"{part}_{number}_{where}"
        for part in ("messages", "codec")
        for number in ("1", "12")
        for where in ("armv6m", "armv7emsp", "bytecode", "heap")
    },
    "simulation": {"rover_micropython", "rover_cpython"},
}


def run(script: str, *options: object) -> str:
    """Return the output of a benchmark; it fails if its contestants do not agree."""
    command = [sys.executable, "-B", str(BENCHMARKS / f"{script}.py"), *map(str, options)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.long
@pytest.mark.parametrize("script", KEYS)
def test_everybody_does_the_same(script: str, tmp_path: Path) -> None:
    """Each script ends with an error if the frames, or the values of the messages, differ."""
    printed = run(script, "--quick", "--json", tmp_path / "figures.json")
    content = json.loads((tmp_path / "figures.json").read_text())
    figures = {figure["key"]: figure for figure in content["figures"]}
    assert figures.keys() == KEYS[script]
    assert content["compares"].strip() in printed
    for key, figure in figures.items():
        assert figure["measure"] in printed
        if key in OVER_C.get(script, ()) and shutil.which("cc") is None:
            assert figure["value"] is None
            assert figure["note"] in printed
        else:
            assert figure["value"] is not None


def figure(key: str, value: float | None, **others: Any) -> dict[str, Any]:
    """A figure as the scripts write it."""
    return {"key": key, "measure": f"our {key}", "against": "theirs", "value": value, **others}


def test_the_report_says_what_was_found(tmp_path: Path) -> None:
    """Targets that are met, targets that are not, what could not be measured; nothing about this computer."""
    found = {
        "cost": [figure("battery_status", 3000.0, unit="instructions", most=2999)],
        "frame": [figure("values_over_c", 3.456, most=4), figure("state_over_c", None, most=10, note="no cc here")],
        "parse": [figure("objects_over_c", 0.125, least=0.2)],
        "generator": [figure("build_unchanged_over_mavgen", 0.25, most=0.5), figure("slope", 7.0, unit="ms")],
        "size": [figure("heap", 4321, unit="bytes", most=4000), figure("allocated", 0, unit="bytes", most=0)],
        "heap": [figure("smallest", 130, unit="KB", most=130)],
        "heap_modules": [figure("messages", 4000, unit="bytes")],
        "simulation": [figure("rover_micropython", 150.0, least=144)],
    }
    for name, figures in found.items():
        content = {"compares": f"What {name} compares.", "figures": figures, "sources": "0"}
        (tmp_path / f"{name}.json").write_text(json.dumps(content))
    (tmp_path / "versions.json").write_text(json.dumps({"MicroPython": "1.2.3"}))
    printed = run("report", "--stored", "--results", tmp_path, "--out", tmp_path / "docs")
    page = (tmp_path / "docs" / "benchmarks.md").read_text()
    for row in (
        "| our battery_status | 3000 | <= 2999 | not met | 4020 | 26.8 | 38.0 |",
        "| our values_over_c | theirs | 3.46 times | <= 4.00 | met |",
        "| our state_over_c | theirs | not measured: no cc here | <= 10.0 |  |",
        "| our objects_over_c | theirs | 0.12 times | >= 0.20 | not met |",
        "| our build_unchanged_over_mavgen | theirs | 0.25 times | <= 0.50 | met |",
        "| our heap | theirs | 4321 bytes | <= 4000 | not met |",
        "| our allocated | theirs | 0 bytes | 0 | met |",
    ):
        assert row in page.splitlines()
    assert "5 of 8 targets are met." in page
    assert "5 of 8 targets are met." in printed
    assert "- our heap, against theirs: 4321 bytes instead of <= 4000" in page.splitlines()
    assert "- MicroPython 1.2.3" in page.splitlines()
    assert "slope" not in page
    assert all(f"What {name} compares." in page for name in found)
    assert not re.search(r"20\d\d|/home|/work|/tmp", page)

    svg = ET.parse(tmp_path / "docs" / "benchmarks.svg").getroot()  # noqa: S314  written a moment ago
    texts = ["".join(text.itertext()) for text in svg.iter("{http://www.w3.org/2000/svg}text")]
    bars = [bar.get("class") for bar in svg.iter("{http://www.w3.org/2000/svg}rect")]
    assert {"3.46", "8.00 not met", "1/4.00"} <= set(texts)
    assert bars == ["bar", "missed", "bar"]


def test_stored_figures_of_other_sources_are_told(tmp_path: Path) -> None:
    """Figures measured before a change are named; those measured since are not."""
    for name in report.TITLES:
        sources = "0" if name in ("frame", "size") else results.fingerprint()
        results.write(tmp_path / f"{name}.json", results.Result("Compares.", (), sources))
    told = run("report", "--state", "--results", tmp_path)
    assert "codegen/ or templates/ changed since these were measured: frame, size." in told
    for name in ("frame", "size"):
        results.write(tmp_path / f"{name}.json", results.Result("Compares.", (), results.fingerprint()))
    assert "changed" not in run("report", "--state", "--results", tmp_path)


def test_every_file_of_the_sources_counts(tmp_path: Path) -> None:
    """Another content, another name and a new file are another fingerprint; what Python compiled is not."""

    def fingerprint() -> str:
        return results.fingerprint(["a", "b"], tmp_path)

    for name in ("a/one.py", "b/two.j2"):
        (tmp_path / name).parent.mkdir()
        (tmp_path / name).write_text("x")
    seen = [fingerprint()]
    (tmp_path / "b" / "two.j2").write_text("y")
    seen.append(fingerprint())
    (tmp_path / "b" / "two.j2").rename(tmp_path / "b" / "three.j2")
    seen.append(fingerprint())
    (tmp_path / "b" / "four.py").write_text("")
    seen.append(fingerprint())
    assert len(set(seen)) == len(seen)
    (tmp_path / "a" / "one.cpython-311.pyc").write_text("z")
    assert fingerprint() == seen[-1]


def test_the_page_shows_what_is_stored() -> None:
    """docs/ and benchmarks/results say the same: python benchmarks/report.py --stored writes the page anew."""
    for name, text in report.written(report.stored(results.FOLDER), results.read_versions()).items():
        assert (report.measure.ROOT / "docs" / name).read_text(encoding="utf-8") == text
