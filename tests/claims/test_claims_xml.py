"""XML in documents: messages that cannot work, quotations that differ from the dialect, and the text about them."""

from typing import Any

import pytest

DRAFT = """\
# A draft of two messages

It takes the place of BATTERY_STATUS.

```xml
<message id="900" name="PACK_STATUS">
  <description>About a pack.</description>
  <field type="uint8_t" name="id" instance="true">Which one.</field>
  <field type="float" name="charge_left" units="Ah" invalid="NaN">Charge. UINT32_MAX: not provided.</field>
  <field type="uint32_t" name="flags" display="bitmask" enum="PACK_FLAGS">What is up.</field>
</message>
<enum name="PACK_FLAGS">
  <entry value="1" name="PACK_FLAGS_A"/>
  <entry value="2" name="PACK_FLAGS_B"/>
  <entry value="0xFF" name="PACK_FLAGS_ALL"/>
</enum>
```

- It has a `voltage` of its own, to allow packs of more than 65 V.
- `current_consumed` was an `int32_t`: no more 32767 mAh limit.
- It has no `time_remaining`:

  ```xml
    <field type="uint32_t" name="time_remaining" units="s" invalid="UINT32_MAX">Time.</field>
    <field type="uint8_t" name="charge_state" enum="MAV_BATTERY_CHARGE_STATE">State.</field>
  ```

## Cells

```xml
<message id="147" name="PACK_CELLS">
  <description>For more than 126 cells it is sent several times.</description>
  <field type="uint16_t" name="id">Which pack.</field>
  <field type="uint16_t" name="index">First cell, for packs of more than 12 cells.</field>
  <field type="uint16_t[126]" name="cells" units="mV" invalid="[0]">Voltage of up to 126 cells.</field>
</message>
```

So the message will not be truncated, and PACK_STATUS is 9 bytes.

Or else:

```xml
<message id="???" name="PACK_CELLS">
  <field type="uint8_t" name="id">Which pack.</field>
  <field type="uint64_t" name="faults">Faults of 64 cells.</field>
</message>
```
"""

EXPECTED = [
    ("claim-text-contradicts-invalid", 9, 3, "the text says UINT32_MAX, the attribute NaN"),
    ("claim-flag-of-several-bits", 15, 3, "PACK_FLAGS_ALL is 0xFF: 8 bits"),
    ("claim-limit", 19, 62, "BATTERY_STATUS.voltages carries more than 65 V"),
    ("claim-limit", 20, 48, "BATTERY_STATUS.current_consumed is int32_t: its limit is 2147483647 mAh, not 32767"),
    ("claim-field", 24, 5, "BATTERY_STATUS.time_remaining is int32_t, not uint32_t and cannot be UINT32_MAX"),
    ("claim-id-taken", 31, 1, "PACK_CELLS has the id 147 of BATTERY_STATUS"),
    ("claim-unsendable-message", 31, 1, "2 * 2 + 252 = 256 bytes, and a frame carries 255"),
    ("claim-count", 34, 3, "12 cells here, but cells has 126"),
    ("claim-truncation", 39, 8, "it ends with cells, of which what is unknown is 0"),
    ("claim-defined-twice", 45, 3, "id uint8_t here, uint16_t there"),
]


def test_a_draft_is_read_line_by_line(check: Any) -> None:
    findings = sorted(check(DRAFT), key=lambda one: (one.place, one.rule.id))
    assert [(one.rule.id, one.place.line, one.place.column) for one in findings] == [one[:3] for one in EXPECTED]
    wrong = [
        (one[3], found.message) for one, found in zip(EXPECTED, findings, strict=True) if one[3] not in found.message
    ]
    assert wrong == []


@pytest.mark.parametrize(
    ("said", "says"),
    [
        ("PACK_STATUS (#901) is there", "PACK_STATUS has the id 900, not 901"),
        ("PACK_STATUS is 24 bytes", "PACK_STATUS has a payload of 9 bytes, not 24"),
    ],
)
def test_what_the_text_says_of_a_proposed_message_is_compared_with_its_xml(check: Any, said: str, says: str) -> None:
    before = {one.message for one in check(DRAFT)}
    assert {one.message for one in check(DRAFT.replace("PACK_STATUS is 9 bytes", said))} - before == {says}


RIGHT = [
    # the dialect's own words, in its own types
    '<message id="147" name="BATTERY_STATUS">\n<field type="uint8_t" name="id" instance="true">Id</field>\n</message>',
    '<field type="int32_t" name="time_remaining" units="s">Time, 0: no estimate</field>',
    '<field type="uint16_t[10]" name="voltages" units="mV" invalid="[UINT16_MAX]">Cells</field>',
    # of one of two messages with such a field
    '<field type="float" name="temperature" units="degC">Of the air</field>',
    '<field type="int16_t" name="temperature" units="cdegC" invalid="INT16_MAX">Of the pack</field>',
    # of no message that the document names
    '<field type="float" name="brightness" units="%" invalid="NaN">Light</field>',
    '<enum name="E"><entry value="3" name="E_THREE"/></enum>',
    '<enum name="E" bitmask="true"><entry value="0" name="E_NONE"/><entry value="2**31" name="E_TOP"/></enum>',
    # no XML, or none that is complete
    '<message id="147" name="BATTERY_STATUS">\n...',
    "<message> & <field>",
    '<!DOCTYPE x><message id="1" name="A"/>',
]


@pytest.mark.parametrize("xml", RIGHT, ids=[xml[:40] for xml in RIGHT])
def test_xml_that_agrees_or_is_none_is_left_alone(check: Any, xml: str) -> None:
    assert check(f"BATTERY_STATUS and HIGHRES_IMU have these:\n\n```xml\n{xml}\n```\n") == []


def test_a_message_of_the_dialect_that_is_quoted_differently(check: Any) -> None:
    xml = """\
```xml
<message id="148" name="BATTERY_STATUS">
  <field type="int16_t" name="temperature" units="degC" invalid="UINT16_MAX">T</field>
  <field type="uint8_t" name="type" enum="MAV_TYPE">T</field>
  <field type="int16_t" name="current_battery" units="cA" invalid="0">I</field>
</message>
```
"""
    findings = [(one.place.line, one.message) for one in check(xml) if one.rule.id == "claim-field"]
    assert findings == [
        (
            3,
            "BATTERY_STATUS.temperature is in cdegC, not degC and cannot be UINT16_MAX, "
            "and is unknown when it is INT16_MAX",
        ),
        (4, "BATTERY_STATUS.type is of the enum MAV_BATTERY_TYPE, not MAV_TYPE"),
        (5, "BATTERY_STATUS.current_battery is unknown when it is -1, not 0"),
    ]


@pytest.mark.parametrize(
    ("text", "is_found"),
    [
        ("BATTERY_STATUS will not be truncated.", True),  # it ends with extensions
        ("The BATTERY_STATUS message cannot be zero-byte truncated.", True),
        ("ATTITUDE of MAVLink is never truncated", False),  # ends with a float, which need not be 0
        ("Two arrays of BATTERY_STATUS, which cannot be truncated.", False),
        ("The message will not be truncated. It is not BATTERY_STATUS.", False),  # nobody knows which
    ],
)
def test_that_a_message_is_never_cut(check: Any, text: str, is_found: bool) -> None:
    assert [one.rule.id for one in check(text)] == ["claim-truncation"] * is_found


@pytest.mark.parametrize(
    "text",
    [
        "BATTERY_STATUS: `current_battery` is limited to 327.67 A.",
        "BATTERY_STATUS: `current_consumed` has a limit of 5000 mAh here.",
        "SYS_STATUS cannot carry more than 65 V.",  # one uint16_t in mV
        "BATTERY_STATUS allows for more than 60 V.",
        "BATTERY_STATUS is sent at a maximum of 50 Hz; readings over 65 ms are impossible.",
    ],
)
def test_limits_that_hold_are_left_alone(check: Any, text: str) -> None:
    assert check(text) == []
