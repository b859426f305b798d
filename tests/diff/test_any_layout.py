"""Messages changed at random: what is told of the wire agrees with what pymavlink makes of both versions."""

import random
from collections.abc import Iterator
from pathlib import Path

from pymavlink.generator import mavparse

from codegen.diff.change import Change, Notice
from codegen.diff.dialect.dialect import dialect_changes
from codegen.diff.sides import Around, Side, opened
from codegen.model.dialect.dialect import Dialect
from codegen.project.systems import read_systems

TYPES = ("uint8_t", "int8_t", "uint16_t", "int16_t", "uint32_t", "float", "double", "char", "char[4]", "uint16_t[2]")
UNITS = ("m", "cm", "V")
ROUNDS = 200

Field = tuple[str, str, str]  # type, name, units
Sides = tuple[list[Field], list[Field]]  # base fields, extensions


def some(dice: random.Random) -> Sides:
    base = [(dice.choice(TYPES), f"b{number}", "m") for number in range(dice.randint(1, 4))]
    return base, [(dice.choice(TYPES), f"e{number}", "m") for number in range(dice.randint(0, 3))]


def changed_at_random(sides: Sides, dice: random.Random) -> Sides:
    base, extensions = list(sides[0]), list(sides[1])
    for _ in range(dice.randint(1, 3)):
        fields = dice.choice([base, extensions])
        edit = dice.randrange(6)
        index = dice.randrange(len(fields) + (edit == 0)) if fields or edit == 0 else None
        if edit == 0 and index is not None:
            fields.insert(index, (dice.choice(TYPES), f"n{dice.randrange(1000)}", "m"))
        elif edit == 1 and index is not None and (fields is extensions or len(base) > 1):
            del fields[index]
        elif edit == 2 and index is not None:
            kind, name, unit = fields[index]
            renewed = (
                (dice.choice(TYPES), name, unit),
                (kind, f"r{dice.randrange(1000)}", unit),
                (kind, name, dice.choice(UNITS)),
            )
            fields[index] = dice.choice(renewed)
        elif edit == 3:
            dice.shuffle(fields)
        elif edit == 4 and len(base) > 1:
            extensions.insert(0, base.pop())
        elif edit == 5 and extensions:
            base.append(extensions.pop(0))
    return base, extensions


def written(sides: Sides, file: Path) -> Path:
    parts = [
        "".join(f'<field type="{kind}" name="{name}" units="{unit}">d</field>' for kind, name, unit in side)
        for side in sides
    ]
    fields = "<extensions/>".join(parts if parts[1] else parts[:1])
    message = f'<message id="7" name="M"><description>d</description>{fields}</message>'
    file.write_text(f"<mavlink><version>3</version><messages>{message}</messages></mavlink>")
    return file


def ours(file: Path) -> Dialect:
    with opened(str(file), Around(None, "common", read_systems)) as side:
        assert isinstance(side, Side)
        return side.dialect


Bytes = dict[str, tuple[str, int, int]]


def bytes_of(message: mavparse.MAVType) -> Bytes:
    """Type, number of elements and first byte, by the name of each field."""
    return {one.name: (one.type, one.array_length, one.wire_offset) for one in message.fields}


def pairs(folder: Path) -> Iterator[tuple[tuple[Change, ...], mavparse.MAVType, mavparse.MAVType]]:
    """Our changes, and both versions as pymavlink reads them."""
    dice = random.Random(20)
    for _ in range(ROUNDS):
        old = some(dice)
        files = written(old, folder / "old.xml"), written(changed_at_random(old, dice), folder / "new.xml")
        theirs = [mavparse.MAVXML(str(file), mavparse.PROTOCOL_2_0).message[0] for file in files]
        yield dialect_changes(ours(files[0]), ours(files[1])), *theirs
        yield dialect_changes(ours(files[1]), ours(files[0])), *reversed(theirs)


def test_notice_is_what_crc_extra_does(tmp_path: Path) -> None:
    """Nothing is missed; nothing is silent that is dropped, nothing noticed that is read; what moves is dangerous."""
    silent = 0
    for changes, old, new in pairs(tmp_path):
        before, after = bytes_of(old), bytes_of(new)
        is_dropped = old.crc_extra != new.crc_extra
        case = f"{before} -> {after}: {[(change.rule.id, change.subject) for change in changes]}"
        assert bool(changes) or (before, old.extensions_start) == (after, new.extensions_start), case
        assert any(change.rule.id == "crc-extra-changed" for change in changes) is is_dropped, case
        assert all(change.causes for change in changes if change.rule.id == "crc-extra-changed"), case
        breaking = {change.notice for change in changes if change.is_breaking}
        assert breaking <= ({Notice.NOTICED} if is_dropped else {Notice.SILENT}), case
        moved = {name for name in before.keys() & after.keys() if before[name] != after[name]}
        if moved and not is_dropped:
            assert Notice.SILENT in breaking, case
            silent += 1
    assert silent > ROUNDS // 10, "extensions moved"
