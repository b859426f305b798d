"""Corrections change attributes of the dialect, its wire only where an overlay adds it, and all have their grounds."""

from collections.abc import Callable
from types import SimpleNamespace

import pytest

from codegen.diagnostics import Severity
from codegen.model.dialect.dialect import SentinelForm
from codegen.model.spec.spec import Correction
from codegen.source import Place

Read = Callable[..., SimpleNamespace]

HERE = Place("/corrections.yaml", 12, 5)
XML = """<mavlink>
<enums>
<enum name="STATE"><entry name="STATE_A" value="1"/><entry name="STATE_B" value="2"/></enum>
<enum name="FLAGS" bitmask="true"><entry name="FLAG_A" value="1"/></enum>
<enum name="MAV_CMD"><entry name="DO" value="9"><param index="1" minValue="1">p</param></entry></enum>
</enums>
<messages>
<message id="1" name="M">
<field type="uint16_t" name="volts" units="V" invalid="0" multiplier="1E-2" minValue="1" maxValue="9"/>
<field type="uint8_t[3]" name="cells"/>
<field type="uint8_t" name="flags" enum="FLAGS"/>
<field type="uint8_t" name="state" instance="true" display="bitmask"/>
<field type="char[4]" name="name"/>
</message>
</messages>
</mavlink>"""


PARAM: dict[str, object] = {"enum": "MAV_CMD", "entry": "DO", "param": "1"}


def correction(**keys: object) -> Correction:
    grounds = {"reason": "why", "source": "where", "place": HERE}
    return Correction(**{**grounds, **keys})  # type: ignore[arg-type]


def of_field(field: str, **attributes: str) -> Correction:
    return correction(message="M", field=field, set=attributes)


@pytest.mark.parametrize(
    ("field", "attribute", "text", "key", "value"),
    [
        ("volts", "invalid", "UINT16_MAX", "invalid", "UINT16_MAX"),
        ("volts", "invalid", "", "invalid", None),
        ("volts", "units", "mV", "units", "mV"),
        ("volts", "units", "", "units", None),
        ("volts", "multiplier", "1E-3", "multiplier", "1E-3"),
        ("volts", "minValue", "2", "minimum", "2"),
        ("volts", "maxValue", " 8 ", "maximum", "8"),
        ("volts", "instance", "true", "is_instance", True),
        ("state", "instance", "false", "is_instance", False),
        ("state", "instance", "", "is_instance", False),
        ("volts", "display", "bitmask", "is_bitmask", True),
        ("state", "display", "", "is_bitmask", False),
        ("state", "enum", "STATE", "enum", "STATE"),
        ("flags", "enum", "", "enum", None),
        ("volts", "description", "Of  all\n cells.", "description", "Of all cells."),
    ],
)
def test_attributes(field: str, attribute: str, text: str, key: str, value: object, read: Read) -> None:
    """Each attribute that can be set, and taken away by the empty text; CRC_EXTRA and lengths stay."""
    plain = read(XML).dialect.messages["M"]
    result = read(XML, corrections=(of_field(field, **{attribute: text}),))
    corrected = result.dialect.messages["M"]
    assert result.found == []
    assert getattr(corrected.field(field).definition, key) == value
    assert getattr(plain.field(field).definition, key) != value
    assert (corrected.crc_extra, corrected.length) == (plain.crc_extra, plain.length)


OVERLAY = """<mavlink><messages>
<message id="2" name="N"><wip/><description>Old.</description>
<field type="uint8_t" name="a"/><field type="uint16_t[3]" name="b" invalid="[0]"/></message>
<message id="?" name="O"><field type="uint8_t" name="a"/></message>
</messages></mavlink>"""


def test_what_an_overlay_adds_can_change_on_the_wire(read_overlay: Read) -> None:
    """Ids, one that was missing too, and types; layout, CRC_EXTRA and sentinels follow."""
    before = read_overlay(XML, OVERLAY)
    assert before.found == ["4:1 message-id"]
    result = read_overlay(
        XML,
        OVERLAY,
        corrections=(
            correction(message="N", set={"id": " 70000 ", "description": " New.\n", "wip": ""}),
            correction(message="N", field="b", set={"type": "uint32_t[4]"}),
            correction(message="O", set={"id": "2"}),
        ),
    )
    assert result.found == []
    old, new = (found.dialect.messages["N"] for found in (before, result))
    assert (new.id, new.length, result.dialect.messages["O"].id) == (70000, 17, 2)
    assert (new.definition.description, new.definition.lifecycle.wip) == ("New.", False)
    assert (old.definition.description, old.definition.lifecycle.wip) == ("Old.", True)
    assert new.crc_extra != old.crc_extra
    assert new.field("b").sentinel.values == (0, 0, 0, 0)
    assert list(result.dialect.messages) == ["M", "O", "N"], "in order of id"


def test_an_array_becomes_one_value(read_overlay: Read) -> None:
    """A type without length; the sentinel has to fit it, too."""
    one = correction(message="N", field="b", set={"type": "uint16_t", "invalid": "0"})
    number = correction(message="O", set={"id": "3"})
    result = read_overlay(XML, OVERLAY, corrections=(one, number))
    assert result.found == []
    assert not result.dialect.messages["N"].field("b").is_array


def test_a_corrected_id_that_is_taken_is_reported_at_the_correction(read_overlay: Read) -> None:
    """The XML is not to blame."""
    result = read_overlay(XML, OVERLAY, corrections=(correction(message="O", set={"id": "1"}),))
    assert [(one.rule.id, one.place) for one in result.report] == [("message-conflict", HERE)]


def test_a_corrected_sentinel_stands_where_the_correction_stands(read: Read) -> None:
    """So that findings and explanations lead to the correction and not to the XML."""
    result = read(XML, corrections=(of_field("cells", invalid="[255]"),))
    sentinel = result.dialect.messages["M"].field("cells").sentinel
    assert (sentinel.form, sentinel.values, sentinel.place) == (SentinelForm.EACH, (255, 255, 255), HERE)
    untouched = result.dialect.messages["M"].field("volts")
    assert untouched.sentinel.place == untouched.definition.place


def test_a_sentinel_that_cannot_be_is_reported_at_the_correction(read: Read) -> None:
    """The XML is not to blame."""
    result = read(XML, corrections=(of_field("cells", invalid="[256]"),))
    assert [(one.rule.id, one.place) for one in result.report] == [("sentinel-range", HERE)]


def test_an_entry_is_corrected_before_sentinels_are_read(read: Read) -> None:
    """A sentinel may be the entry's name."""
    corrections = (
        correction(enum="STATE", entry="STATE_B", set={"value": "0x80"}),
        of_field("state", enum="STATE", invalid="STATE_B"),
    )
    result = read(XML, corrections=corrections)
    assert result.found == []
    assert result.dialect.enums["STATE"].entry("STATE_B").value == 128
    assert result.dialect.messages["M"].field("state").sentinel.values == (128,)


def test_a_corrected_value_is_no_longer_implied(read: Read) -> None:
    """The correction writes what the XML left to counting."""
    xml = XML.replace(' value="2"', "")
    assert read(xml).dialect.enums["STATE"].entry("STATE_B").is_implicit
    result = read(xml, corrections=(correction(enum="STATE", entry="STATE_B", set={"value": "9"}),))
    assert not result.dialect.enums["STATE"].entry("STATE_B").is_implicit


def of_entry(entry: str, value: str) -> Correction:
    return correction(enum="STATE", entry=entry, set={"value": value}, place=Place("/c.yaml", ord(entry[-1]), 1))


@pytest.mark.parametrize(
    ("values", "lines"),
    [
        ({"A": "2", "B": "1"}, []),
        ({"B": "1", "A": "2"}, []),
        ({"A": "2", "B": "3", "C": "1"}, []),
        ({"A": "2", "B": "0x2"}, ["A"]),  # what stays is no exchange
        ({"A": "2", "B": "two"}, ["B"]),
        ({"A": "7", "B": "7"}, ["B"]),
        ({"A": "2", "C": "1"}, ["A"]),
        ({"A": "2", "B": "4"}, ["B"]),
    ],
)
def test_entries_may_exchange_their_values(values: dict[str, str], lines: list[str], read: Read) -> None:
    """What counts is the enum in which all are corrected; a number that two would have is an error, once."""
    more = '<entry name="STATE_C" value="3"/><entry name="STATE_D" value="4"/></enum>\n<enum name="FLAGS"'
    xml = XML.replace('</enum>\n<enum name="FLAGS"', more)
    corrections = tuple(of_entry(f"STATE_{name}", value) for name, value in values.items())
    result = read(xml, corrections=corrections)
    found = [chr(one.place.line) for one in result.report if one.rule.id == "correction-value"]
    assert found == lines
    if not lines:
        entries = {each.name[-1]: each.value for each in result.dialect.enums["STATE"].entries}
        assert entries == {"A": 1, "B": 2, "C": 3, "D": 4} | {name: int(value) for name, value in values.items()}


def test_corrections_are_applied_in_their_order(read: Read) -> None:
    """The later one wins."""
    result = read(XML, corrections=(of_field("volts", units="mV"), of_field("volts", units="cV")))
    assert result.dialect.messages["M"].field("volts").definition.units == "cV"


@pytest.mark.parametrize(
    ("keys", "rule", "hint"),
    [
        ({"message": "N", "field": "volts", "set": {"units": "mV"}}, "correction-unknown", "known: M"),
        ({"message": "M", "field": "volt", "set": {"units": "mV"}}, "correction-unknown", "volts"),
        ({"enum": "STAT", "entry": "STATE_A", "set": {"value": "3"}}, "correction-unknown", "STATE"),
        ({"enum": "STATE", "entry": "STATE_C", "set": {"value": "3"}}, "correction-unknown", "STATE_A"),
        ({"message": "M", "field": "volts", "set": {"unit": "mV"}}, "correction-attribute", "units"),
        ({"message": "M", "field": "volts", "set": {"type": "int16_t"}}, "correction-attribute", "receivers know"),
        ({"message": "M", "field": "volts", "set": {"name": "v"}}, "correction-attribute", "known"),
        ({"message": "M", "field": "volts", "set": {}}, "correction-attribute", ""),
        ({"message": "M", "field": "volts", "set": {"instance": "yes"}}, "correction-value", ""),
        ({"message": "M", "field": "volts", "set": {"display": "bits"}}, "correction-value", ""),
        ({"message": "M", "field": "volts", "set": {"enum": "STATES"}}, "correction-value", "STATE"),
        ({"enum": "STATE", "entry": "STATE_A", "set": {"name": "X"}}, "correction-attribute", "value"),
        ({"enum": "STATE", "entry": "STATE_A", "set": {"value": "-1"}}, "correction-value", ""),
        ({"enum": "STATE", "entry": "STATE_A", "set": {"value": "2"}}, "correction-value", ""),
        ({"enum": "FLAGS", "entry": "FLAG_A", "set": {"value": "256"}}, "correction-value", "a number up to 255"),
        (PARAM | {"set": {"minValue": "5", "maxValue": "3"}}, "correction-value", "swap them"),
        (PARAM | {"set": {"maxValue": "0"}}, "correction-value", "swap them"),
        (PARAM | {"set": {"increment": "0"}}, "correction-value", "above 0"),
        (PARAM | {"set": {"increment": "-1"}}, "correction-value", "above 0"),
        ({"message": "M", "field": "volts", "set": {"minValue": "50", "maxValue": "3"}}, "field-number", "minValue"),
        ({"message": "M", "field": "volts", "set": {"minValue": "10"}}, "field-number", "minValue"),
        ({"message": "M", "field": "volts", "set": {"maxValue": "0.5"}}, "field-number", "minValue"),
        ({"message": "M", "field": "volts", "set": {"multiplier": "0"}}, "field-number", "above 0"),
        ({"message": "M", "field": "volts", "set": {"multiplier": "-1"}}, "field-number", "above 0"),
        ({"message": "M", "field": "volts", "set": {"multiplier": "abc"}}, "field-number", "above 0"),
        ({"message": "M", "field": "volts", "set": {"increment": "abc"}}, "field-number", "a decimal number"),
        ({"message": "M", "field": "volts", "set": {"default": "abc"}}, "field-number", "a number, or NaN"),
        ({"message": "M", "field": "flags", "set": {"minValue": "300"}}, "field-number", "from 0 to 255"),
        ({"message": "M", "field": "flags", "set": {"maxValue": "-1"}}, "field-number", "from 0 to 255"),
        ({"message": "M", "field": "flags", "set": {"minValue": "1.2", "maxValue": "1.8"}}, "field-number", "whole"),
        ({"message": "M", "field": "volts", "set": {"unknown": "5-3"}}, "special-value", "UINT16_MAX"),
        ({"message": "M", "field": "volts", "set": {"unchanged": "1, 1.5"}}, "special-value", "whole numbers"),
        ({"message": "M", "field": "flags", "set": {"unknown": "256"}}, "special-value", "from 0 to 255"),
        ({"message": "M", "field": "name", "set": {"unknown": "0"}}, "special-value", "leave it out"),
        ({"set": {"units": "mV"}}, "correction-target", ""),
        ({"message": "M", "set": {"units": "mV"}}, "correction-attribute", "description"),
        ({"message": "M", "set": {"id": "2"}}, "correction-attribute", "receivers know"),
        ({"message": "N", "set": {"wip": ""}}, "correction-unknown", "known: M"),
        ({"field": "volts", "set": {"units": "mV"}}, "correction-target", ""),
        ({"message": "M", "entry": "STATE_A", "set": {"units": "mV"}}, "correction-target", ""),
        ({"message": "M", "field": "volts", "enum": "STATE", "set": {"units": "mV"}}, "correction-target", ""),
        (
            {"message": "M", "field": "volts", "enum": "STATE", "entry": "STATE_A", "set": {"units": "mV"}},
            "correction-target",
            "",
        ),
        ({"message": "M", "field": "volts", "set": {"units": "mV"}, "reason": " "}, "correction-unfounded", ""),
        ({"message": "M", "field": "volts", "set": {"units": "mV"}, "source": ""}, "correction-unfounded", ""),
    ],
)
def test_what_cannot_be_corrected(keys: dict[str, object], rule: str, hint: str, read: Read) -> None:
    """An error at the correction, with what could have been meant."""
    findings = list(read(XML, corrections=(correction(**keys),)).report)
    assert [(one.rule.id, one.place, one.rule.severity) for one in findings] == [(rule, HERE, Severity.ERROR)]
    assert hint in (findings[0].hint or "")


@pytest.mark.parametrize(
    "keys",
    [
        {"message": "M", "field": "volts", "set": {"invalid": "0"}},
        {"message": "M", "field": "volts", "set": {"units": " V "}},
        {"message": "M", "field": "cells", "set": {"units": ""}},
        {"message": "M", "field": "state", "set": {"display": "bitmask", "instance": "1"}},
        {"message": "M", "field": "flags", "set": {"display": "bitmask"}},
        {"enum": "STATE", "entry": "STATE_A", "set": {"value": "0x1"}},
    ],
)
def test_a_correction_that_changes_nothing_is_obsolete(keys: dict[str, object], read: Read) -> None:
    """A warning for each attribute, so that corrections leave when the dialect has caught up."""
    findings = list(read(XML, corrections=(correction(**keys),)).report)
    assert {(one.rule.id, one.rule.severity) for one in findings} == {("obsolete-correction", Severity.WARNING)}
    assert len(findings) == len(keys["set"])  # type: ignore[arg-type]


def test_an_obsolete_sentinel_stays_where_the_dialect_states_it(read: Read) -> None:
    """The correction is about to be removed; the XML stays."""
    field = read(XML, corrections=(of_field("volts", invalid="0"),)).dialect.messages["M"].field("volts")
    assert field.sentinel.place == field.definition.place


def test_findings_point_at_the_key_where_its_place_is_known(read: Read) -> None:
    """The decoder of the YAML file knows the place of each value."""
    places = {"field": Place("/corrections.yaml", 13, 12), "set": Place("/corrections.yaml", 14, 10)}
    wrong_field = correction(message="M", field="x", set={"units": "mV"}, places=places)
    wrong_attribute = correction(message="M", field="volts", set={"unit": "mV"}, places=places)
    findings = list(read(XML, corrections=(wrong_field, wrong_attribute)).report)
    assert [(one.rule.id, one.place.line) for one in findings] == [
        ("correction-unknown", 13),
        ("correction-attribute", 14),
    ]


def test_a_parameter_keeps_what_a_refused_correction_would_have_set(read: Read) -> None:
    """Neither its attributes change, nor what is said to be corrected."""
    result = read(XML, corrections=(correction(**PARAM, set={"minValue": "5", "maxValue": "3"}),))
    (parameter,) = result.dialect.enums["MAV_CMD"].entries[0].parameters
    assert (
        dict(parameter.attributes) == {"index": "1", "minValue": "1"} or dict(parameter.attributes)["minValue"] == "1"
    )
    assert result.dialect.corrections == ()


def test_an_entry_is_carried_where_one_field_carries_it(read: Read) -> None:
    """By a wider one, by a float, or by the parameter of a command; an enum without fields is not looked at."""
    value = correction(enum="FLAGS", entry="FLAG_A", set={"value": "256"})
    flags = '<field type="uint8_t" name="flags" enum="FLAGS"/>'
    wider = XML.replace(flags, flags + '<field type="uint16_t" name="wide" enum="FLAGS"/>')
    real = XML.replace(flags, flags + '<field type="float" name="wide" enum="FLAGS"/>')
    parameter = XML.replace('index="1" ', 'index="1" enum="FLAGS" ')
    for xml in (wider, real, parameter, XML.replace(flags, "")):
        assert read(xml, corrections=(value,)).found == []
    assert read(XML, corrections=(value,)).found == ["12:5 correction-value"]
