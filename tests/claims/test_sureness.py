"""A finding says how sure it is: only what is certain is an error."""

import re
from pathlib import Path

import pytest

from codegen import claims
from codegen.claims import LIKELY
from codegen.claims import rules as claims_rules
from codegen.cli import main
from codegen.diagnostics import Rule, Severity
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
