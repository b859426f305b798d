"""Names that stand for several things, letters that are no units, and what a heading or a type below makes of them."""

from collections.abc import Callable

import pytest

from codegen.diagnostics import Diagnostic

Check = Callable[[str], list[Diagnostic]]

RIGHT = {
    "two fields in one name, base fields and extensions":
        "`OPTICAL_FLOW` (100): `flow_comp_m_x/y` are base fields, `flow_rate_x/y` extensions.\n",
    "two fields in one name, each pair with its unit":
        "- OPTICAL_FLOW: `flow_comp_m_x/y` in m/s, `flow_rate_x/y` in rad/s\n",
    "base fields before a comma, extensions behind it":
        "OPTICAL_FLOW: `flow_comp_m_x` and `flow_comp_m_y` are base fields, `flow_rate_x` and `flow_rate_y` extensions.\n",
    "a temperature of a formula":
        "- `SCALED_PRESSURE.temperature` = T * 100\n",
    "a time":
        "- `SCALED_PRESSURE.time_boot_ms`: T, since boot\n",
    "a unit that it does not have":
        "# HIGHRES_IMU\n\n- `xacc` has not the mG of SCALED_IMU, but m/s/s\n- Unlike the mG of SCALED_IMU it has m/s/s in `xacc`.\n",
    "a command that the dialect does not have":
        "We use MAV_CMD_DO_CHANGE_SPEED.\n\n## SPRAY_FIELD (31010)\n\n- param2: speed in cm/s\n- param2: the speed in cm/s\n",
    "a unit that is called as another parameter":
        "| command | parameters |\n|---|---|\n"
        "| MAV_CMD_NAV_DELAY | param1: seconds; param2: hour; param3: minute; param4: second |\n",
    "a comment above another type":
        "```ts\nexport interface GpsRawInt {\n  lat: number; // degE7\n}\n\n"
        "/** lat: number in deg, lon: number in deg, alt: number in m */\n"
        "export class Position {\n}\n```\n",
    "a point of the compass":
        '```ts\nexport class WindCov {\n  /** string */\n  wind_x = "N";\n}\n```\n',
}  # fmt: skip
WRONG = {
    "two fields in one name":
        ("`OPTICAL_FLOW` (100): `flow_rate_x/y` are base fields.\n", ["claim-extension", "claim-extension"]),
    "base fields in commas":
        ("# OPTICAL_FLOW\n\nBase fields, `flow_rate_x` and `flow_rate_y`, are last.\n", ["claim-extension"] * 2),
    "tesla":
        ("- `HIGHRES_IMU.xmag`: in T\n", ["claim-unit"]),
    "a unit that it has":
        ("# HIGHRES_IMU\n\n- `xacc` is in mG, as the others.\n", ["claim-unit"]),
    "a command without its prefix":
        ("## NAV_LOITER_TO_ALT (31)\n\n- param2: radius in cm\n", ["claim-command-parameter"]),
    "a unit that is not the parameter's":
        ("MAV_CMD_NAV_DELAY\n\n- param1: delay in ms\n", ["claim-command-parameter"]),
    "a comment above the type of the message":
        ("```ts\n/** lat: number in deg, lon: number in degE7 */\nexport interface GpsRawInt {\n  lat: number;\n}\n```\n",
         ["claim-unit"]),
}  # fmt: skip


@pytest.mark.parametrize("name", RIGHT)
def test_a_name_or_a_letter_is_what_a_reader_takes_it_for(name: str, check: Check) -> None:
    """Each of these was found wrong, or said of another field, command or message than it is about."""
    assert [str(each) for each in check(RIGHT[name])] == []


@pytest.mark.parametrize("name", WRONG)
def test_what_they_are_wrong_about_is_found(name: str, check: Check) -> None:
    """The same words are read where they are a claim."""
    text, rules = WRONG[name]
    assert [each.rule.id for each in check(text)] == rules
