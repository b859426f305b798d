"""The generated suite notices a number that is not the dialect's, of messages that are only received, too."""

import json
import sys
from pathlib import Path

import pytest
from generated_suite import scripts_of
from test_generated_suite_bites import copy_of_generated

WRONG_NUMBERS = [
    ("id-of-what-is-received", "messages.py", "    ID = 66\n", "    ID = 67\n"),
    ("crc-extra-of-what-is-received", "messages.py", "CRC_EXTRA = 148", "CRC_EXTRA = 149"),
    ("extension-in-the-base", "messages.py", "    BASE_LENGTH = 3\n", "    BASE_LENGTH = 4\n"),
    ("length-of-what-is-answered", "messages.py", "    LENGTH = 14\n    TARGETS", "    LENGTH = 15\n    TARGETS"),
    ("targets", "messages.py", "TARGETS = (12, 13)", "TARGETS = (13, 12)"),
    ("version-of-the-dialect", "messages.py", '"mavlink_version": 3', '"mavlink_version": 4'),
    ("type-of-a-field", "message_fields.py", "time_usec:Q", "time_usec:q"),
    ("order-of-fields", "message_fields.py", "result:B progress:B", "progress:B result:B"),
    ("opcode-of-files", "dialect.py", "MAV_FTP_OPCODE_NAK = 129", "MAV_FTP_OPCODE_NAK = 130"),
    ("opcode-in-a-module", "services.py", "_MAV_FTP_OPCODE_NAK = const(129)", "_MAV_FTP_OPCODE_NAK = const(128)"),
    ("place-of-a-field", "commands.py", "_COMMAND_ACK_RESULT_AT = const(2)", "_COMMAND_ACK_RESULT_AT = const(3)"),
    ("number-without-a-meaning", "dialect.py", "MAV_RESULT_FAILED = 4", "MAV_RESULT_FALIED = 4"),
]
"""The name of a case, and what is replaced by what in which file."""


@pytest.fixture(scope="module")
def monkeypatch_module():
    """Yield a monkeypatch that lasts while the tests of this module run."""
    with pytest.MonkeyPatch.context() as patched:
        yield patched


@pytest.fixture(scope="module")
def suite(tmp_path_factory, monkeypatch_module):
    """A copy of the committed output, its test of the dialect as a module, and the dialects as it makes them."""
    generated = copy_of_generated(tmp_path_factory.mktemp("copied"))
    monkeypatch_module.setenv("PYTHONDONTWRITEBYTECODE", "1")  # files change within a second, and keep their sizes
    names = ("interpreters", "oracle", "test_dialect")
    before = {name: sys.modules.pop(name, None) for name in names}
    sys.path.insert(0, str(generated / "tests"))
    try:
        import oracle  # noqa: PLC0415  of the copied suite
        import test_dialect  # noqa: PLC0415
    finally:
        sys.path.remove(str(generated / "tests"))
        for name in names:
            sys.modules.pop(name)
            if before[name] is not None:
                sys.modules[name] = before[name]
    said = laid_out(generated)
    return generated, test_dialect, oracle.dialects(test_dialect.ABOUT, set(said["named"]), generated / "tests")


def laid_out(generated: Path) -> dict[str, dict[str, list]]:
    """Return the firmware's description of its messages."""
    return json.loads(scripts_of(generated / "tests").run_under("cpython", "dialect_run.py"))


def faults(suite) -> list[str]:
    """The tests of the dialect that fail."""
    generated, tests, modules = suite
    found = []
    for name, test in (
        ("messages", lambda: tests.test_messages(laid_out(generated), modules)),
        ("numbers", lambda: tests.test_numbers(modules)),
    ):
        try:
            test()
        except AssertionError:
            found.append(name)
    return found


def test_untouched_numbers_pass(suite):
    """Without a mutation nothing fails."""
    assert faults(suite) == []


@pytest.mark.parametrize(("file", "old", "new"), [pytest.param(*case[1:], id=case[0]) for case in WRONG_NUMBERS])
def test_a_wrong_number_is_noticed(file, old, new, suite):
    """One change of a number, and a test of the dialect fails."""
    path = suite[0] / "firmware" / file
    text = path.read_text()
    assert old in text, f"{old!r} is not in {file}"
    path.write_text(text.replace(old, new, 1))
    try:
        assert faults(suite)
    finally:
        path.write_text(text)
