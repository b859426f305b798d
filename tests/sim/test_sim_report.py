"""The page at the end: well-formed, complete, escaped, and in need of nothing from anywhere."""

import re
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from lxml import etree, html
from packs import VOLTAGE, pack, program, volts

from codegen.loop.load import TrafficLoad
from codegen.model.scenario import Fault, Scenario
from codegen.sim.address import Address
from codegen.sim.chart import NARROW, WIDE, draw_chart
from codegen.sim.process import Runtime
from codegen.sim.record import Recording
from codegen.sim.report import write_report
from codegen.sim.run import Simulation
from codegen.sim.sample import Kind

BUSY = TrafficLoad(Fraction(100_000), {"HEARTBEAT": Fraction(100)}, Fraction(200), Fraction(1), Fraction(2))
"""A tenth of the time without frames, and what a frame and a byte take in us."""
HOSTILE = "<script>alert('x')</script> \"&amp;\" \u2028"


def scenario(*events: Any, doc: str = "d") -> Scenario:
    return Scenario("own", doc, 10_000, 1, (pack((0, 12.0), (10_000, 10.0)),), events)


def recorded(*events: Any, doc: str = "d") -> Recording:
    """Ten seconds with a gap from 4 s to 6 s."""
    played = scenario(*events, doc=doc)
    recording = Recording(played, program(played))
    recording.take({"kind": "start", "at": 0, "runtime": "MicroPython 1"})
    for at_ms in range(0, 10_001, 500):
        known = not 4_000 <= at_ms < 6_000
        recording.at_ms = at_ms
        recording.take_told(volts(12 - at_ms / 5_000 if known else None))
    counts = {"HEARTBEAT": [10, 210], "BATTERY_STATUS": [20, 1000]}
    parameters = {"BATT_LOW_VOLT": 10.5, "BATT_CRT_VOLT": 9.9}
    statistics = {"dropped": 3, "received": 77, "crc_errors": 5, "gaps": 0}
    recording.take({"kind": "messages", "at": 10_000, "counts": counts, "parameters": parameters, **statistics})
    return recording


def written(path: Path, recording: Recording) -> str:
    own = (recording.program,)
    simulation = Simulation(recording.scenario, 10_000, 0.0, Runtime.MICROPYTHON, "", Address("", 1, ""), None, own)
    write_report(str(path / "r.html"), simulation, recording)
    assert [entry.name for entry in path.iterdir()] == ["r.html"]
    return (path / "r.html").read_text(encoding="utf-8")


def rows(page: str) -> list[list[str]]:
    """The text of every row of every table."""
    return [[cell.text_content() for cell in row.iter("th", "td")] for row in html.fromstring(page).iter("tr")]


def test_the_page_is_well_formed(tmp_path: Path) -> None:
    """XML's parser takes it once the elements are closed that HTML does not close."""
    page = written(tmp_path, recorded(Fault(1_000, "fail", VOLTAGE, 2_000, "ADC readings fail")))
    closed = re.sub(r"<((?:meta|wbr)[^>]*)>", r"<\1/>", page).replace("<!doctype html>", "")
    assert etree.fromstring(closed.encode()).tag == "html"


def test_the_page_needs_nothing_from_anywhere(tmp_path: Path) -> None:
    page = written(tmp_path, recorded())
    assert not re.search(r"https?:|src=|href=|url\(|@import|<script|<link", page)


def test_the_data_is_there(tmp_path: Path) -> None:
    recording = recorded()
    recording.add(Kind.ARMED, "", at_ms=2_000)
    recording.add(Kind.FAILSAFE, "Battery 1 low", at_ms=8_000, of=VOLTAGE, word="low")
    page = written(tmp_path, recording)
    found = rows(page)
    assert ["1", "2.0 s", "", "Armed"] in found
    assert ["2", "8.0 s", "", "Failsafe: Battery 1 low"] in found
    assert ["BATTERY_STATUS", "20", "2.00", "100.0", "1000"] in found
    assert ["all", "30", "3.00", "121.0", "1210"] in found
    assert ["Damaged frames received (CRC)", "5"] in found
    assert ["BATT_CRT_VOLT", "9.9"] in found
    assert "The failsafe fired: low at 8.0 s." in page
    for svg in html.fromstring(page).iter("svg"):
        if svg.get("role") == "img":
            assert "The true battery.voltage goes from 12.0 V to 10.0 V in 10.0 s." in svg.get("aria-label", "")


def test_everything_is_escaped(tmp_path: Path) -> None:
    recording = recorded(doc=HOSTILE)
    recording.runtime = HOSTILE
    recording.add(Kind.TEXT, HOSTILE, 3)
    recording.add(Kind.REFUSED, HOSTILE)
    recording.add(Kind.CONSOLE, HOSTILE)
    recording.problem = HOSTILE
    recording.take({"kind": "end", "at": 10_000, "reason": HOSTILE})
    page = written(tmp_path, recording)
    assert "<script" not in page
    assert html.fromstring(page).xpath("//script") == []
    assert page.count("&lt;script&gt;") >= 5


def test_lone_surrogates_do_not_stop_it(tmp_path: Path) -> None:
    assert "x?y" in written(tmp_path, recorded(doc="x\udcffy"))


@pytest.mark.parametrize("size", [WIDE, NARROW])
def test_the_chart_lies_within_its_drawing(size: Any) -> None:
    recording = recorded(Fault(1_000, "slow", VOLTAGE, None, "ADC readings take", 5))
    for at_ms in range(0, 10_000, 50):
        recording.add(Kind.ARMED, "", at_ms=at_ms)
    chart = draw_chart(recording, recording.happenings, size, "wide", recording.lines[0])
    pairs = [tuple(map(float, pair)) for pair in re.findall(r"[ML]([\d.]+) ([\d.]+)", chart.true + chart.reported)]
    assert all(size.left <= x <= chart.size.width - size.right for x, _ in pairs)
    assert all(chart.size.top <= y <= chart.size.height - size.bottom for _, y in pairs)
    assert len(chart.markers) == 40
    assert all(marker.y >= 9 for marker in chart.markers)
    assert chart.reported.count("M") == 2, "it breaks where the voltage was unknown"
    assert [tick.label for tick in chart.time_ticks][:2] == (["0", "1"] if size is WIDE else ["0", "5"])
    assert [level.label for level in chart.levels] == ["BATT_LOW_VOLT 10.5 V", "BATT_CRT_VOLT 9.9 V"]


def test_true_and_reported_lie_on_each_other() -> None:
    recording = recorded()
    chart = draw_chart(recording, [], WIDE, "wide", recording.lines[0])
    (start, end) = re.findall(r"([\d.]+) ([\d.]+)", chart.true)
    slope = (float(end[1]) - float(start[1])) / (float(end[0]) - float(start[0]))
    for x, y in re.findall(r"([\d.]+) ([\d.]+)", chart.reported):
        assert float(y) == pytest.approx(float(start[1]) + slope * (float(x) - float(start[0])), abs=0.2)


@pytest.mark.parametrize("at_ms", [0, 1, 999, 59_000, 3_600_000, 86_400_000])
def test_a_chart_of_any_length_has_some_labels(at_ms: int) -> None:
    recording = Recording(scenario(), program(scenario()))
    recording.at_ms = at_ms
    for size in (WIDE, NARROW):
        chart = draw_chart(recording, [], size, "wide", recording.lines[0])
        assert 1 <= len(chart.time_ticks) <= size.ticks + 1
        assert 2 <= len(chart.value_ticks) <= 12
        assert len({tick.label for tick in chart.value_ticks}) == len(chart.value_ticks)


def test_a_report_without_anything(tmp_path: Path) -> None:
    """The firmware did not even start."""
    recording = Recording(scenario(), program(scenario()))
    recording.problem = "the firmware stopped"
    page = written(tmp_path, recording)
    assert "It failed at 0.0 s: the firmware stopped." in page
    assert "Nothing happened." in page


def test_a_report_that_cannot_be_written_leaves_the_old_one(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    written(tmp_path, recorded())

    def fail(*_: object) -> None:
        raise OSError("full")

    monkeypatch.setattr("os.replace", fail)
    with pytest.raises(OSError, match="full"):
        written(tmp_path, recorded(doc="new"))
    assert [entry.name for entry in tmp_path.iterdir()] == ["r.html"]


def test_the_load_of_the_board_is_that_of_what_went_out(tmp_path: Path) -> None:
    """On the whole, and in the second in which most went out; where nothing predicts it, it says why."""
    recording = recorded()
    recording.program = replace(recording.program, load=BUSY)
    for at_ms, frames, size in ((9_000, 10, 210), (9_500, 12, 300), (10_000, 30, 1210)):
        recording.take({"kind": "sample", "at": at_ms, "frames": frames, "bytes": size, "overruns": 0})
    # 10 frames for 100 us, 20 for 200 us, 1210 bytes, 77 that arrived; then 20 frames and 1000 bytes in a second.
    assert float(BUSY.share({"HEARTBEAT": 10, "BATTERY_STATUS": 20}, 1210, 77, 10_000)) == pytest.approx(0.1006364)
    assert ["Load of the board, predicted", "10.1 %, 10.4 % in the busiest second"] in rows(
        written(tmp_path, recording)
    )


def test_a_load_that_nothing_predicts_says_why(tmp_path: Path) -> None:
    """No number stands in for it."""
    recording = recorded()
    recording.program = replace(recording.program, load="no board is named")
    assert ["Load of the board, predicted", "unknown: no board is named"] in rows(written(tmp_path, recording))
