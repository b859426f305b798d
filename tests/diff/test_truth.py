"""Reports on a change are true: who notices, who breaks, and what comes of it, in both directions."""

from pathlib import Path

import pytest

from codegen.diff.change import BOTH, Change, Notice, Victim
from codegen.diff.dialect.dialect import dialect_changes
from codegen.diff.sides import Around, Side, opened
from codegen.model.dialect.dialect import Dialect
from codegen.project.systems import read_systems

EXTENSIONS = "<extensions/>"


def field(kind: str, name: str, text: str = "d", **attributes: str) -> str:
    more = "".join(f' {key}="{value}"' for key, value in attributes.items())
    return f'<field type="{kind}" name="{name}"{more}>{text}</field>'


def message(*fields: str, number: int = 1, name: str = "M") -> str:
    return f'<message id="{number}" name="{name}"><description>d</description>{"".join(fields)}</message>'


def enum(name: str, **values: int) -> str:
    entries = "".join(f'<entry value="{value}" name="{entry}"/>' for entry, value in values.items())
    return f'<enum name="{name}">{entries}</enum>'


@pytest.fixture
def told(tmp_path: Path) -> "Told":
    return Told(tmp_path)


class Told:
    """Changes between two dialects, each given as the text of its messages and of its enums."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def dialect(self, messages: str, enums: str) -> Dialect:
        file = self.folder / "d.xml"
        file.write_text(f"<mavlink><enums>{enums}</enums><messages>{messages}</messages></mavlink>")
        with opened(str(file), Around(None, "common", read_systems)) as side:
            assert isinstance(side, Side)
            return side.dialect

    def crc_extra(self, messages: str) -> int:
        return self.dialect(messages, "").messages["M"].crc_extra

    def __call__(self, old: str, new: str, enums: tuple[str, str] = ("", "")) -> dict[str, Change]:
        """The changes by rule and subject."""
        found = dialect_changes(self.dialect(old, enums[0]), self.dialect(new, enums[1]))
        return {f"{change.rule.id} {change.subject}": change for change in found}


A, B = field("uint8_t", "a"), field("uint8_t", "b")


def test_bytes_that_nobody_reads_deceive_nobody(told: Told) -> None:
    """A message with another CRC_EXTRA is dropped, so nothing that changed in it is silent."""
    old = message(
        field("uint8_t", "a", units="m"), field("uint8_t", "b", invalid="0"), EXTENSIONS, field("int8_t", "e")
    )
    new = message(field("uint16_t", "a", units="cm"), field("uint8_t", "b", invalid="1"), EXTENSIONS)
    for found in (told(old, new), told(new, old)):
        assert not any(change.is_silent for change in found.values())
        assert found["field-units-changed M.a"].notice is Notice.NOTICED
        assert found["field-units-changed M.a"].effect.startswith("the same value is a number 100 times as")
        assert found["field-sentinel-changed M.b"].effect == ""
    assert told(old, new)["field-removed M.e"].effect == "the payload still has 3 bytes"


def test_a_message_under_another_id_is_passed_over_with_all_that_changed_in_it(told: Told) -> None:
    found = told(message(field("uint8_t", "a", units="m")), message(field("uint8_t", "a", units="cm"), number=2))
    assert {change.notice for change in found.values()} == {Notice.UNKNOWN_ID}


def test_an_id_that_another_message_has_is_not_unknown(told: Told) -> None:
    """Two messages that swap their ids, and one that takes over the id of another."""
    swapped = told(
        message(A, name="A") + message(B, number=2, name="B"), message(A, number=2, name="A") + message(B, name="B")
    )
    assert {change.notice for change in swapped.values()} == {Notice.NOTICED}
    assert swapped["message-id-changed A"].effect.startswith("the id is B's in the other version: receivers of the")
    reused = told(message(A, name="A"), message(field("int16_t", "z"), name="B"))
    assert {change.notice for change in reused.values()} == {Notice.NOTICED}
    assert reused["message-added B"].breaks == BOTH


def test_a_change_that_crc_extra_misses_is_silent(told: Told) -> None:
    """It is one byte: one in 256 changes of base fields leaves it as it was. The type of a version always does."""
    old = message(A)
    byte = told.crc_extra(old)
    fields = (message(field("uint8_t", f"f{number}")) for number in range(5000))
    renamed = told(old, next(one for one in fields if told.crc_extra(one) == byte))
    assert [change.is_silent for change in renamed.values()] == [True]
    version = told(old, message(field("uint8_t_mavlink_version", "a")))
    assert version["field-type-changed M.a"].notice is Notice.SILENT


def test_what_moves_is_told_with_its_bytes(told: Told) -> None:
    """And what stays is not said to move."""
    stays = told(message(A, B), message(A, EXTENSIONS, B))
    assert stays["extension-boundary-moved M.b"].effect == "it stays at byte 1"
    moves = told(message(A, EXTENSIONS, field("uint16_t", "w")), message(A, field("uint16_t", "w")))
    assert moves["extension-boundary-moved M.w"].effect == "it goes from byte 1 to byte 0"
    assert told(message(A), message(B, A))["field-added M.b"].effect == "the payload goes from 1 to 2 bytes"
    replaced = told(message(A, B), message(B, field("uint8_t", "c")))
    assert replaced["field-added M.c"].effect == "the payload still has 2 bytes"


@pytest.mark.parametrize(
    ("old", "new", "effect"),
    [
        ("uint16_t", "int16_t", "the other version reads other numbers"),
        ("uint16_t", "uint32_t", "the other version reads other numbers, and f from the wrong bytes"),
        ("uint16_t[4]", "uint16_t[3]", "the other version reads another number of values, and f from the wrong bytes"),
    ],
)
def test_an_extension_of_another_type_moves_only_what_it_moves(old: str, new: str, effect: str, told: Told) -> None:
    last = field("uint8_t", "f")
    for first, second in ((old, new), (new, old)):
        found = told(*(message(A, EXTENSIONS, field(kind, "e"), last) for kind in (first, second)))
        assert found["field-type-changed M.e"].effect == effect
    alone = told(*(message(A, EXTENSIONS, field(kind, "e")) for kind in (old, new)))
    assert alone["field-type-changed M.e"].effect == effect.partition(", and")[0]


def test_a_sentinel_that_is_gone_misleads_new_receivers(told: Told) -> None:
    """An old sender means unknown by it; new receivers believe it."""
    given, gone = message(field("float", "a", invalid="NaN")), message(field("float", "a"))
    found = told(given, gone)["field-sentinel-changed M.a"]
    assert Victim.NEW_STATION in found.breaks
    assert found.effect.startswith("new receivers take an old sender's NaN for a measurement")
    assert told(gone, given)["field-sentinel-changed M.a"].breaks == (Victim.OLD_STATION,)


@pytest.mark.parametrize(
    ("text", "is_described"),
    [
        ("Level, 0 to 100.", False),
        ("Level 0..100. Not filtered.", False),
        ("Level, 0: not measured", True),
        ("Level (0 if unknown)", True),
        ("Level. Set to 0 by a dumb battery.", True),
    ],
)
def test_a_number_in_a_description_is_no_sentinel_by_itself(text: str, is_described: bool, told: Told) -> None:
    plain, stated = message(field("uint8_t", "a", text)), message(field("uint8_t", "a", text, invalid="0"))
    for old, new in ((plain, stated), (stated, plain)):
        assert told(old, new)["field-sentinel-changed M.a"].is_breaking is not is_described


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ({"units": "hPa"}, {"units": "mbar"}),
        ({"units": "cdegC"}, {"units": "degC", "multiplier": "1E-2"}),
        ({"units": "m", "multiplier": "0.1"}, {"units": "cm", "multiplier": "10"}),
    ],
)
def test_a_unit_that_means_the_same_number_breaks_nobody(old: dict[str, str], new: dict[str, str], told: Told) -> None:
    """Another name of a unit, and a unit and a multiplier that make up for each other."""
    before, after = (message(field("int16_t", "a", **attributes)) for attributes in (old, new))
    for first, second in ((before, after), (after, before)):
        found = told(first, second)
        assert {change.effect for change in found.values()} == {"the same value is the same number as before"}
        assert not any(change.is_breaking for change in found.values())
    alone = told(before, message(field("int16_t", "a", **{**new, "units": "kg"})))
    assert alone["field-units-changed M.a"].is_silent


def test_a_unit_that_is_gone_is_not_another_unit(told: Told) -> None:
    found = told(message(field("int16_t", "a", units="m")), message(field("int16_t", "a")))["field-units-changed M.a"]
    assert (found.effect, found.is_silent) == ("nothing says what the number counts any more", True)


def test_an_enum_under_another_name_breaks_nobody(told: Told) -> None:
    old, new = (message(field("uint8_t", "a", enum=name)) for name in ("E", "F"))
    same = told(old, new, (enum("E", X=1, Y=2), enum("F", X=1, Y=2)))
    assert same["field-enum-changed M.a"].effect == "another name of the same enum"
    assert not any(change.is_breaking for change in same.values())
    other = told(old, new, (enum("E", X=1, Y=2), enum("F", X=2, Y=1)))
    assert other["field-enum-changed M.a"].is_silent


def test_two_entries_of_one_value_are_both_missed(told: Told) -> None:
    """A dialect that has them is wrong, and is compared all the same."""
    found = told(message(A), message(A), (enum("E", X=1, Y=1, Z=2), enum("E", Z=2)))
    assert found.keys() == {"enum-entry-removed E.X", "enum-entry-removed E.Y"}


def test_a_shorter_array_is_unknown_by_the_same_value(told: Told) -> None:
    """``[0]`` is ``[0]``, of four elements and of three: the other length is one break, and not two."""
    arrays = [EXTENSIONS + field(f"uint8_t[{count}]", "b", invalid="[0]") for count in (4, 3)]
    for old, new in (arrays, arrays[::-1]):
        assert [*told(message(A, old), message(A, new))] == ["field-type-changed M.b"]
    other = EXTENSIONS + field("uint8_t[3]", "b", invalid="[1]")
    assert "field-sentinel-changed M.b" in told(message(A, arrays[0]), message(A, other))
