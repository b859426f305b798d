"""Machine code for a board does not extend the signs of words, that for a host does."""

import re
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.emit.mpy import compiled
from codegen.emit.word_signs import with_signs_of_words

FIRMWARE = Path(__file__).resolve().parents[2] / "generated"
EXTENDED = """\
import micropython


@micropython.viper
def total(words: ptr32, at: int) -> int:
    bit = 1
    sign = bit << 31
    value = 0 - ((words[at + 1] ^ sign) - sign)
    value -= (words[0] ^ sign) - sign
    if value < (words[2] ^ sign) - sign:
        return (value ^ sign) - sign
    return value
"""
READ = (
    EXTENDED.replace("((words[at + 1] ^ sign) - sign)", "(words[at + 1])")
    .replace("-= (words[0] ^ sign) - sign", "-= words[0]")
    .replace("< (words[2] ^ sign) - sign", "< words[2]")
)


def test_words_alone_are_read_with_their_signs() -> None:
    """What was computed is none: only a word of memory has the right bits in all of a register."""
    assert with_signs_of_words(EXTENDED, "armv7emsp") == READ
    assert with_signs_of_words(EXTENDED, "x64") == EXTENDED


@pytest.mark.parametrize("architecture", ["armv6m", "armv7emsp", "xtensawin", "rv32imc", "x64"])
def test_boards_get_less_machine_code(architecture: str) -> None:
    """Each of those with words of 32 bits, and a host what is right there."""

    def made(text: str) -> object:
        report = Report()
        files = compiled({"total_viper.py": text}, architecture, report, {"total_viper.py"})
        assert not report.has_errors
        return files["total_viper.mpy"]

    assert (made(EXTENDED) == made(READ)) == (architecture != "x64")


def test_no_word_of_the_firmware_is_left_out() -> None:
    """Every place where a generated function extends the sign of a word has this form."""
    texts = {path: path.read_text() for path in FIRMWARE.rglob("*_viper.py")}
    assert sum(text.count("^ sign)") for text in texts.values()) > 50
    for path, text in texts.items():
        assert not re.findall(r".*\^ sign.*", with_signs_of_words(text, "armv7emsp")), path
