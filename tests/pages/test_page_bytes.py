"""The bytes on the pages: pymavlink takes each frame, and every drawing has the bytes of the frame under its text."""

import importlib.util
import json
import math
from collections.abc import Iterator
from dataclasses import replace
from types import ModuleType

import pytest
from lxml import html
from pymavlink.dialects.v10 import common
from rendered import ROOT, Program

from codegen.model.price import frame_size
from codegen.model.system import PopulatedMessage
from codegen.summaries.fields import field_rows
from codegen.targets.pages.example_state import ExampleState, example_states
from codegen.targets.pages.frame import sent_frame
from codegen.targets.pages.navigation import message_path
from codegen.targets.pages.value_text import is_unknown
from codegen.targets.suite.expected import Wire, expected_fields


@pytest.fixture(scope="module")
def dialect() -> ModuleType:
    """pymavlink's module of the shipped dialect, with the overlays and what corrections change of the wire."""
    spec = importlib.util.spec_from_file_location("oracle", ROOT / "templates/tests/oracle.py")
    assert spec is not None
    assert spec.loader is not None
    oracle = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(oracle)
    tests = ROOT / "generated/tests"
    cases = json.loads((tests / "cases.json").read_text())
    names = {case["message"] for case in cases["messages"]}
    module: ModuleType = oracle.dialects(cases["dialect"], names, tests)[0]
    return module


def shown(program: Program) -> Iterator[tuple[PopulatedMessage, ExampleState, html.HtmlElement]]:
    """Every map of a program, with what it shows."""
    for message in program.system.messages:
        maps = program.page(message_path(message.name)).xpath("//div[@class='map']")
        states = example_states(message, program.system)
        assert len(maps) == len(states)
        for state, drawn in zip(states, maps, strict=True):
            assert drawn.xpath("h3/text()") == [state.label]
            yield message, state, drawn


def frame_of(drawn: html.HtmlElement) -> bytes:
    return bytes.fromhex(drawn.xpath(".//code[@class='hexdump']/text()")[0])


def test_pymavlink_takes_every_frame(shipped: list[Program], dialect: ModuleType) -> None:
    """Checksum, length and cut zeros are right, and each field comes out as the specification computes it."""
    count = 0
    for program in shipped:
        for message, state, drawn in shown(program):
            decoded = dialect.MAVLink(None).decode(bytearray(frame_of(drawn)))
            assert (decoded.get_type(), decoded.get_srcSystem()) == (message.name, program.system.system_id)
            assert decoded.get_srcComponent() == program.system.component_id
            for name, value in expected_fields(message, state.known).items():
                assert same(getattr(decoded, name), value), f"{message.name}.{name}, {state.label}"
            count += 1
    assert count > 20


def same(found: object, expected: Wire) -> bool:
    if isinstance(expected, float):
        assert isinstance(found, float)
        return math.isnan(found) if math.isnan(expected) else math.isclose(found, expected, rel_tol=1e-6)
    if isinstance(expected, list):
        assert isinstance(found, list)
        return all(same(one, other) for one, other in zip(found, expected, strict=True))
    return found == expected


def test_drawings_have_every_byte_in_the_order_of_the_wire(every: list[Program], longest: Program) -> None:
    """The payload is whole, the part of it that is marked as not sent is what the frame lacks."""
    for program in (*every, longest):
        is_v2 = program.system.spec.project.protocol == 2
        for message, state, drawn in shown(program):
            frame = frame_of(drawn)
            payload = drawn.xpath(".//svg[@class='payload']")
            data = bytes.fromhex("".join(hex_text for block in payload for hex_text in words(block)))
            whole = message.wire.length if is_v2 else message.wire.base_length
            cut = sum(float(width) for width in drawn.xpath(".//svg//rect[@class='cut']/@width")) / 30
            assert len(data) == whole, message.name
            assert data[: frame[1]] == frame[10 if is_v2 else 6 : -2]
            assert (data[frame[1] :], cut) == (bytes(whole - frame[1]), whole - frame[1]), state.label
            header = "".join(hex_text for block in drawn.xpath(".//svg[@class='frame']") for hex_text in words(block))
            assert bytes.fromhex(header) == frame[: 10 if is_v2 else 6] + frame[-2:]
            assert f"Frame {len(frame)} bytes" in drawn.xpath("string(p)")


def words(block: html.HtmlElement) -> list[str]:
    return [str(text) for text in block.xpath(".//text[@class='hex']/text()")]


def test_frames_lie_within_what_the_budget_counts(every: list[Program]) -> None:
    for program in every:
        for message, state, drawn in shown(program):
            size = frame_size(message, 0, program.system.spec.project.protocol)
            assert size.low <= len(frame_of(drawn)) <= size.high, f"{message.name}, {state.label}"


def test_the_boundary_stands_before_the_first_extension(shipped: list[Program]) -> None:
    for program in shipped:
        for message, _, drawn in shown(program):
            places = [
                int(block.xpath("text[1]/text()")[0].split()[0]) + (float(path[1 : path.index(" ")]) - 1) / 30
                for block in drawn.xpath(".//svg[@class='payload']")
                for path in block.xpath("path[@class='boundary']/@d")
            ]
            expected = [message.wire.base_length] if message.wire.base_length < message.wire.length else []
            assert places == expected, message.name


def test_each_element_is_told_with_its_value(shipped: list[Program]) -> None:
    """By the title that browsers show and read out: the pack at 12 V, and what nothing is known of."""
    drawn = next(drawn for message, _, drawn in shown(shipped[0]) if message.name == "BATTERY_STATUS")
    titles = drawn.xpath(".//svg[@class='payload']//title/text()")
    assert "voltages[0], uint16_t, bytes 10 to 11: e0 2e = 12000 mV" in titles
    assert "voltages[9], uint16_t, bytes 28 to 29: ff ff = unknown, as 65535 mV" in titles
    assert "type, uint8_t, byte 34: 01 = MAV_BATTERY_TYPE_LIPO (1)" in titles
    assert "battery_remaining, int8_t, byte 35: ff = unknown, as -1 %" in titles
    assert "fault_bitmask, uint32_t, bytes 50 to 53: 00 00 00 00 = no flag (0x0)" in titles
    hatched = drawn.xpath(".//svg[@class='payload']//g[rect[@class='hatch']]/title/text()")
    assert sorted(hatched) == sorted(title for title in titles if "= unknown" in title)


def test_fields_that_are_unknown_differ_with_the_state(shipped: list[Program]) -> None:
    """A measured field is not marked as unknown, and becomes so when nothing is measured."""
    by_label = {state.label: drawn for message, state, drawn in shown(shipped[0]) if message.name == "SYS_STATUS"}
    known, start, _ = ("\n".join(drawn.xpath(".//g[rect[@class='hatch']]/title/text()")) for drawn in by_label.values())
    assert next(iter(by_label)) == "battery.voltage 12 V, battery.current 53 A, all else as at the start"
    assert "voltage_battery" not in known
    assert "voltage_battery" in start
    assert "current_battery" not in known
    assert "current_battery" in start


@pytest.mark.parametrize(
    ("name", "values", "unknown"),
    [
        ("ODOMETRY.pose_covariance", [math.nan] * 21, [0, 20]),  # [NaN:], the first speaks for all
        ("ODOMETRY.pose_covariance", [1.0, *[math.nan] * 20], []),
        ("BATTERY_STATUS.voltages", [12000, *[65535] * 9], [1, 9]),  # [UINT16_MAX], each for itself
        ("GPS_RAW_INT.eph", 65535, [0]),
        ("GPS_RAW_INT.eph", 99, []),
        ("HEARTBEAT.custom_mode", 0, []),  # has none
    ],
)
def test_unknown_is_what_the_sentinel_says(longest: Program, name: str, values: Wire, unknown: list[int]) -> None:
    message, _, field_name = name.partition(".")
    field = longest.system.dialect.messages[message].field(field_name)
    assert field is not None
    found = [index for index in range(field.count) if is_unknown(field, index, values)]
    assert (found[:1], found[-1:]) == (unknown[:1], unknown[-1:])


def test_a_version_1_frame_is_whole(longest: Program) -> None:
    """Without extensions, signature and cut; what pymavlink makes of the same values is the same."""
    system = longest.system
    project = replace(system.spec.project, protocol=1)
    system = replace(system, spec=replace(system.spec, project=project))
    message = next(message for message in system.messages if message.name == "FILE_TRANSFER_PROTOCOL")
    frame = sent_frame(message, expected_fields(message, {}), system)
    decoded = common.MAVLink(None).decode(bytearray(frame.data))
    assert (decoded.get_type(), len(frame.data), frame.sent) == ("FILE_TRANSFER_PROTOCOL", 262, 254)


def test_rows_and_ways_are_those_of_the_table(every: list[Program]) -> None:
    """Each row of the table stands on the page, and its way ends at its bytes."""
    for program in every:
        for message in program.system.messages:
            page = program.page(message_path(message.name))
            table = [[cell.text_content() for cell in row] for row in page.xpath("//table[@id='fields']/tbody/tr")]
            rows = field_rows(message)
            ends = page.xpath("//div[@class='way']//li[@class='wire']")
            assert len(table) == len(rows) == len(ends)
            for number, (cells, row, end) in enumerate(zip(table, rows, ends, strict=True), 1):
                assert cells[:4] == [str(number), row.field, str(row.offset), str(row.size)]
                assert cells[7:11] == [row.conversion, row.limits, row.sentinel, row.criterion]
                assert (cells[11], row.place.file) == (f"line {row.place.line}", message.population.place.file)
                last = row.offset + row.size - 1
                assert (f"byte {last}" if row.size == 1 else f"bytes {row.offset} to {last}") in end.text_content()


def test_the_way_of_the_voltage_has_every_step(shipped: list[Program]) -> None:
    page = shipped[0].page("messages/battery_status_v2.html")
    (way,) = [way for way in page.xpath("//div[@class='way']") if way.xpath("string(h3)").startswith("voltage ")]
    kinds = [str(item.get("class")) for item in way.xpath(".//li")]
    assert kinds == ["sensor", "conversion", "state", "unit", "limits", "unknown", "wire"]
    text = way.text_content()
    for part in ("GPIO 26 and 27", "mean of 5 samples", "count / 4095 * 3.3 V * BATT_VOLT_MULT", "3.95 by default",
                 "voltage_mv, in mV", "5 failed readings", "mV * 0.001 = V", "NaN", "float, bytes 0 to 3"):  # fmt: skip
        assert part in text, part
    assert {"FR-00066.2", "FR-00069.2", "FR-00067.3"} <= set(way.xpath(".//a/text()"))


def test_the_way_of_cells_tells_of_the_pack_and_of_single_cells(shipped: list[Program]) -> None:
    """The pack's voltage comes from the ADC; the cells go out in its place while all of them are known."""
    page = shipped[0].page("messages/battery_status.html")
    (way,) = [way for way in page.xpath("//div[@class='way']") if way.xpath("string(h3)").startswith("voltages ")]
    assert way.xpath(".//li/@class") == ["sensor", "conversion", "state", "instead", "limits", "unknown", "wire"]
    for part in ("each of battery.cells", "no more than 14", "above 65534 spills", "65535, the dialect's [UINT16_MAX]"):
        assert part in way.text_content(), part


def test_each_byte_stands_in_the_middle_of_its_cell(shipped: list[Program]) -> None:
    """Cells are 30 wide, and lie side by side in each row; what is only in a signed frame has no bytes yet."""
    for program in shipped:
        for message, _, drawn in shown(program):
            for block in drawn.xpath(".//svg"):
                middles = [float(x) for x in block.xpath(".//text[@class='hex']/@x")]
                assert middles in ([], [16 + 30 * at for at in range(len(middles))]), message.name
                cells = [(float(each.get("x")), float(each.get("width"))) for each in block.xpath(".//g/rect[1]")]
                ends = [1.0, *(x + width for x, width in cells)]
                assert [x for x, _ in cells] == ends[:-1], message.name
                assert not middles or ends[-1] == 1 + 30 * len(middles), message.name
