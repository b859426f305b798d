"""Modules of the program get the numbers of the dialect as constants of their own."""

import re
from dataclasses import replace
from pathlib import Path

import pytest
from pymavlink.dialects.v20 import common

from codegen.diagnostics import Report
from codegen.model.absence import ABSENCE_FIELDS
from codegen.project.systems import read_system
from codegen.resolve.program.services import SERVICE_FIELDS, Uses, service_messages
from codegen.targets.firmware.numbers import with_numbers

PROGRAM = Path(__file__).resolve().parents[2] / "templates" / "firmware" / "program"

MODULE = '''"""What it is about."""

import time

import dialect
from micropython import const
from other import (
    one,
    two,
)

_OWN = const(3)


def answer():
    """Return dialect.MAV_B, or else dialect.MAV_A."""
    return dialect.MAV_B or dialect.MAV_A or one
'''


def test_constants_stand_below_the_imports() -> None:
    """Each once, sorted; nothing is imported for them any more."""
    text = with_numbers(MODULE, {"MAV_A": 7, "MAV_B": 8, "MAV_C": 9})
    start, _, end = text.partition(")\n\n# Numbers of the dialect.\n_MAV_A = const(7)\n_MAV_B = const(8)\n\n_OWN")
    assert start.endswith("import time\n\nfrom micropython import const\nfrom other import (\n    one,\n    two,\n")
    assert end.endswith("    return _MAV_B or _MAV_A or one\n")


def test_other_modules_stay_as_they_are() -> None:
    """Without a number nothing is changed."""
    assert with_numbers("import time\n", {"MAV_A": 7}) == "import time\n"


def test_a_number_that_is_not_listed_is_no_number() -> None:
    """A template that uses a number has to list it."""
    with pytest.raises(KeyError, match="MAV_B"):
        with_numbers(MODULE, {"MAV_A": 7})


def test_fields_that_modules_write_are_those_that_a_dialect_has_to_have() -> None:
    """A dialect without one is a finding, and so no KeyError."""
    texts = [path.read_text(encoding="utf-8") for path in PROGRAM.iterdir() if path.is_file()]
    used = {name for text in texts for name in re.findall(r"dialect\.(\w+)_AT\b", text)}
    services, absences = (
        {f"{name}_{field}".upper() for name, fields in listed.items() for field in fields.split()}
        for listed in (SERVICE_FIELDS, ABSENCE_FIELDS)
    )
    assert services <= used <= services | absences


def test_modules_have_the_places_of_fields_that_pymavlink_has() -> None:
    """As they stand in the rover's firmware."""
    service = PROGRAM.parents[2] / "generated" / "common" / "firmware" / "parameter_service.py"
    found = dict(re.findall(r"_PARAM_VALUE_(\w+)_AT = const\((\d+)\)", service.read_text("utf-8")))
    message = common.MAVLink_param_value_message(b"ABCDEFGHIJKLMNOP", 0.0, 9, 0x0201, 0x0403)
    payload = message.pack(common.MAVLink(None))[10:]
    bytes_of = {name: payload[int(place) :] for name, place in found.items()}
    assert bytes_of["PARAM_ID"].startswith(b"ABCDEFGHIJKLMNOP\x09")
    assert bytes_of["PARAM_COUNT"].startswith(b"\x01\x02\x03\x04")
    assert bytes_of["PARAM_INDEX"].startswith(b"\x03\x04")
    assert bytes_of["PARAM_TYPE"][0] == 9
    assert int(found["PARAM_VALUE"]) == 0


def test_a_dialect_whose_message_lacks_a_field_is_a_finding() -> None:
    """As one would be that has COMMAND_ACK without the extensions that say whom it is for."""
    system = read_system(str(PROGRAM.parents[2] / "specs" / "codegen.yaml"), Report())
    assert system is not None
    assert system.program is not None
    ack = system.dialect.messages["COMMAND_ACK"]
    short = replace(ack, fields=tuple(field for field in ack.fields if not field.name.startswith("target_")))
    dialect = replace(system.dialect, messages={**system.dialect.messages, "COMMAND_ACK": short})
    report = Report()
    service_messages(system.program.spec, dialect, report, Uses())
    (found,) = report
    assert found.message == "common has no field COMMAND_ACK.target_component, COMMAND_ACK.target_system"
    report = Report()
    service_messages(system.program.spec, system.dialect, report, Uses())
    assert not list(report)
