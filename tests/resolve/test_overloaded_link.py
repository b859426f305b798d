"""A serial link that carries less than is streamed by default is told, with what a signature adds to each frame."""

import shutil
from fractions import Fraction
from pathlib import Path

import pytest
from edited_project import edited

from codegen.model.price import SIGNATURE, price_on, sent_messages, signature_on
from codegen.rules import overloaded_link

PROJECTS = Path(__file__).resolve().parents[1] / "projects"


def told(folder: Path, *changes: tuple[str, str, str]) -> list[str]:
    """Return the messages of the rule, with the hint, after changes."""
    _, found = edited(folder, *changes)
    return [f"{each.rule.id}: {each.message}; {each.hint}" for each in found if each.rule is overloaded_link.RULE]


@pytest.fixture
def buoy(tmp_path: Path) -> Path:
    """HEARTBEAT, 21 bytes at 1 Hz, and HYGROMETER_SENSOR, at most 16 bytes at 2 Hz: 53 bytes each second."""
    shutil.copytree(PROJECTS / "moored_buoy" / "specs", tmp_path / "specs")
    return tmp_path / "specs"


def test_a_link_that_carries_all_is_not_told(buoy: Path) -> None:
    """To the last byte: 10 bits of a UART are one."""
    assert told(buoy, ("board.yaml", "57600", "530")) == []


def test_one_byte_less_is(buoy: Path) -> None:
    """With a rate that carries it."""
    assert told(buoy, ("board.yaml", "57600", "520")) == [
        "overloaded-link: up to 53 bytes are streamed each second by default, and radio carries 52; "
        "lower the default rates of streams, or write baud: 9600"
    ]


def test_signatures_count_on_the_links_that_are_signed(tmp_path: Path) -> None:
    """13 bytes for each frame, on no other link."""
    shutil.copytree(PROJECTS / "guarded" / "specs", tmp_path / "specs")
    system, _ = edited(tmp_path / "specs")
    by_name = {link.name: link for link in system.links}
    assert [signature_on(by_name[name], system) for name in ("wifi", "cable", "radio")] == [SIGNATURE, 0, 0]
    frames = sum((message.stream.default_rate for message in sent_messages(system) if message.stream), Fraction(0))
    assert price_on(by_name["wifi"], system).high - price_on(by_name["radio"], system).high == 13 * frames > 0
