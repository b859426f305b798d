"""The generated checks of signed links stay within their heap where a vehicle sends 63 messages in a second."""

import re
from pathlib import Path

from generated_suite import suite_is_green
from in_process import build, codegen

RATES = {"default: 5, min: 0, max: 10": 30, "default: 5, min: 0, max: 25": 20, "default: 2, min: 0, max: 10": 12}
RADIO = "  radio: {uart: 1, tx: 17, rx: 16, baud: 57600}\n"
ACCESS = "access:\n  links: {wifi: signed, radio: open}\n  setup: [radio]\n"


def test_minutes_of_many_messages_fit_the_heap(tmp_path: Path) -> None:
    """Two links of which one is signed; what nobody counts is not kept, and single messages in a pass suffice."""
    assert codegen(tmp_path, "init", ".", "--from", "boat").returncode == 0
    specs = tmp_path / "specs"
    text = (specs / "parameters.yaml").read_text()
    for old, rate in RATES.items():
        assert text.count(old) == 1
        text = text.replace(old, f"default: {rate}, min: 0, max: 50")
    (specs / "parameters.yaml").write_text(text)
    program = (specs / "vehicle.yaml").read_text()
    program = re.sub("control: {rate: 50 Hz, links: 50 Hz", "control: {rate: 400 Hz, links: 400 Hz", program)
    (specs / "vehicle.yaml").write_text(program + ACCESS)
    with (specs / "board.yaml").open("a") as file:
        file.write(RADIO)
    build(tmp_path)
    only = "micropython and (flash_that_fails or timestamps or one_message_in_a_pass)"
    suite_is_green(tmp_path / "generated" / "tests", "test_program.py", only=only)
