"""Every message of every dialect that pymavlink ships goes over the wire as with pymavlink, under MicroPython.

benchmarks/conformance.py compares more values, every dialect as a whole, and both forms of the frames.
"""

from collections.abc import Callable
from pathlib import Path

import conformance_oracle as oracle
import pytest
from conformance_cases import write_cases
from conformance_run import MICROPYTHON32, SINGLE_FLOATS, compare, generate, run_cases
from conformance_values import TEXTS

from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_names, shipped_dialect_path

LARGEST = "all"
PARTS = 8
NAMES = (LARGEST, *(name for name in shipped_dialect_names(DISK) if name != LARGEST))
WITH_DOUBLES = ["common", "python_array_test", "test"]
CHUNKS = [(name, part) for name in NAMES for part in range(PARTS if name == LARGEST else 1)]

Dialects = dict[str, tuple[oracle.Dialect, list[oracle.Message]]]


@pytest.fixture(scope="module")
def dialects(tmp_path_factory: pytest.TempPathFactory) -> Dialects:
    """Each dialect, and those of its messages that no dialect before it has alike."""
    folder = tmp_path_factory.mktemp("modules")
    seen = set()
    found: Dialects = {}
    for name in NAMES:
        dialect = oracle.read_dialect(name, folder)
        new = []
        for message in dialect.messages:
            facts = repr((message.description, message.fields))
            if facts not in seen:
                seen.add(facts)
                new.append(message)
        found[name] = (dialect, new)
    return found


@pytest.mark.parametrize(("name", "part"), CHUNKS)
def test_every_message_is_that_of_pymavlink(dialects: Dialects, tmp_path: Path, name: str, part: int) -> None:
    """Frames out and in, both versions: values of all kinds, sentinels, truncation, extensions, streams with damage.

    A dialect has to generate and to import as a whole, with its enums, even if all its messages were compared before.
    """
    dialect, new = dialects[name]
    step = PARTS if name == LARGEST else 1
    outcome = compare(dialect, tmp_path, new[part::step], rounds=1, forms=("viper",))
    assert not outcome.differences
    assert not outcome.different
    if new:
        assert outcome.counts["encode"]


@pytest.mark.parametrize("name", ["common", "storm32", "test"])
def test_the_plain_form_is_that_of_pymavlink(dialects: Dialects, tmp_path: Path, name: str) -> None:
    """Frames without machine code; that both forms do the same is compared in test_firmware_forms.py."""
    dialect, _ = dialects[name]
    outcome = compare(dialect, tmp_path, dialect.messages[::8], rounds=1, forms=("plain",))
    assert not outcome.differences


@pytest.mark.parametrize("part", [0, 4])
def test_words_of_32_bits_make_no_difference(dialects: Dialects, tmp_path: Path, part: int) -> None:
    """A quarter of all messages on a MicroPython with the integers of a board; its floats are doubles all the same."""
    dialect, _ = dialects[LARGEST]
    messages = dialect.messages[part::8]
    outcome = compare(dialect, tmp_path, messages, rounds=1, forms=("plain",), interpreter=MICROPYTHON32)
    assert not outcome.differences
    assert outcome.counts["encode"]


@pytest.mark.parametrize("name", WITH_DOUBLES)
def test_floats_of_32_bits_make_no_difference(dialects: Dialects, tmp_path: Path, name: str) -> None:
    """Messages with doubles on words of 32 bits, where struct reads and writes doubles as boards do."""
    dialect, _ = dialects[name]
    messages = [message for message in dialect.messages if any(item.code == "d" for item in message.fields)]
    assert messages
    board = {"interpreter": MICROPYTHON32, "modules": (SINGLE_FLOATS,)}
    outcome = compare(dialect, tmp_path, messages, rounds=4, forms=("plain",), **board)
    assert not outcome.differences
    assert outcome.counts["special floats"]


def test_no_other_dialect_states_doubles() -> None:
    """Those above, and of benchmarks/conformance.py, are all."""
    texts = {name: Path(str(shipped_dialect_path(name, DISK))).read_text(encoding="utf-8") for name in NAMES}
    assert sorted(name for name, text in texts.items() if 'type="double' in text) == WITH_DOUBLES


def test_every_kind_of_case_comes_up(dialects: Dialects, tmp_path: Path) -> None:
    """A kind that is never made would compare nothing."""
    dialect, _ = dialects["common"]
    names = {"HEARTBEAT", "BATTERY_STATUS", "STATUSTEXT", "CONTROL_SYSTEM_STATE", "LOGGING_DATA"}
    messages = [message for message in dialect.messages if message.name in names]
    counts = compare(dialect, tmp_path, messages, rounds=1, forms=("viper",)).counts
    assert counts.keys() == {
        *("encode", "decode", "v1", "refused", "class", "enum entries", "live", "new message"),
        *("random", "zeros at the end", "all minimum", "all maximum", "all zero", "special floats"),
        *TEXTS,
        *("unknown fields", "unknown elements"),
        *("any bits", "every truncated length", "zeros left in", "no extensions", "extensions in MAVLink 1"),
        *("newer extensions", "signed", "wrong checksums", "wrong lengths", "damaged frames"),
    }


def test_modules_of_pymavlink_are_made_where_they_are_missing(tmp_path: Path) -> None:
    """A dialect without a module, or with one of another release, is compared with what pymavlink makes of its XML."""
    path = shipped_dialect_path("loweheiser", DISK)
    assert path is not None
    for version in (1, 2):
        made = oracle.make_module("loweheiser", path, version, tmp_path)
        expected = oracle.xml_messages(path, version)
        assert made.mavlink_map.keys() == expected.keys()
        assert not oracle.disagreement(made, expected)
        first = next(iter(expected))
        made.mavlink_map[first].crc_extra ^= 1
        assert oracle.disagreement(made, expected)
        del made.mavlink_map[first]
        assert oracle.disagreement(made, expected)


def replace(file: str, old: str, new: str) -> Callable[[Path], None]:
    """A change of a generated file."""

    def change(folder: Path) -> None:
        path = folder / file
        text = path.read_text(encoding="utf-8")
        assert old in text
        path.write_text(text.replace(old, new), encoding="utf-8")

    return change


FAULTS = {
    "a sentinel": replace("message_fields.py", "hdg:H=65535", "hdg:H=65534"),
    "the order of fields": replace("message_fields.py", "vx:h vy:h", "vy:h vx:h"),
    "a type": replace("message_fields.py", "vz:h", "vz:H"),
    "CRC_EXTRA": replace("messages.py", "CRC_EXTRA = 104", "CRC_EXTRA = 105"),
    "an id": replace("messages.py", "ID = 33\n", "ID = 34\n"),
    "truncation to nothing": replace("frames_viper.py", "if not length and", "if False and"),
    "no truncation": replace("frames_viper.py", "while not last[0]:", "while False:"),
    "what stood there before": replace("frames_viper.py", "words[0] = 0\n", "pass\n"),
    "the sign of live values": replace("frames_viper.py", "^ 0x8000) - 0x8000", "^ 0x8000) ^ 0x8000"),
    "the highest byte of live values": replace(
        "frames_viper.py", "words[place[0]] = live[place[1]]", "words[place[0]] = int(live[place[1]]) & 0xFFFFFF"
    ),
    "an unknown message": replace("frames_viper.py", "state[18] = int(state[18]) + 1", "pass"),
    "a wrong checksum": replace("receiver.py", "self.crc_errors += 1", "pass"),
    "an enum": replace("enums.py", "MAV_TYPE_GCS = 6", "MAV_TYPE_GCS = 7"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_the_comparison_finds_faults(dialects: Dialects, tmp_path: Path, fault: str) -> None:
    """A comparison that nothing could fail would prove nothing."""
    dialect, _ = dialects["standard"]
    codec = tmp_path / "codec"
    generate(dialect.name, codec, machine_code=True)
    write_cases(tmp_path / "cases", dialect, dialect.messages, seed=1, rounds=1)
    assert not run_cases(codec, tmp_path / "cases")["different"]
    FAULTS[fault](codec)
    assert run_cases(codec, tmp_path / "cases")["different"]
