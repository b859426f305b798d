"""Every change on the wire between two real releases of pymavlink is the one that pymavlink's own parser sees."""

import os
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from pymavlink.generator import mavparse

from codegen.diff.change import Change
from codegen.diff.dialect.dialect import dialect_changes
from codegen.diff.sides import Around, Side, opened
from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_path
from codegen.project.systems import read_systems

DIALECTS = ("common", "ardupilotmega", "all", "storm32")


@dataclass(frozen=True)
class Theirs:
    """A dialect as pymavlink's parser reads it: messages by name, entries by enum and name."""

    messages: dict[str, mavparse.MAVType] = field(default_factory=dict)
    enums: dict[str, dict[str, int]] = field(default_factory=dict)


def parsed(path: str) -> Theirs:
    """A dialect with its includes, each file once, as mavgen reads it."""
    found, waiting, seen = Theirs(), [path], set()
    while waiting:
        file = waiting.pop()
        if file in seen:
            continue
        seen.add(file)
        xml = mavparse.MAVXML(file, mavparse.PROTOCOL_2_0)
        waiting += [os.path.normpath(os.path.join(os.path.dirname(file), include)) for include in xml.include]
        for message in xml.message:
            found.messages[message.name] = message
        for enum in xml.enum:
            entries = found.enums.setdefault(enum.name, {})
            entries.update({one.name: one.value for one in enum.entry if not one.name.endswith("_ENUM_END")})
    return found


@dataclass(frozen=True)
class Compared:
    """Both releases of a dialect: our changes, and what pymavlink's parser says of each."""

    changes: tuple[Change, ...]
    old: Theirs
    new: Theirs

    def told(self, *rules: str) -> set[str]:
        return {change.subject for change in self.changes if change.rule.id in rules}


@pytest.fixture(scope="session")
def folder(older_pymavlink: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The dialects of the older release, for a parser that needs files."""
    where = tmp_path_factory.mktemp("older")
    with zipfile.ZipFile(older_pymavlink) as wheel:
        for name in wheel.namelist():
            if "/v20/" in name and name.endswith(".xml"):
                (where / Path(name).name).write_bytes(wheel.read(name))
    return where


@pytest.fixture(scope="module", params=DIALECTS)
def compared(request: pytest.FixtureRequest, older_pymavlink: Path, folder: Path) -> Iterator[Compared]:
    name = request.param
    around = Around(None, name, read_systems)
    new_path = shipped_dialect_path(name, DISK)
    assert new_path is not None
    with opened(str(older_pymavlink), around) as old, opened(name, around) as new:
        assert isinstance(old, Side)
        assert isinstance(new, Side)
        changes = dialect_changes(old.dialect, new.dialect)
        yield Compared(changes, parsed(str(folder / f"{name}.xml")), parsed(new_path))


def fields_of(message: mavparse.MAVType) -> dict[str, tuple[str, int, bool]]:
    """Type, number of elements and whether it is an extension, by the name of each field."""
    extensions = message.extensions_start
    return {
        one.name: (one.type, one.array_length, extensions is not None and index >= extensions)
        for index, one in enumerate(message.fields)
    }


def test_messages_that_come_and_go(compared: Compared) -> None:
    """Those with a new name or a new id, too."""
    old, new = compared.old.messages, compared.new.messages
    added, removed = new.keys() - old.keys(), old.keys() - new.keys()
    assert compared.told("message-added") | compared.told("message-renamed") == added
    renamed = {change.old for change in compared.changes if change.rule.id == "message-renamed"}
    assert compared.told("message-removed") | renamed == removed
    assert compared.told("message-id-changed") == {
        name for name in old.keys() & new.keys() if old[name].id != new[name].id
    }
    assert added, "the releases differ"


def test_crc_extra_and_its_causes(compared: Compared) -> None:
    """The byte of both sides, and a cause for each that differs."""
    old, new = compared.old.messages, compared.new.messages
    differing = {name for name in old.keys() & new.keys() if old[name].crc_extra != new[name].crc_extra}
    found = [change for change in compared.changes if change.rule.id == "crc-extra-changed" and change.subject in old]
    assert {change.subject for change in found} == differing
    for change in found:
        assert (change.old, change.new) == (str(old[change.subject].crc_extra), str(new[change.subject].crc_extra))
        assert change.causes


def test_fields_that_come_go_or_change(compared: Compared) -> None:
    """Names, types and sides of all fields of messages that both releases have."""
    old, new = compared.old.messages, compared.new.messages
    expected: dict[str, set[str]] = {"gone": set(), "new": set(), "other": set()}
    for name in old.keys() & new.keys():
        before, after = fields_of(old[name]), fields_of(new[name])
        expected["gone"] |= {f"{name}.{one}" for one in before.keys() - after.keys()}
        expected["new"] |= {f"{name}.{one}" for one in after.keys() - before.keys()}
        expected["other"] |= {f"{name}.{one}" for one in before.keys() & after.keys() if before[one] != after[one]}
    renamed = [change for change in compared.changes if change.rule.id == "field-renamed"]
    was = {f"{change.subject.partition('.')[0]}.{change.old}" for change in renamed}
    shared = {f"{name}." for name in old.keys() & new.keys()}
    ours = {rule: {one for one in compared.told(*rule) if f"{one.partition('.')[0]}." in shared} for rule in (
        ("field-removed",), ("field-added", "extension-added"), ("field-type-changed", "extension-boundary-moved"),
    )}  # fmt: skip
    gone, added, other = ours.values()
    assert gone | was == expected["gone"]
    assert added | {change.subject for change in renamed} == expected["new"]
    assert other == expected["other"]


def test_enum_entries(compared: Compared) -> None:
    """Entries that came and went, and those with another number, are the same."""
    old, new = compared.old.enums, compared.new.enums
    both = old.keys() & new.keys()
    added = {f"{enum}.{name}" for enum in both for name in new[enum].keys() - old[enum].keys()}
    removed = {f"{enum}.{name}" for enum in both for name in old[enum].keys() - new[enum].keys()}
    other = {
        f"{enum}.{name}" for enum in both for name in old[enum].keys() & new[enum].keys()
        if old[enum][name] != new[enum][name]
    }  # fmt: skip
    renamed = [change for change in compared.changes if change.rule.id == "enum-entry-renamed"]
    was = {f"{change.enum}.{change.old}" for change in renamed}
    assert compared.told("enum-entry-added") | {change.subject for change in renamed} == added
    assert compared.told("enum-entry-removed") | was == removed
    assert compared.told("enum-entry-value-changed") == other
    assert compared.told("enum-added") == new.keys() - old.keys()
    assert compared.told("enum-removed") == old.keys() - new.keys()
    assert added, "the releases differ"


def test_units_are_those_that_the_parser_reads(compared: Compared) -> None:
    """Of fields that both releases have under one name."""
    old, new = compared.old.messages, compared.new.messages
    expected = set()
    for name in old.keys() & new.keys():
        before = {one.name: one.units or "" for one in old[name].fields}
        after = {one.name: one.units or "" for one in new[name].fields}
        shared = before.keys() & after.keys()
        expected |= {f"{name}.{one}" for one in shared if _unit(before[one]) != _unit(after[one])}
    renamed = {change.subject for change in compared.changes if change.rule.id == "field-renamed"}
    assert compared.told("field-units-changed") - renamed == expected


def _unit(written: str) -> str:
    return written.strip("[]")
