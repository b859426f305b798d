"""Several files become one dialect: enums are merged, messages may not contradict each other, overlays come last."""

from collections.abc import Callable
from types import SimpleNamespace

import pytest
from pymavlink.generator import mavparse

from codegen.diagnostics import Report
from codegen.resolve.dialect.dialect import resolve_dialect

Read = Callable[..., SimpleNamespace]
Write = Callable[..., str]


def enum(entries: str, attributes: str = "") -> str:
    return f"<mavlink><enums>\n<enum name='E' {attributes}>{entries}</enum></enums><messages/></mavlink>"


def entry(name: str, value: str | None = None) -> str:
    written = "" if value is None else f" value='{value}'"
    return f"\n<entry name='{name}'{written}/>"


def message(content: str, number: int = 1, name: str = "M") -> str:
    return f"<mavlink><messages>\n<message id='{number}' name='{name}'>{content}</message></messages></mavlink>"


def values(result: SimpleNamespace) -> dict[str, int]:
    return {one.name: one.value for one in result.dialect.enums["E"].entries}


@pytest.mark.parametrize(
    ("written", "value"),
    [("0", 0), ("12", 12), ("0x1F", 31), ("0X1f", 31), ("0b101", 5), ("2**31", 1 << 31), (str(2**64 - 1), 2**64 - 1)],
)
def test_entry_values(written: str, value: int, read: Read) -> None:
    """Every way in which dialects write a value."""
    result = read(enum(entry("A", written)))
    assert (result.found, values(result)) == ([], {"A": value})


@pytest.mark.parametrize(
    "parts",
    [
        [[("A", None), ("B", None), ("C", "9"), ("D", None), ("E1", "3"), ("F", None)]],
        [[("A", "0"), ("B", None)]],
        [[("A", "1"), ("B", "5")], [("C", None), ("D", None)]],
        [[("A", "100"), ("B", "105")], [("C", None), ("D", None)]],
        [[("A", "1"), ("B", "5")], [("C", "3"), ("D", None), ("E1", "20"), ("F", None)]],
        [[("A", None), ("B", None)], [("C", None)]],
        [[("A", "5")], [("B", "4"), ("C", None)]],
    ],
)
def test_entries_without_a_value_are_numbered_as_mavgen_numbers_them(
    parts: list[list[tuple[str, str | None]]], read: Read, write: Write, capsys: pytest.CaptureFixture[str]
) -> None:
    """Within a file the highest so far plus one; over files, entries of the including file move out of the way."""
    texts = [enum("".join(entry(*one) for one in part)) for part in parts]
    result = read(*texts)
    # mavgen reads the including file first.
    parsed = [mavparse.MAVXML(write(text, f"o{n}.xml"), mavparse.PROTOCOL_2_0) for n, text in enumerate(texts)][::-1]
    mavparse.merge_enums(parsed)
    capsys.readouterr()
    expected = {one.name: one.value for one in parsed[0].enum[0].entry if not one.end_marker}
    assert result.found == []
    assert values(result) == expected
    written = {name: value for part in parts for name, value in part}
    assert all(one.is_implicit == (written[one.name] is None) for one in result.dialect.enums["E"].entries)


def test_enums_of_all_files_are_one(read: Read) -> None:
    """Entries in the order of the files; a bitmask in one file is a bitmask; the first description and place count."""
    result = read(enum(entry("B", "2")), enum("<description>Flags</description>" + entry("A", "1"), "bitmask='true'"))
    merged = result.dialect.enums["E"]
    assert result.found == []
    assert (list(values(result).items()), merged.is_bitmask, merged.description) == (
        [("B", 2), ("A", 1)],
        True,
        "Flags",
    )
    assert merged.place == result.files[0].enums[0].place


@pytest.mark.parametrize(
    "attributes", [("bitmask='true'", ""), ("", "bitmask='1'"), ("bitmask='false'", "bitmask='true'")]
)
def test_a_bitmask_in_one_file_is_a_bitmask(attributes: tuple[str, str], read: Read) -> None:
    """Whichever file it is."""
    result = read(enum(entry("A", "1"), attributes[0]), enum(entry("B", "2"), attributes[1]))
    assert result.dialect.enums["E"].is_bitmask


def test_the_same_entry_twice_is_fine(read: Read) -> None:
    """Dialects copy entries of others; 0x10 and 16 are the same value."""
    result = read(enum(entry("A", "0x10")), enum(entry("A", "16")))
    assert (result.found, values(result)) == ([], {"A": 16})


@pytest.mark.parametrize(("name", "value"), [("A", "2"), ("B", "1")])
def test_contradicting_entries(name: str, value: str, read: Read) -> None:
    """One name with two values, or one value with two names: an error with both places."""
    result = read(enum(entry("A", "1")), enum("\n" + entry(name, value)))
    assert result.found == ["4:1 enum-conflict"]
    finding = next(iter(result.report))
    assert [place for place, _ in finding.related] == [result.files[0].enums[0].entries[0].place]


FIELD = "<field type='uint8_t' name='f' units='V'>F</field>"


def test_the_same_message_twice_is_fine(read: Read) -> None:
    """An overlay may bring a message that the dialect has got by now; descriptions may differ."""
    result = read(message(FIELD), message(f"\n<description>More</description>{FIELD.replace('>F<', '>G<')}"))
    assert result.found == []
    assert result.dialect.messages["M"].definition.fields[0].description == "F"


@pytest.mark.parametrize(
    "second",
    [
        message(FIELD, number=2),
        message(FIELD, name="N"),
        message(FIELD, number=2, name="m"),
        message(FIELD.replace("uint8_t", "int8_t")),
        message(FIELD.replace("'V'", "'mV'")),
        message(FIELD + FIELD.replace("'f'", "'g'")),
        message("<extensions/>" + FIELD),
    ],
)
def test_contradicting_messages(second: str, read: Read) -> None:
    """Same name or id, other content: an error with both places, and the first one is kept."""
    result = read(message(FIELD), second)
    assert result.found == ["2:1 message-conflict"]
    finding = next(iter(result.report))
    assert [place for place, _ in finding.related] == [result.files[0].messages[0].place]
    assert [one.id for one in result.dialect.messages.values()] == [1]


def test_overlays_add_messages_and_entries(read: Read) -> None:
    """Messages come in the order of their ids, whatever file they are from; fields may use enums of any file."""
    result = read(
        message(FIELD, number=9, name="NINE"),
        message("<field type='uint8_t' name='f' enum='E'/>", number=3, name="THREE"),
        enum(entry("A", "1"), "bitmask='true'"),
    )
    assert result.found == []
    assert list(result.dialect.messages) == ["THREE", "NINE"]
    assert result.dialect.messages["THREE"].definition.fields[0].is_bitmask
    assert result.dialect.files == tuple(file.path for file in result.files)


def test_a_file_that_comes_twice_counts_once(read: Read) -> None:
    """Dialect and overlay may include the same file; entries without a value would contradict themselves."""
    text = enum(entry("A") + entry("B"))
    files = read(text).files
    report = Report()
    dialect = resolve_dialect("d", files + files, (), report)
    assert list(report) == []
    assert dialect.files == tuple(file.path for file in files)


HEARTBEAT = "<messages><message id='0' name='H'><field type='uint8_t_mavlink_version' name='v'/></message></messages>"


@pytest.mark.parametrize(
    ("first", "second", "version"),
    [
        (f"<version>3</version>{HEARTBEAT}", "<version>1</version>", 3),
        (HEARTBEAT, "<version>1</version>", 1),
        ("<version>5</version>", "", 5),
        ("<version>5</version>", "<version>6</version>", 6),
        ("", "", 2),
    ],
)
def test_version(first: str, second: str, version: int, read: Read) -> None:
    """The version is that of the file which declares the version field; else the last one stated; else mavgen's 2."""
    assert read(f"<mavlink>{first}</mavlink>", f"<mavlink>{second}</mavlink>").dialect.version == version


def test_wire_order_is_stable_and_leaves_extensions_alone(read: Read) -> None:
    """Largest element first, equal ones as written, arrays by their element; extensions at the end as written."""
    types = ["uint8_t", "uint16_t", "uint8_t[9]", "double", "int16_t", "float[2]", "char"]
    base = "".join(f"<field type='{one}' name='b{n}'/>" for n, one in enumerate(types))
    extensions = "<extensions/><field type='uint8_t' name='e0'/><field type='uint64_t' name='e1'/>"
    found = read(message(base + extensions)).dialect.messages["M"]
    assert [field.name for field in found.fields] == ["b3", "b5", "b1", "b4", "b0", "b2", "b6", "e0", "e1"]
    assert [field.offset for field in found.fields] == [0, 8, 16, 18, 20, 21, 30, 31, 32]
    assert (found.base_length, found.length) == (31, 40)
    assert found.crc_extra == read(message(base)).dialect.messages["M"].crc_extra
