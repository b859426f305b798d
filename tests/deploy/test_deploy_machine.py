"""Whether a board is the one that board.yaml names, by what MicroPythons say of themselves."""

from dataclasses import replace
from pathlib import Path

import pytest
import yaml

from codegen.commands.deploy import shipped_boards
from codegen.deploy.machine import is_other_board, is_other_chip
from codegen.model.board_model import BoardModelSpec

BOARDS = Path(__file__).resolve().parents[2] / "codegen" / "boards"

# What builds say, of several versions: MICROPY_HW_BOARD_NAME "with" MICROPY_HW_MCU_NAME. Since 2026 the chips of
# Espressif have a hyphen there.
SAID = {
    "esp32": (
        *("ESP32 module with ESP32", "Generic ESP32 module with ESP32", "Generic ESP32 module with SPIRAM with ESP32"),
        *(
            "TinyPICO with ESP32-PICO-D4",
            "XiaoMiao Desktop with ESP32-WROVER-B",
            "SparkFun IoT RedBoard ESP32 with ESP32",
        ),
    ),
    "esp32_c3": (
        *("ESP32C3 module with ESP32C3", "ESP32C3 module with ESP32-C3", "LOLIN_C3_MINI with ESP32-C3FH4"),
        "01Space ESP32-C3FH4-RGB with ESP32-C3FH4",
    ),
    "esp32_s3": (
        *("ESP32S3 module with ESP32S3", "Generic ESP32S3 module with ESP32S3", "Generic ESP32S3 module with ESP32-S3"),
        *("Generic ESP32S3 module with Octal-SPIRAM with ESP32S3", "LOLIN_S3_MINI with ESP32-S3FH4R2"),
        *("M5STACK StopWatch with ESP32-S3R8", "AtomS3R-M12 with ESP32-S3-PICO-1-N8R8"),
        "ESP32-S3-N8R2 with pyDirect with ESP32-S3",
    ),
    "esp32_s3_psram": ("Generic ESP32S3 module with Octal-SPIRAM with ESP32-S3", "LOLIN_S3 with ESP32-S3-WROOM-1"),
    "pico": ("Raspberry Pi Pico with RP2040", "Raspberry Pi Pico with rp2040"),
    "pico_w": ("Raspberry Pi Pico W with RP2040",),
    "pico_2": ("Raspberry Pi Pico 2 with RP2350",),
    "pico_2_w": ("Raspberry Pi Pico 2 W with RP2350",),
    "pyboard": ("PYBv1.1 with STM32F405RG", "PYBv1.0 with STM32F405RG"),
}
# Boards of others, by chip, which are right for each board with it; those with no board here are right for none.
OF_OTHERS = {
    "RP2040": (
        "Pimoroni Pico LiPo 16MB with RP2040",
        "Arduino Nano RP2040 Connect with RP2040",
        "W5500-EVB-Pico with RP2040",
    ),
    "RP2350": ("Adafruit Feather RP2350 with RP2350",),
    "STM32F405": ("Adafruit Feather STM32F405 with STM32F405RG",),
    "ESP32-S2": ("Generic ESP32S2 module with ESP32S2",),
    "ESP32-C6": ("ESP32C6 module with ESP32C6", "ESP32-C6 with ESP32-C6"),
    "ESP32-P4": ("Generic ESP32P4 module with ESP32P4",),
    "ESP8266": ("ESP module with ESP8266",),
    "STM32F411": ("PYBLITEv1.0 with STM32F411RE",),
    "": ("linux [GCC 14.2.1] version", ""),
}


def model_of(name: str) -> BoardModelSpec:
    """Return the board of a file."""
    told = yaml.safe_load((BOARDS / f"{name}.yaml").read_text())["name"]
    return next(each for each in shipped_boards() if each.name == told)


def test_each_board_has_its_words() -> None:
    assert {path.stem for path in BOARDS.glob("*.yaml")} == set(SAID)


@pytest.mark.parametrize("written", sorted(SAID))
@pytest.mark.parametrize("connected", sorted(SAID))
def test_boards_crosswise(written: str, connected: str) -> None:
    """A part of a name is not enough, and hyphens are not needed: "ESP32" is in "ESP32S3", which is "ESP32-S3".

    With PSRAM it is no other board: what it says of itself need not tell.
    """
    is_other = written.removesuffix("_psram") != connected.removesuffix("_psram")
    for said in SAID[connected]:
        assert is_other_board(model_of(written), said, shipped_boards()) == is_other, said


@pytest.mark.parametrize("written", sorted(SAID))
@pytest.mark.parametrize("chip", sorted(OF_OTHERS))
def test_a_board_of_another_vendor_is_judged_by_its_chip(written: str, chip: str) -> None:
    model = model_of(written)
    for said in OF_OTHERS[chip]:
        assert is_other_board(model, said, shipped_boards()) == (model.mcu != chip), said


@pytest.mark.parametrize(
    ("mcu", "wifi", "said", "is_other"),
    [
        ("RP2350", False, "Raspberry Pi Pico 2 with RP2350", False),  # which sits on it
        ("RP2350", False, "Raspberry Pi Pico 2 W with RP2350", False),
        ("RP2350", True, "Raspberry Pi Pico 2 W with RP2350", False),
        ("RP2350", True, "Raspberry Pi Pico 2 with RP2350", True),
        ("RP2350", True, "Adafruit Feather RP2350 with RP2350", False),
        ("RP2350A", False, "Raspberry Pi Pico 2 with RP2350", False),
        ("RP2040", False, "Raspberry Pi Pico 2 with RP2350", True),
        ("ESP32-S3-WROOM-1", True, "Generic ESP32S3 module with ESP32S3", False),
        ("ESP32-WROOM-32", True, "Generic ESP32 module with ESP32", False),
        ("ESP32-WROOM-32", True, "Generic ESP32S3 module with ESP32S3", True),
        ("STM32F405RGT6", False, "PYBv1.1 with STM32F405RG", False),
        ("STM32F405VG", False, "PYBv1.1 with STM32F405RG", True),
        ("nRF52840", False, "Arduino Nano 33 BLE Sense with NRF52840", False),
    ],
)
def test_boards_that_a_project_describes(mcu: str, wifi: bool, said: str, is_other: bool) -> None:
    """Its name is the project's, so that only the chip counts, and whether a board that is known has Wi-Fi."""
    pico = model_of("pico")
    keys = {name: getattr(pico, name) for name in pico.__slots__ if name not in ("name", "mcu", "wifi")}
    own = BoardModelSpec(
        place=pico.place,
        places=pico.places,
        name="Autopilot 7",
        mcu=mcu,
        wifi=wifi,
        **{name: value for name, value in keys.items() if name not in ("place", "places", "unread")},
    )
    assert is_other_board(own, said, shipped_boards()) == is_other


@pytest.mark.parametrize(
    ("mcu", "machine", "is_other"),
    [
        ("RP2350", "Raspberry Pi Pico with RP2040", True),
        ("RP2350", "Raspberry Pi Pico 2 with RP2350", False),
        ("ESP32", "LOLIN_S3 with ESP32-S3-WROOM-1", True),
        ("RP2350", "linux [GCC 14.2.1] version", False),
        ("none", "Raspberry Pi Pico with RP2040", False),
    ],
)
def test_another_chip_is_one_that_both_name(mcu: str, machine: str, is_other: bool) -> None:
    """A MicroPython that names none, and a board file without one, contradict nothing."""
    assert is_other_chip(replace(model_of("pico"), mcu=mcu), machine) is is_other
