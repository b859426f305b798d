"""Each kind of claim: what is wrong is found where it stands and with the right value, and what is right is not.

The documents are ours; their contradictions are those of real requirement documents. Numbers of the dialect are
computed here from pymavlink's own generated classes.
"""

from typing import Any

import pytest
from pymavlink.dialects.v20 import common

STATUS = common.MAVLink_battery_status_message
PAYLOAD = STATUS.unpacker.size
BASE = PAYLOAD - sum((4, 1, 8, 1, 4))  # the extensions: time_remaining, charge_state, voltages_ext, mode, fault_bitmask


def found(findings: Any) -> list[tuple[str, int, int]]:
    """Rule, line and column."""
    return [(one.rule.id, one.place.line, one.place.column) for one in findings]


WRONG = [
    # sizes
    ("BATTERY_STATUS is 41 bytes.", "claim-message-size", 19, f"a payload of {BASE} bytes, {PAYLOAD} with extensions"),
    ("The whole `BATTERY_STATUS` message (41 bytes) fits.", "claim-message-size", 37, "not 41"),
    ("A 41-byte BATTERY_STATUS message.", "claim-message-size", 3, "not 41"),
    ("BATTERY_STATUS (#147) has a payload of 48 bytes.", "claim-message-size", 40, "not 48"),
    ("BATTERY_STATUS frame, v1: 48 bytes", "claim-message-size", 27, "44 in MAVLink 1"),
    ("BATTERY_STATUS is **41** bytes at 2 Hz = 82 bytes/s", "claim-message-size", 21, "at 2 Hz are 96 bytes/s"),
    # bytes per second
    ("BATTERY_STATUS at 2 Hz takes 500 bytes/s.", "claim-bytes-per-second", 30, "not 500"),
    ("BATTERY_STATUS: 48 bytes at 2 Hz make 86 bytes per second.", "claim-bytes-per-second", 39, "are 96 bytes/s"),
    ("| HEARTBEAT of MAVLink at 1 Hz | 5 B/s |\n| --- | --- |", "claim-bytes-per-second", 34, "21 bytes/s"),
    # numbers beside names
    ("MAVLink BATTERY_STATUS (#148) messages", "claim-message-id", 26, f"the id {STATUS.id}, not 148"),
    ("The message BATTERY_STATUS (ID #148)", "claim-message-id", 33, "not 148"),
    ("the message SYS_STATUS (2) of MAVLink", "claim-message-id", 25, "the id 1, not 2"),
    ("BATTERY_STATUS, id 148,", "claim-message-id", 20, "not 148"),
    ("The CRC_EXTRA of BATTERY_STATUS is 155.", "claim-crc-extra", 36, f"{STATUS.crc_extra}, not 155"),
    ("BATTERY_STATUS has CRC_EXTRA 015.", "claim-crc-extra", 30, "not 15"),
    ("BATTERY_STATUS has CRC_EXTRA 0x9B", "claim-crc-extra", 30, "not 155"),
    ("`MAV_BATTERY_TYPE_LIPO` (2)", "claim-enum-value", 26, f"{common.MAV_BATTERY_TYPE_LIPO}, not 2"),
    ("It is 2 (MAV_BATTERY_TYPE_LIPO).", "claim-enum-value", 7, "not 2"),
    # types and units of a field in a sentence
    ("BATTERY_STATUS: `current_battery` is an int32.", "claim-struct", 41, "current_battery is int16_t, not int32_t"),
    ("BATTERY_STATUS: `temperature` is an int16 in degC.", "claim-unit", 46, "temperature is in cdegC, not degC"),
    ("In BATTERY_STATUS, `temperature` went to an `int16_t` (degC).", "claim-unit", 56, "in cdegC, not degC"),
    # worked examples
    ("So (3000 / 4095 * 3.3) * 3.95 = 9.52 V.", "claim-arithmetic", 4, "is 9.5495 V, not 9.52"),
    ("3 x 4 = 13 cells", "claim-arithmetic", 1, "is 12 cells, not 13"),
    ("2 \\* 3.3 V = 8 V", "claim-arithmetic", 1, "is 6.6 V, not 8"),
    ("2 + 2 + 126 × 2 = 260 bytes", "claim-arithmetic", 1, "is 256 bytes"),  # noqa: RUF001
    ("2^8 - 1 = 256", "claim-arithmetic", 1, "is 255"),
    ("3.3 V / 4095 = 1.9 mV", "claim-arithmetic", 1, "is 0.80586 mV, not 1.9"),
    ("100 / 3 ≈ 40", "claim-arithmetic", 1, "is 33.333"),
    ("1,000 * 2.5 = 2,400", "claim-arithmetic", 1, "is 2500"),
]


@pytest.mark.parametrize(("text", "rule", "column", "says"), WRONG, ids=[case[0][:40] for case in WRONG])
def test_a_wrong_claim_is_found(check: Any, text: str, rule: str, column: int, says: str) -> None:
    findings = check(f"# Title\n\n{text}\n")
    assert found(findings) == [(rule, 3, column)]
    (finding,) = findings
    assert says in f"{finding.message}; {finding.hint}"
    assert finding.fingerprint


RIGHT = [
    "BATTERY_STATUS is 36 bytes, and BATTERY_STATUS with extensions is 54 bytes.",
    "A BATTERY_STATUS frame of 48 bytes; BATTERY_STATUS frames (53 bytes) that lost zeros.",
    "A signed 61-byte BATTERY_STATUS frame.",
    "BATTERY_STATUS in MAVLink 1 is 44 bytes. BATTERY_STATUS, frame (v1): 44 bytes",
    "41 bytes of RAM hold BATTERY_STATUS. BATTERY_STATUS needs a buffer of 300 bytes, then 41 bytes more.",
    "BATTERY_STATUS at 2 Hz takes 96 bytes/s, with SYS_STATUS at 1 Hz 139 bytes/s. At 2 Hz that is 7 bytes/s.",
    "BATTERY_STATUS: 48 bytes at 2 Hz are 96 bytes/s; BATTERY_STATUS (36 bytes) at 2 Hz is 96 bytes/s.",
    "BATTERY_STATUS (#147), BATTERY_STATUS (ID #147), BATTERY_STATUS (147), BATTERY_STATUS id 147, SYS_STATUS (#1).",
    "- Add BATTERY_STATUS (#1068)\n- [BATTERY_STATUS #233](https://example.org/x/pull/233) is merged",
    "[16 cells #17](https://example.org/pull/17), https://example.org/BATTERY_STATUS(#3)",
    "The CRC_EXTRA of BATTERY_STATUS is 154, that of MAVLink's HEARTBEAT is 50. CRC_EXTRA 7 of nobody.",
    "MAV_BATTERY_TYPE_LIPO (1), 1 (MAV_BATTERY_TYPE_LIPO), MAV_BATTERY_TYPE_LIPO = 0x01; see 5 (MAV_BATTERY_TYPE_LIPO)",
    "(3000 / 4095 * 3.3) * 3.95 = 9.55 V; 3000 / 4095 * 3.3 * 3.95 = 9.54 V; 100 / 3 ≈ 33; 2**31 = 2147483648",
    "0-255 = 256 values; 2022-03-26 = 5; a-1 = 5; v1.2 - 3 = 4; f(3) * 2 = 9; 255 + 1 = 0; 5 ^ 3 = 6; 7 / 2 = 3",
    "1 + 1 == 3, 1 + 1 != 3, 3 * 4 = 6 * 2, 50 % * 2 = 1, 10/0 = 5, x2 + 3 = 8, 3 * 4 = 1.2e1",
    "10 mA * 5 = 50 mA, 3.3 V / 4095 = 0.8 mV",
    "400 / 3 = about 134, 3e+2 / 3 = 100, 12 V * 2 A = 24 W, 1000 * 1000 = 1 million, 65 - 5 = 60 %",
    "BATTERY_STATUS: `current_battery` is an int16_t in cA, and `current_consumed` an int32 (mAh).",
    "BATTERY_STATUS has an `id`.\n\nOur own id is a uint64, and its charge a float in mAh.",
    "BATTERY_STATUS: `current_consumed` changed from an `int32_t` (mAh) to a `float` in A; brightness is a float in V.",
    "SYS_STATUS and BATTERY_STATUS: `load` is a uint16 in d%.",
    "Of MAVLink's messages PING (7) and DEBUG (3) were lost.",
    "BATTERY_STATUS:\n\n| Column | Type |\n| --- | --- |\n| id | uint16_t |\n| owner | char[9] |\n| since | double |",
    "DEBUG (3) and PING (#7) of another program, 5 bytes of DEBUG, DEBUG is 5 bytes.",
]


@pytest.mark.parametrize("text", RIGHT, ids=[text[:40] for text in RIGHT])
def test_a_right_claim_is_left_alone(check: Any, text: str) -> None:
    assert [(one.place.column, one.message) for one in check(text)] == []


def test_a_claim_in_the_comment_of_code_and_the_assertion_of_it(check: Any) -> None:
    text = """\
```rust
// so (3000 / 4095.0 * 3.3) * 3.95 = 9.52V
let volts = convert(3000, 3.95);
assert!((volts - 9.52).abs() < 0.01);
let x = 3 * 4 = 13;
```
"""
    (finding,) = check(text)
    assert found([finding]) == [("claim-arithmetic", 2, 7)]
    assert finding.message.endswith("is 9.5495 V, not 9.52: 0.029451 away, and the assertion allows 0.01")
    assert [(place.line, place.column) for place, _ in finding.related] == [(4, 18)]


CAST = """\
BATTERY_STATUS and SYS_STATUS are sent.

| Field | Source |
| --- | --- |
| id | 0 |
| voltages\\[0] | (pack.volts \\* 1000) as u16 |
| temperature | INT16_MAX |

As in SYS_STATUS:

```rust
let voltage_battery = (pack.volts * 1000.0) as u16;
let current_battery = (pack.amps * 100.0) as i16;
let millivolts = (pack.volts * 1000.0) as u16;
voltages[0] = millivolts;
let load = (cpu * 1000.0) as u16;
let voltage_battery = (pack.volts.min(65.534) * 1000.0) as u16;
```
"""


def test_a_cast_that_ends_at_the_sentinel_is_found_once_for_each_sentinel(check: Any) -> None:
    first, second = check(CAST)
    assert found([first, second]) == [("claim-cast-to-sentinel", 6, 18), ("claim-cast-to-sentinel", 13, 23)]
    assert "saturates at 65535, which means unknown in BATTERY_STATUS.voltages" in first.message
    assert [place.line for place, _ in first.related] == [12, 14]
    assert "can be -1, which means unknown in SYS_STATUS.current_battery" in second.message


C_CAST = """\
BATTERY_STATUS:

```c
uint16_t millivolts = (uint16_t)(volts * 1000.0f);
packet.voltages[0] = millivolts;
packet.current_battery = (int16_t) (amps * 100);
packet.battery_remaining = (int8_t)(fmax(0, part) * 100);
```
"""


def test_casts_of_c_are_found_too(check: Any) -> None:
    findings = check(C_CAST)
    assert found(findings) == [("claim-cast-to-sentinel", 4, 23), ("claim-cast-to-sentinel", 6, 26)]
    assert "can be 65535, which means unknown in BATTERY_STATUS.voltages" in findings[0].message
    assert "can be -1, which means unknown in BATTERY_STATUS.current_battery" in findings[1].message


TABLE = """\
What is sent in BATTERY_STATUS:

| Field | Type | Units | If unknown |
| --- | --- | --- | --- |
| `temperature` | uint16_t | degC | UINT16_MAX |
| voltages\\[0..10] | uint16_t[10] | mV | UINT16_MAX |
| current_battery | int16 | cA | -1 |
| energy_consumed | int32_t | hJ | 0 |
| id | uint8_t | | |
"""
LIST = """\
BATTERY_STATUS:

- `temperature`: INT16_MAX (unknown), not UINT16_MAX
- `voltages[1..9]`: UINT16_MAX (unknown)
- `current_battery`: 0 if unknown
- `current_consumed`: UINT32_MAX, in Ah
- `battery_remaining`: -1 or an estimate
"""
STRUCT = """\
```c
// MAVLink message #147
uint8_t id;
uint8_t battery_function; // 0=unknown
uint8_t type;
int16_t temperature; // in degC, INT16_MAX if unknown
uint16_t voltages[4]; // in mV
int32_t charge;
int16_t current_battery; // NaN if unknown
int32_t current_consumed; // in mAh, -1 if unknown
int32_t energy_consumed;
```
"""


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            TABLE,
            [
                ("claim-struct", 5, 19, "temperature is int16_t, not uint16_t"),
                ("claim-unit", 5, 30, "temperature is in cdegC, not degC"),
                ("claim-sentinel", 5, 37, "temperature is unknown when it is INT16_MAX, not UINT16_MAX"),
                ("claim-struct", 6, 1, "voltages has 10 elements, 0 to 9: there is no 10"),
                ("claim-sentinel", 8, 36, "energy_consumed is unknown when it is -1, not 0"),
            ],
        ),
        (
            LIST,
            [
                ("claim-sentinel", 5, 22, "current_battery is unknown when it is -1, not 0"),
                ("claim-sentinel", 6, 23, "current_consumed is unknown when it is -1, not UINT32_MAX"),
                ("claim-unit", 6, 38, "current_consumed is in mAh, not Ah"),
            ],
        ),
        (
            STRUCT + "\nThat is BATTERY_STATUS.\n",
            [
                ("claim-struct", 3, 1, "the struct of BATTERY_STATUS lacks battery_remaining"),
                ("claim-unit", 6, 28, "temperature is in cdegC, not degC"),
                ("claim-struct", 7, 1, "voltages is uint16_t[10], not uint16_t[4]"),
                ("claim-struct", 8, 1, "BATTERY_STATUS has no field charge"),
                ("claim-sentinel", 9, 29, "current_battery is unknown when it is -1, not NaN"),
            ],
        ),
        (
            STRUCT.replace("#147", "#148") + "\nThat is BATTERY_STATUS.\n",
            [
                ("claim-message-id", 2, 1, "BATTERY_STATUS has the id 147, not 148"),
                ("claim-unit", 6, 28, "degC"),
                ("claim-struct", 7, 1, "uint16_t[4]"),
                ("claim-sentinel", 9, 29, "NaN"),
            ],
        ),
        (
            "BATTERY_STATUS in Rust:\n\n```rust\npub struct B {\n    pub voltages: [u16; 10],\n"
            "    pub temperature: u16,\n    pub type_: u8,\n    pub current_battery: i16, // -1 if unknown\n}\n```\n",
            [("claim-struct", 6, 22, "temperature is int16_t, not uint16_t")],
        ),
    ],
    ids=["table", "list", "struct", "struct-of-another-id", "rust"],
)  # fmt: skip
def test_what_is_said_of_fields(check: Any, text: str, expected: list[tuple[str, int, int, str]]) -> None:
    findings = check(text)
    assert found(findings) == [one[:3] for one in expected]
    for finding, (_, _, _, says) in zip(findings, expected, strict=True):
        assert says in finding.message


def test_a_struct_may_have_the_order_of_the_wire_or_of_the_xml(check: Any) -> None:
    """Both are in use; any other is not that of the message."""
    types = dict(zip(STATUS.fieldnames, STATUS.fieldtypes, strict=True))
    lengths = dict(zip(STATUS.ordered_fieldnames, STATUS.array_lengths, strict=True))

    def struct(names: list[str]) -> str:
        """Declarations of the fields, with the types of pymavlink."""
        lines = [f"{types[name]} {name}{f'[{lengths[name]}]' if lengths[name] else ''};" for name in names]
        return "```c\n// BATTERY_STATUS, message #147\n" + "\n".join(lines) + "\n```\nBATTERY_STATUS\n"

    wire, xml = list(STATUS.ordered_fieldnames), list(STATUS.fieldnames)
    assert check(struct(wire)) == check(struct(xml)) == check(struct(wire[:-5])) == []
    (finding,) = check(struct([*wire[1:-5], wire[0]]))
    assert (finding.rule.id, "come in another order" in finding.message) == ("claim-struct", True)


def test_a_claim_that_is_repeated_is_one_finding(check: Any) -> None:
    text = "BATTERY_STATUS is 41 bytes.\n\nBATTERY_STATUS\nis **41 bytes**.\n\nBATTERY_STATUS has 41 bytes.\n"
    findings = check(text)
    assert found(findings) == [("claim-message-size", 1, 19), ("claim-message-size", 6, 20)]
    assert [(place.line, place.column) for place, _ in findings[0].related] == [(4, 6)]
