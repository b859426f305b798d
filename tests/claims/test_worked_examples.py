"""Worked examples are recomputed from the specification: what is wrong is found, and what says too little is left alone."""

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from codegen.claims import check_claims
from codegen.claims.own.worked.amount import amounts
from codegen.claims.reading import Reference, read_document
from codegen.cli import main
from codegen.commands.document_findings import project_documents
from codegen.commands.documents import example_numbers, project_reference
from codegen.diagnostics import Report
from codegen.project.systems import read_systems

ROOT = Path(__file__).resolve().parents[2]
HEAD = "# Notes\n\n## Worked Examples\n\n"

Check = Callable[[str], list[str]]


@pytest.fixture(scope="module")
def own() -> tuple[Reference, list[str]]:
    """What the shipped specification says, and its documents."""
    systems = read_systems(str(ROOT / "specs" / "codegen.yaml"), Report())
    found = project_reference(systems)
    assert found is not None
    return found, project_documents(systems)


@pytest.fixture(scope="module")
def check(own: tuple[Reference, list[str]]) -> Check:
    """What is found in the worked examples of a text, against the shipped specification."""
    return lambda text: [
        finding.message for finding in check_claims(read_document(HEAD + text, "/documents/notes.md", own[0]))
    ]


def table(*rows: str) -> str:
    """A table of rows whose columns are separated by bars."""
    head, *others = rows
    return "\n".join(f"| {row} |" for row in (head, "|".join([" --- "] * (head.count("|") + 1)), *others)) + "\n"


def claim(label: str, value: str) -> str:
    return table("Claim | Value", f"{label} | {value}")


CASES = [
    # counts of the converter
    (table("Count | BATT_VOLT_MULT | Exact (V) | Rounded (mV)", "3770 | 3.95 | {} | 12000"), "12.000476", "12.000477"),
    (table("Count | BATT_VOLT_MULT | Exact (V) | Rounded (mV)", "3000 | {} | 9.549451 | 9549"), "3.95", "3.96"),
    (table("Count | BATT_AMP_PERVLT | BATT_AMP_OFFSET | Rounded (cA)", "0 | 17 | 0.33 | {}"), "-561", "-562"),
    ("With `BATT_VOLT_MULT` 10:\n\n" + table("Count | Converted (mV)", "4095 | {}"), "33000", "13035"),
    (table("Count | Converted (mV) | Below 10.5 V", "3298 | 10498 | {}"), "yes", "no"),
    (table("Voltage | Nearest count | Converted (mV)", "12.6 V | {} | 12599"), "3958", "3959"),
    ("One count of the ADC is {} mV.\n", "3.183", "3.193"),
    ("One count of the converter is {} mV at its pin.\n", "0.806", "0.816"),
    ("At the default multiplier of {}:\n\n" + table("Count | Converted (mV)", "3000 | 9549"), "3.95", "3.96"),
    (claim("Full scale at the default multiplier", "{} V"), "13.035", "13.036"),
    (claim("Full scale at the pin", "{} V"), "3.3", "3.4"),
    (claim("Count 3770 with the calibrated 4.0158", "{} mV"), "12200", "12201"),
    # sizes and streams
    (table("Message | Payload, base | Payload, extended", "BATTERY_STATUS | 36 | {}"), "54", "55"),
    (table("Message | Number | Frame (v1)", "HEARTBEAT, the rover's | {} | 17"), "0", "1"),
    (table("Message | Payload sent (v2) | Frame (v2)", "STATUSTEXT, 34 characters | {} | 47"), "35", "36"),
    (table("Message | Payload sent (v2) | Frame (v2)", "BATTERY_STATUS | 36 | {}"), "48", "49"),
    (claim("BATTERY_STATUS at 2 Hz, v2", "{} bytes/s"), "96", "97"),
    (claim("HEARTBEAT at 1 Hz and PARAM_VALUE at 10 Hz", "{} bytes/s"), "391", "392"),
    (claim("HEARTBEAT at 2 Hz, v1", "{} bytes/s"), "34", "42"),
    (claim("Largest unsigned BATTERY_STATUS frame, v2", "{} bytes"), "66", "65"),
    (claim("PARAM_VALUE, frame (v2)", "{} bytes"), "37", "36"),
    (claim("The list of 39 parameters, v2", "{} bytes"), "1443", "1444"),
    (claim("All 39 parameters over a UART of 57600 baud (10 bits per byte)", "{} ms"), "250.5", "250.6"),
    (claim("Length of `Battery 1 is low`", "{} characters"), "16", "17"),
    # fields
    (table("Voltage (mV) | voltages[0] | voltages[1..9]", "12000 | {} | 65535"), "12000", "12001"),
    (table("Voltage (mV) | voltages[0] | voltages[1]", "65535 | 65534 | {}"), "1", "2"),
    (table("Current | current_battery", "-0.01 A (charging) | {}"), "-2", "-1"),
    # parameters
    (table("PARAM_SET | Value answered", "BATT_VOLT_MULT 4.01583 | {}, the nearest step"), "4.0158", "4.0159"),
    (table("PARAM_SET | Value answered", "BATT_LOW_TIMER {} | the old one"), "121", "120"),
    (table("PARAM_SET | Value answered", "BATT_LOW_TIMER {} | 120"), "120", "121"),
    (table("PARAM_SET | Value answered", "BATT_MONITOR 5 | the old one: only 0, 3, 4 and {} are accepted"), "29", "30"),
    (table("`BATT_MONITOR` | Measured", "{}, analog voltage only | yes"), "3", "4"),
    (table("Cells | Default of `BATT_LOW_VOLT`", "4 | {} V"), "14.0", "14.1"),
    (table("Name | Type", "BATT_MONITOR | MAV_PARAM_TYPE_INT8, {}"), "2", "3"),
    ("The parameters are numbered by their names, those of the second (BATT2_) from 1 to {}.\n", "16", "17"),
    # numbers of one row
    (table("Samples (counts) | Sum | Mean | Reading (counts)", "1, 2, 3, 5 | {} | 2.75 | 3"), "11", "12"),
    (table("Samples (counts) | Sum | Mean | Reading (counts)", "1, 2, 3, 5 | 11 | 2.75 | {}"), "3", "2"),
    (table("`read_u16()` | Count (12 bits)", "48000 | {}"), "3000", "3001"),
    (table("Pack (V) | Per cell (3 cells)", "12.6 | {} V"), "4.2", "4.3"),
    (table("Pack (V) | Per cell ({} cells)", "12.6 | 4.2 V"), "3", "4"),
    (table("Pack (V) | Per cell ({} cells)", "unknown | unknown"), "3", "4"),
    (table("Chunk | Frame (v2)", "0 | 64", "1 | 66") + "\n" + claim("Both together", "{} bytes"), "130", "131"),
    # times and rates
    (claim("Period of the main loop at 400 Hz", "{} ms"), "2.5", "2.6"),
    (claim("Period of the main loop at {} Hz", "2.5 ms"), "400", "401"),
    (claim("Share of one pass taken by a reading of 2 ms", "{} %"), "80", "81"),
    (claim("Share of the processor taken by readings of 2 ms at 10 Hz", "{} %"), "2", "3"),
    (claim("Readings missed within 1 s at 10 Hz", "{}"), "10", "11"),
    (claim("From the last good reading to the fifth failure at 10 Hz", "{} s"), "0.5", "0.6"),
    (claim("Conversion time of 5 samples at 500000 samples per second", "{} us"), "10", "11"),
    (claim("Control slots in one day", "{}"), "34560000", "34560001"),
    (claim("Drift in one day of a loop that adds 10 us to each period", "{} s"), "345.6", "345.7"),
    (claim("Control slots from one battery update to the next", "{}"), "40", "41"),
    (claim("Slots within one turn of `ticks_us()`", "{}"), "429496.7296", "429496.7297"),
    (claim("Slots within one turn of `ticks_ms()`", "{}"), "429496729.6", "429496729.7"),
    (claim("Frames (48 bytes) that a full buffer of 1024 bytes holds", "{}"), "21", "22"),
    (claim("Link at 57600 baud, 10 bits per byte", "{} bytes/s"), "5760", "5761"),
    (
        table("Claim | Value", "Link at 57600 baud, 10 bits per byte | 5760 bytes/s", "A | 160 bytes/s, {} % of that link"),
        *("2.8", "2.9"),
    ),
    # the same in another way
    (claim("Wrap of `ticks_us()` at 2^30 us", "{} s"), "1073.741824", "1073.741825"),
    (claim("128 KB", "{} bytes"), "131072", "131073"),
    (claim("3.95 as a float of 32 bits", "{}"), "3.9500000477", "3.9500000478"),
    (claim("The number of a restart as a float of 32 bits", "{}, exact"), "20190226", "20190227"),
    (claim("The force number of arming as a float of 32 bits", "{}, exact"), "21196", "21197"),
    (claim("Parts of a centiampere for a millisecond in 1 mAh", "{}"), "360000", "360001"),
    ("It is `new = old * meter / reading`.\n\n" + claim("old 3.95, meter 12.20 V, reading 12.00 V", "{}"), "4.0158", "4.0159"),
    (claim("Largest intermediate of `count * 3300 * steps`", "{}"), "1351350000000", "1351350000001"),
    # the main loop, curves, stores, trends, intervals, chunks
    (table("Slot | Time", "0 | 0 ms", "40 | 100 ms", "1 to 39 | 2.5 ms to {} ms"), "97.5", "97.6"),
    (table("Duration of the pass | Next pass | Its slot | Slots missed | Pass after that", "5.1 ms | 5.1 ms | 2 | {} | 7.5 ms"), "1", "2"),
    (table("Chemistry | Per cell (V) | Between the points | Remaining", "MAV_BATTERY_TYPE_LIPO | 4.00 | 3.95: 70 and 4.02: 80 | {}"), "77", "78"),
    (table("Chemistry | Per cell (V) | Between the points | Remaining", "MAV_BATTERY_TYPE_LIPO | 4.00 | 3.95: {} and 4.02: 80 | 77"), "70", "71"),
    ("What is left of `BATT_CAPACITY` 3300 mAh:\n\n" + table("Drawn (mAh) | Left (mAh) | Left (%)", "17 | {} | 99"), "3283", "3284"),
    ("What is left of `BATT_CAPACITY` 3300 mAh:\n\n" + table("Drawn (mAh) | Left (mAh) | Mean (A) | Time (s)", "1650 | 1650 | 10 | {}"), "594", "595"),
    (table("Readings | Trend (V/s)", "40 on a ramp of -5 mV per reading | {}"), "-0.05", "-0.06"),
    (table("Readings | Trend (V/s)", "{} at 12.000 V | unknown"), "39", "40"),
    (claim("Distance between the middles of the two halves", "{} s"), "2", "3"),
    (table("SET_MESSAGE_INTERVAL for BATTERY_STATUS | In force", "{} us, 200 Hz | 50 Hz, the highest of the stream"), "5000", "5001"),
    (table("SET_MESSAGE_INTERVAL for BATTERY_STATUS | In force", "5000 us, 200 Hz | {} Hz, the highest of the stream"), "50", "51"),
    (
        "A text of 70 characters with the number 1 goes out in two chunks:\n\n"
        + table("Chunk | Characters | Frame (v2)", "0 | 50 | 64", "1 | {} | 66"),
        *("20", "21"),
    ),
]  # fmt: skip


@pytest.mark.parametrize(("text", "right", "wrong"), CASES, ids=[case[0][-40:].strip(" |\n") for case in CASES])
def test_a_number_that_follows_is_recomputed(check: Check, text: str, right: str, wrong: str) -> None:
    assert check(text.replace("{}", right)) == []
    assert len(check(text.replace("{}", wrong))) >= 1


def test_an_answer_to_a_parameter_is_told_by_what_is_set(check: Check) -> None:
    text = table("PARAM_SET | Value answered", "BATT_VOLT_MULT 4.01583 | 4.0159, the nearest step")
    (told,) = check(text)
    assert "the answer to BATT_VOLT_MULT 4.01583 is 4.0158, not 4.0159" in told


LEFT_ALONE = [
    pytest.param(table("Count | Price (USD)", "3000 | 12"), id="counts of something else"),
    pytest.param(claim("BATTERY_STATUS at 2 Hz, signed", "122 bytes/s"), id="signed frames"),
    pytest.param(claim("COMMAND_LONG, frame (v2)", "44 bytes"), id="a frame whose zeros are cut"),
    pytest.param(claim("BATTERY_STATUS_V2 of the draft, base payload", "24 bytes"), id="a message of a draft"),
    pytest.param(claim("Share of the charge used in 10 s", "5 %"), id="a share of something else"),
    pytest.param(table("Silence | Retry", "10 s | 2500 ms"), id="two amounts that are not said to be one"),
    pytest.param(claim("Length of `BUFFER`", "64 bytes"), id="the length of what is named"),
    pytest.param(table("Slot | Time", "1 | 10:00", "2 | 4 h", "3 | 5 h"), id="slots of something else"),
    pytest.param("The outputs (BATT_) from 1 to 4 are free.\n", id="numbers of something else"),
    pytest.param(table("Result | Meaning", "MAV_RESULT_FAILED, 3 times | gives up"), id="how often, not which number"),
    pytest.param(
        "`a = x * y` and `b = x / y`\n\n" + claim("x 6, y 2", "3"), id="one of several formulas of the same names"
    ),
]


@pytest.mark.parametrize("text", LEFT_ALONE)
def test_what_does_not_say_what_it_is_of_is_left_alone(check: Check, text: str) -> None:
    assert check(text) == []


def test_nothing_is_judged_outside_of_examples(check: Check) -> None:
    assert check("### Among them\n\n" + claim("Full scale at the default multiplier", "9 V")) != []
    assert check("## Further\n\n" + claim("Full scale at the default multiplier", "9 V")) == []


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("12 V and -0.05 V/s", ["12 V", "-0.05 V/s"]),
        ("FR-00068.3, v2, BATT2_, voltages[3..9], MAVLink 2, RFC 0018", []),
        ("3.9500000477. Then 1,234 bytes, 0x1F, 2^30 us, 10.45V", ["3.9500000477", "1234 bytes", "31", "1073741824 us", "10.45 V"]),
        ("2nd of 3 counts", ["3"]),
    ],
)  # fmt: skip
def test_numbers_of_a_text(text: str, found: list[str]) -> None:
    shown = [f"{float(each.value):.12g} {each.unit.name}".strip() for each in amounts(text)]
    assert shown == found


NUMBERS = {
    "ADR-00018": (5, 0),
    "FR-00020": (106, 83),  # what a timer does, and when
    "FR-00021": (119, 51),  # what was read, and the words for it
    "FR-00066": (50, 11),
    "FR-00067": (21, 12),
    "FR-00068": (80, 15),
    "FR-00069": (64, 10),
    "FR-00070": (98, 17),
    "FR-00071": (58, 4),
    "FR-00072": (5, 0),
    "FR-00073": (10, 1),
    "FR-00077": (56, 8),
    "NFR-00060": (12, 3),
    "NFR-00061": (102, 32),  # what a cut leaves of two files
    "NFR-00062": (25, 2),
}
"""By document: the numbers of its worked examples, and how many of them nothing computes, as ``codegen check --examples``
lists them: what is given, what is hidden by rounding, and what depends on what a program does meanwhile."""


HEADINGS = ("Below 10.5 V", "(12 bits)")
"""Of headings with numbers: what is noticed of them is noticed in the rows below."""


def document_id(path: str) -> str:
    return "-".join(Path(path).name.split("-")[:2])


def test_every_document_with_worked_examples_is_looked_at(own: tuple[Reference, list[str]]) -> None:
    others = [path for path in own[1] if document_id(path) not in NUMBERS]
    assert {document_id(path) for path in own[1]} >= NUMBERS.keys()
    assert [path for path in others if "## Worked Examples" in Path(path).read_text()] == []


@pytest.mark.parametrize("document", NUMBERS)
def test_each_number_that_is_recomputed_is_found_when_it_is_changed(
    own: tuple[Reference, list[str]], document: str
) -> None:
    """Each with one more and one less at its last digit: what is noticed is noticed in that row."""
    found = list(example_numbers([path for path in own[1] if document_id(path) == document], own[0]))
    for number in found:
        text = number.passage.text
        is_row = text.startswith("|") and not any(heading in text for heading in HEADINGS)
        if number.is_computed and is_row:
            assert all(number.place.line in [place.line for place in found] for found in number.found), text
    assert (len(found), sum(not number.is_computed for number in found)) == NUMBERS[document]


def test_the_page_shows_the_list(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    page = (ROOT / "docs" / "claims.md").read_text()
    shown = re.search(r"```text\n\$ codegen (check --examples .*?)\n(.*?)```", page, re.DOTALL)
    assert shown
    monkeypatch.chdir(ROOT)
    main(shown[1].split())
    assert "".join(capsys.readouterr()) == shown[2]


def test_the_list_of_numbers_that_nothing_computes(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "notes.md"
    path.write_text(HEAD + claim("HEARTBEAT at 1 Hz, v1", "17 bytes/s") + "\nIt took 3.5 s on 2 days.\n")
    assert main(["check", "--examples", "--dialect", "common", str(path)]) == 0
    out, err = capsys.readouterr()
    assert out == f"{path}:9:9: not computable: 3.5 s, 2 days\n"
    assert err.endswith("4 numbers in worked examples: 2 recomputed, 2 not computable\n")
    assert main(["check", "--examples", "--format", "json", str(path)]) == 2
