"""Boards are data: each that comes with codegen carries a rover with a radio, a project may bring its own, and what a
board does not have is refused with what it has.
"""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from codegen.decode.board_model import FOLDER
from codegen.decode.record_file import decode_record_file
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.model.board_model import BoardModel, BoardModelSpec, shown_pins
from codegen.project.systems import read_system
from codegen.resolve.board.model import resolve_board_model
from codegen.targets.firmware import render_firmware
from codegen.targets.mocks import render_mocks

PROJECTS = Path(__file__).resolve().parents[1] / "projects"
BOARDS = sorted(name.removesuffix(".yaml") for name in os.listdir(FOLDER) if name.endswith(".yaml"))
ADC = 'pins: 1, reference: 3 V, opened: "machine.ADC({gpio})"}'
OWN = (PROJECTS / "minimal" / "specs" / "boards" / "odd.yaml").read_text()

READ = """
import sys
sys.path[:0] = ["generated/firmware", "generated/mocks"]
from mock_board import MockBoard
board = MockBoard(print)
board.set_adc_value(1234)
print(board.read_pack_adc(), [(port.name, port.is_up) for port in board.open_ports()])
"""


TIMING = "timing: {clock: 150 MHz, cycles: 1.34, most_cycles: 1.9, conversion: 4.6 us, source: a bench}"


def test_how_fast_a_board_is_may_be_known():
    """Of those that were measured; times are computed for these."""
    timing = model_of("pico_2_w").timing
    assert timing == model_of("pico_2").timing
    assert (timing.megahertz, float(timing.cycles), float(timing.most_cycles)) == (150, 1.34, 1.9)
    assert float(timing.conversion_us) == 4.6
    assert all(model_of(name).timing is None for name in ("pico", "pico_w", "esp32", "pyboard"))


def model_of(name: str) -> BoardModel:
    """Return codegen's model of a board, without a finding."""
    report = Report()
    written = decode_record_file(os.path.join(FOLDER, f"{name}.yaml"), BoardModelSpec, DISK, report)
    model = resolve_board_model(written, report)
    assert not list(report)
    assert model is not None
    return model


def with_board(folder: Path, board: str, gpio: int = 27, links: str = "  radio: {uart: 1, tx: 4, rx: 5, ") -> Path:
    """A copy of the rover with a radio, on another board and at other pins."""
    subprocess.run(["cp", "-r", str(PROJECTS / "radio_rover" / "specs"), str(folder)], check=True)
    path = folder / "specs" / "board.yaml"
    text = path.read_text().replace("board: pico\n", board and f"board: {board}\n").replace("gpio: 27", f"gpio: {gpio}")
    text = text.replace("  cable: {usb: true}\n", "").replace("  radio: {uart: 1, tx: 4, rx: 5, ", links)
    path.write_text(text)
    return folder / "specs" / "codegen.yaml"


def findings(project_file: Path) -> list[str]:
    """The findings of a project, each with its line and hint."""
    report = Report()
    read_system(str(project_file), report)
    return [
        f"{os.path.basename(each.place.file)}:{each.place.line} {each.rule.id}: {each.message}"
        + (f" ({each.hint})" if each.hint else "")
        for each in report
    ]


@pytest.mark.parametrize("name", BOARDS)
def test_a_rover_runs_on_each_board(name, tmp_path):
    """Built for its lowest free input and the pins of its first UART that are left, the mocked board reads counts."""
    model = model_of(name)
    number, uart = next(iter(model.uarts.items()))
    assert model.adc is not None
    gpio = min(model.adc.pins & model.free)
    tx = max((uart.tx & model.free) - {gpio})
    rx = max((uart.rx & model.free) - {gpio, tx})
    project = with_board(tmp_path, name, gpio, f"  radio: {{uart: {number}, tx: {tx}, rx: {rx}, ")
    report = Report()
    system = read_system(str(project), report)
    assert not report.has_errors, findings(project)
    assert system is not None
    for path, text in (render_firmware(system) | render_mocks(system)).items():
        target = tmp_path / "generated" / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)
    done = subprocess.run([sys.executable, "-c", READ], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.stdout == "1234 [('radio', True)]\n", done.stdout + done.stderr


def test_the_boards_of_the_documents_are_there():
    """Those that issue after issue speaks of."""
    assert set(BOARDS) >= {"pico", "pico_w", "pico_2", "pico_2_w", "esp32", "esp32_s3", "esp32_c3", "pyboard"}


def test_a_board_of_the_project(tmp_path):
    """A file in specs/boards is found before those of codegen, and hashed as an input."""
    project = with_board(tmp_path, "pico", gpio=2, links="  radio: {uart: 0, tx: 0, rx: 1, ")
    own = tmp_path / "specs" / "boards" / "pico.yaml"
    own.parent.mkdir()
    own.write_text(
        OWN.replace("odd", "p")
        + 'adc: {pins: 2, bits: 12, reference: 3 V, opened: "machine.ADC({gpio})"}\nuarts: {0: {tx: 0, rx: 1}}\n'
    )
    report = Report()
    system = read_system(str(project), report)
    assert system is not None
    assert not report.has_errors, findings(project)
    assert system.board is not None
    assert system.board.name == 'A board \\ with """ quotes'
    assert str(own) in system.spec.files


@pytest.mark.parametrize(
    ("board", "gpio", "links", "wanted"),
    [
        (
            "pico_3",
            27,
            "",
            "board.yaml:1 unknown-board: there is no description of a board pico_3 (did you mean pico_w or pico_2",
        ),
        (
            "Raspberry Pi Pico 2 W",
            27,
            "",
            "board.yaml:1 unknown-board: there is no description of a board Raspberry Pi Pico 2 W (did you mean "
            "pico_2_w?)",
        ),
        ("pico", 22, "", "board.yaml:3 bad-adc: gpio of pack is 22, not 26 to 28"),
        ("pico_w", 29, "", "not 26 to 28: the Raspberry Pi Pico W needs it for the clock of the radio"),
        ("esp32", 25, "  radio: {uart: 1, tx: 4, rx: 5, ", "bad-adc: gpio of pack is 25, not 32 to 39"),
        ("esp32", 32, "  radio: {uart: 0, tx: 4, rx: 5, ", "bad-link: the ESP32 development board has UART 1 and 2"),
        ("esp32", 32, "  radio: {uart: 1, tx: 34, rx: 5, ", "bad-link: tx of UART 1 is GPIO 0, 2, 4, 5, 12 to 19"),
        ("esp32", 32, "  cable: {usb: true}\n  radio: {uart: 1, tx: 4, rx: 5, ", "has no USB port of its own"),
        ("esp32", 32, "  radio: {uart: 1, tx: 4, rx: 32, ", "shared-pin: pack and rx of radio are both on GPIO 32"),
        (
            "pico",
            27,
            "  air: {udp: 14550, to: 1.2.3.4, credentials: w.json, retry: 5 s}\n  radio: {uart: 1, tx: 4, rx: 5, ",
            "board.yaml:5 bad-link: the Raspberry Pi Pico has no Wi-Fi",
        ),
        (
            "pico",
            27,
            "  air: {tcp_server: 1, credentials: w.json, retry: 5 s, timeout: 9 s}\n  radio: {uart: 1, tx: 4, rx: 5, ",
            "board.yaml:5 bad-link: the Raspberry Pi Pico has no Wi-Fi",
        ),
        (
            "pico_2",
            27,
            "  air: {tcp_client: 1, to: 1.2.3.4, credentials: w.json, retry: 5 s, timeout: 9 s}\n"
            "  radio: {uart: 1, tx: 4, rx: 5, ",
            "board.yaml:5 bad-link: the Raspberry Pi Pico 2 has no Wi-Fi",
        ),
        ("", 27, "", "board.yaml:2 bad-adc: the pin of pack is on no known board (say which board it is, such as"),
    ],
)
def test_what_a_board_lacks_is_refused(board, gpio, links, wanted, tmp_path):
    """At the line that asks for it, with what there is."""
    project = with_board(tmp_path, board, gpio, *([links] if links else []))
    found = findings(project)
    assert any(wanted in each for each in found), found


def test_a_hint_names_a_pin_that_is_free(tmp_path):
    """Not that of another instance: three packs at one pin are told two pins."""
    subprocess.run(["cp", "-r", str(PROJECTS / "two_batteries" / "specs"), str(tmp_path)], check=True)
    path = tmp_path / "specs" / "board.yaml"
    third = "    - {prefix: THIRD_, doc: The third one., facts: {serial: SN-0044}}\n"
    path.write_text(path.read_text().replace("RIGHT_PIN: 28, ", "") + third)
    shared = [each for each in findings(tmp_path / "specs" / "codegen.yaml") if "shared-pin" in each]
    assert [each.rpartition("(")[2] for each in shared] == ["RIGHT_PIN: 26)", "THIRD_PIN: 28)"], shared


@pytest.mark.parametrize(
    ("old", "new", "wanted"),
    [
        ("pins: 0..3", "pins: 0-3", "'0-3' is no GPIO number"),
        ("usb: false", "usb: false\ntaken: {9: x}", "GPIO 9 is none of the pins"),
        ("usb: false", "usb: false\nuarts: {a: {tx: 0, rx: 1}}", "a is not the number of a UART"),
        (
            "usb: false",
            'usb: false\nadc: {pins: 7, bits: 16, reference: 0 V, opened: "machine.ADC(7)"}',
            "the reference of|16, not|16 bits|{gpio} is missing|GPIO 7 is none",
        ),
    ],
)
def test_a_description_that_contradicts_itself(old, new, wanted, tmp_path):
    """Each fault is a finding in the file of the board."""
    project = with_board(tmp_path, "own")
    (tmp_path / "specs" / "boards").mkdir()
    (tmp_path / "specs" / "boards" / "own.yaml").write_text(OWN.replace(old, new))
    found = [each for each in findings(project) if each.startswith("own.yaml:") and " bad-board: " in each]
    assert found
    assert any(word in each for each in found for word in wanted.split("|")), found


@pytest.mark.parametrize(
    ("old", "new", "message", "hint"),
    [
        ("pins: 0..3", "pins: 0..200", "GPIO 200 is beyond 0 to 127", "write 0..22, 26..28"),
        ("pins: 0..3", "pins: -1..3", "'-1..3' is no GPIO number", "write 0..22, 26..28"),
        ("pins: 0..3", "pins: 3..0", "3..0 has no number", "write 0..3"),
        ("usb: false", "usb: false\ntaken: {9: x, 8: y}", "GPIO 8 and 9 are none of the pins", "pins: has 0 to 3"),
        ("usb: false", "usb: false\nuarts: {11: {tx: 0, rx: 1}}", "UART 11 is beyond 0 to 10", "machine.UART()"),
        ("usb: false", "usb: false\nuarts: {-1: {tx: 0, rx: 1}}", "-1 is not the number of a UART", "machine.UART()"),
        ("usb: false", "usb: false\nuarts: {00: {tx: 0, rx: 1}}", "00 is not the number of a UART", "machine.UART()"),
        (
            "usb: false",
            "usb: false\ni2c: {-2: {sda: 0, scl: 1}}",
            "-2 is not the number of an I2C bus",
            "machine.I2C()",
        ),
        ("usb: false", f"usb: false\n{TIMING.replace('150', '0')}", "stands still", "150 MHz"),
        (
            "usb: false",
            f"usb: false\n{TIMING.replace('1.34', '0')}",
            "an instruction takes some cycles",
            "cycles: 1.34",
        ),
        ("usb: false", f"usb: false\n{TIMING.replace('1.9', '1.3')}", "at most is less than likely", "1.34"),
        ("usb: false", f"usb: false\n{TIMING.replace('4.6', '-1')}", "takes less than no time", "conversion: 4.6 us"),
        ("usb: false", f"usb: false\nadc: {{bits: 40, {ADC}", "a count has 40 bits, not 8 to 12", "bits: 12"),
        ("usb: false", f"usb: false\nadc: {{bits: -1, {ADC}", "a count has -1 bits, not 8 to 12", "bits: 12"),
        (
            "usb: false",
            f"usb: false\nadc: {{bits: 12, {ADC.replace('3 V', '1e9 V')}",
            "100 V at most",
            "reference: 3.3 V",
        ),
    ],
)
def test_numbers_out_of_range(old, new, message, hint, tmp_path):
    """One finding at the number, in the words of the file's keys, with what to write; nothing follows from it."""
    (tmp_path / "specs" / "boards").mkdir(parents=True)
    path = tmp_path / "specs" / "boards" / "own.yaml"
    path.write_text(OWN.replace(old, new))
    report = Report()
    assert resolve_board_model(decode_record_file(str(path), BoardModelSpec, DISK, report), report) is None
    [found] = report
    assert found.rule.id == "bad-board"
    assert found.place.line >= 4
    assert message in found.message
    assert found.hint is not None
    assert hint in found.hint


@pytest.mark.parametrize(
    ("opened", "wanted"),
    [
        ("machine.ADC(({gpio})", "opened is no expression of Python: '(' was never closed"),
        ("foo.ADC({gpio})", "opened names foo, and knows the module machine alone"),
        ("machine.ADC({gpio}, {bits})", "opened names bits, and knows the module machine alone"),
        ("machine.ADC(int({gpio}), atten=machine.ADC.ATTN_11DB)", ""),
    ],
)
def test_what_opens_an_input_is_python(opened, wanted, tmp_path):
    """It stands in the firmware as it is: what is no Python, or names what is not there, stops it at the start."""
    path = tmp_path / "own.yaml"
    adc = f"adc: {{bits: 12, reference: 3.3 V, pins: '1', opened: '{opened}'}}"
    path.write_text(OWN.replace("usb: false", f"usb: false\n{adc}"))
    report = Report()
    resolve_board_model(decode_record_file(str(path), BoardModelSpec, DISK, report), report)
    assert [each.message for each in report] == ([wanted] if wanted else [])
    assert all(each.hint for each in report)


WATCHED = "usb: false\nwatchdog:\n  restart: 2\n  hold: [pass]\n"


@pytest.mark.parametrize(
    ("old", "new", "wanted"),
    [
        (
            "restart: 2",
            "restart: 2\n  shortest: 9 s\n  longest: 8 s",
            "bad-board: the shortest timeout, 9 s,",
        ),
        ("restart: 2", "restart: 2\n  causes: {on: power}", "bad-board: on is no number of machine.reset_cause()"),
        ("restart: 2", "restart: 2\n  caused: machine.", "bad-board: caused is no expression of Python"),
        ("[pass]", "[]", "bad-board: a prompt would be reset as long as nothing holds the watchdog"),
        ("[pass]", '["while {period}"]', "bad-board: hold is no statement of Python"),
        ("[pass]", '["machine.Timer({perod})"]', "bad-board: hold names perod, and knows the module machine alone"),
        (
            "restart: 2",
            "restart: 2\n  caused: pyb.cause()",
            "bad-board: caused names pyb, and knows the module machine",
        ),
        ("  restart: 2\n", "", "missing-key"),
    ],
)
def test_a_watchdog_that_contradicts_itself(old, new, wanted, tmp_path):
    """Each fault is a finding in the file of the board, at its line."""
    (tmp_path / "specs" / "boards").mkdir(parents=True)
    path = tmp_path / "specs" / "boards" / "own.yaml"
    path.write_text(OWN.replace("usb: false", WATCHED.replace(old, new)))
    report = Report()
    resolve_board_model(decode_record_file(str(path), BoardModelSpec, DISK, report), report)
    found = [f"{each.place.line} {each.rule.id}: {each.message}" for each in report]
    assert len(found) == 1, found
    assert wanted in found[0], found
    assert int(found[0].split(" ")[0]) >= 7


@pytest.mark.parametrize(
    ("board", "timeout", "wanted"),
    [
        ("pico", "8388 ms", ""),
        (
            "pico",
            "8389 ms",
            "Raspberry Pi Pico takes 8388 ms at most, not 8389 ms (timeout: 8388 ms or less",
        ),
        ("esp32", "60 s", ""),
        (
            "esp32",
            "0.9 s",
            "a main loop may stand still where flash is erased (timeout: 1000 ms or more",
        ),
        ("pyboard", "32767 ms", ""),
        ("pyboard", "33 s", "the watchdog of pyboard v1.1 takes 32767 ms at most, not 33 s"),
        ("own", "2 s", "has no watchdog (leave watchdog out, or state under watchdog of the board's file"),
        ("", "2 s", "nothing is known of the watchdog of this board (say in board.yaml which it is, such as board:"),
    ],
)
def test_a_watchdog_that_the_board_cannot_do(board, timeout, wanted, tmp_path):
    """A finding at the timeout, with what to write; a timeout at the limit is none."""
    project = with_board(tmp_path, board)
    (tmp_path / "specs" / "boards").mkdir()
    (tmp_path / "specs" / "boards" / "own.yaml").write_text(OWN)
    vehicle = tmp_path / "specs" / "vehicle.yaml"
    vehicle.write_text(f"{vehicle.read_text()}watchdog: {{timeout: {timeout}}}\n")
    found = [each for each in findings(project) if "bad-watchdog" in each]
    assert len(found) == bool(wanted), found
    assert all(wanted in each and each.startswith("vehicle.yaml:") for each in found), found


def test_a_file_that_nothing_names(tmp_path):
    """A description that board.yaml does not name is told, with the line that would name it."""
    project = with_board(tmp_path, "pico")
    (tmp_path / "specs" / "boards").mkdir()
    (tmp_path / "specs" / "boards" / "own.yaml").write_text(OWN)
    assert any("unread-file" in each and "board: own" in each for each in findings(project)), findings(project)


def test_pins_in_words():
    """Runs of three and more are shortened."""
    assert [shown_pins(frozenset(pins)) for pins in ((), (1,), (1, 2), (1, 2, 3, 7))] == [
        "",
        "1",
        "1 and 2",
        "1 to 3 and 7",
    ]
