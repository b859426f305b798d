"""A finding says how sure it is: only what is certain is an error."""

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from codegen import claims
from codegen.claims import LIKELY
from codegen.claims import rules as claims_rules
from codegen.cli import main
from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.rules.checks import checks_in

PAGE = Path(__file__).parents[2] / "docs/claims.md"


def rules() -> dict[str, Rule]:
    """Every rule of the checker of claims, by its id."""
    modules = [__import__(check.__module__, fromlist=["check"]) for check in checks_in(claims.__name__)]
    modules.append(claims_rules)
    found = [value for module in modules for value in vars(module).values() if isinstance(value, Rule)]
    return {rule.id: rule for rule in found if rule.id.startswith("claim-")}


def test_a_rule_that_is_no_error_says_why_it_is_not_certain() -> None:
    assert len(rules()) >= 28
    for rule in rules().values():
        assert (LIKELY in rule.explanation) is (rule.severity is Severity.WARNING), rule.id


def test_the_page_lists_what_is_not_certain() -> None:
    section = PAGE.read_text().partition("## How sure a finding is")[2].partition("\n## ")[0]
    likely = {rule.id for rule in rules().values() if rule.severity is Severity.WARNING}
    assert set(re.findall(r"`(claim-[a-z-]+)`", section)) == likely


@pytest.mark.parametrize(
    ("text", "severity", "code"),
    [
        ("GPS_RAW_INT has a field `satelites_visible`.", "warning", 0),
        ("HEARTBEAT comes from a MAV_TYPE_ROVER.", "warning", 0),
        ("HEARTBEAT (#3) is sent.", "error", 1),
        ("BATTERY_STATUS is 41 bytes.", "error", 1),
    ],
)
def test_findings_say_it_and_the_exit_code_follows(
    text: str, severity: str, code: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "d.md").write_text(f"{text}\n")
    assert main(["check", str(tmp_path / "d.md"), "--dialect", "common"]) == code
    (line,) = [line for line in capsys.readouterr().out.splitlines() if "d.md:" in line]
    assert f" {severity} claim-" in line
    assert line.endswith(f"({LIKELY})") is (severity == "warning")


SURE = [
    "HEARTBEAT (id 3) is sent.",
    "BATTERY_STATUS has a payload of 41 bytes.",
    "| Message | ID |\n|---|---|\n| HEARTBEAT | 3 |\n| ATTITUDE | 30 |",
    "## ATTITUDE (30)\n\n| Field | Unit |\n|---|---|\n| roll | rad |\n| yaw | deg |",
    "## GLOBAL_POSITION_INT\n\n- `alt`: height of the antenna, in cm\n- `lat`: degE7",
    "GLOBAL_POSITION_INT.alt is in cm.",
    "`alt` of GLOBAL_POSITION_INT is a uint32_t.",
    "MAV_TYPE_QUADROTOR (3) is what HEARTBEAT says.",
    "`fix_type` of GPS_RAW_INT: 1 no fix, 2 2D fix, 4 3D fix",
    "```c\n#define MAVLINK_MSG_ID_HEARTBEAT 3\n```",
    "```c\nstruct mavlink_attitude_t {\n    uint32_t time_boot_ms;\n    float roll;\n    int16_t yaw;\n};\n```",
    "```yaml\n- name: HEARTBEAT\n  id: 3\n```",
]
LIKELY_ONLY = [
    "We fetch GPS_RAW_INT, whose `alt` the pilot reads in cm.",
    "ATTITUDE is read.\n\n```c\nstruct pose {\n    float roll;\n    int16_t yaw;\n};\n```",
]
SILENT = [
    "ATTITUDE is read.\n\n```c\nstruct pose {\n    float roll;\n    int16_t yaw;\n    char label[8];\n};\n```",
    "ATTITUDE is read.\n\n## Raw frame (not MAVLink)\n\n| Field | Type |\n|---|---|\n| roll | int16_t |",
    'The sheet says "GLOBAL_POSITION_INT.alt is in cm".',
    "> GLOBAL_POSITION_INT.alt is in cm.",
    "HEARTBEAT is sent by all.\n\nPUMP_STATE (id 42150) is our own.",
    "```yaml\n- name: HEARTBEAT\n  id: 0\n- name: PUMP\n  id: 9\n```",
    "| Field | Means |\n|---|---|\n| VFR_HUD.climb | 500 ft/min |",
    "HIGH_LATENCY2 has 42 bytes of payload, 54 bytes as an unsigned MAVLink 2 frame.",
    "ATTITUDE is read.\n\n```rust\nstruct View {\n    roll: f64,\n    title: String,\n    width: u32,\n    height: u32,\n}\n```",
    "```ts\n// ATTITUDE\nconst a = {\n  roll: s.roll,  // deg\n};\n```",
]


@pytest.mark.parametrize("text", SURE)
def test_what_the_structure_ties_to_a_name_is_certain(text: str, check: Callable[[str], list[Diagnostic]]) -> None:
    assert [finding.is_error for finding in check(f"MAVLink.\n\n{text}\n")] == [True]


@pytest.mark.parametrize("text", LIKELY_ONLY)
def test_what_the_words_only_suggest_is_likely(text: str, check: Callable[[str], list[Diagnostic]]) -> None:
    found = check(f"MAVLink.\n\n{text}\n")
    assert found
    assert not any(finding.is_error for finding in found)


@pytest.mark.parametrize("text", SILENT)
def test_what_is_cited_or_of_another_name_is_not_said(text: str, check: Callable[[str], list[Diagnostic]]) -> None:
    assert check(f"MAVLink.\n\n{text}\n") == []


ALTITUDE = "`alt` of GPS_RAW_INT is in cm"


@pytest.mark.parametrize(
    ("text", "is_certain"),
    [
        (f"{ALTITUDE}.", True),
        (f"Nobody says so, but {ALTITUDE}.", True),
        (f"Our {ALTITUDE}.", False),
        (f"There {ALTITUDE}.", False),
        (f"Unlike others, {ALTITUDE}.", False),
        (f"{ALTITUDE} in a future version.", False),
        (f"Not {ALTITUDE}.", False),
        (f"It is not so that {ALTITUDE}.", False),
        (f"It is not so. {ALTITUDE}.", True),
        (f"According to you, {ALTITUDE}.", False),
        ("HEARTBEAT has the id 5.", True),
        ("HEARTBEAT has the id 5 here.", True),  # a message has one id everywhere
        ("HEARTBEAT should have the id 5.", False),
        ("HEARTBEAT will have the id 5.", False),
        ("`eph` of GPS_RAW_INT is 0 if unknown.", True),
        ("`eph` of GPS_RAW_INT starts with 0, unknown.", False),
        ("In MAV_STATE, MAV_STATE_ACTIVE is 5.", True),
    ],
)
def test_words_that_leave_a_statement_open(
    text: str, is_certain: bool, check: Callable[[str], list[Diagnostic]]
) -> None:
    """Somebody's own things, what is compared, denied, planned or doubted in the same sentence: it may be right."""
    assert [each.is_error for each in check(f"MAVLink.\n\n{text}\n")] == [is_certain]
