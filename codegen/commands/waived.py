"""Applies the waivers of a project to the findings of a command, as of the day of UTC on which it runs."""

import os
from collections.abc import Callable, Collection
from datetime import UTC, datetime

from codegen.decode.waivers import WAIVERS, decode_waivers
from codegen.diagnostics import Report
from codegen.findings.waivers import LookedAt, apply_waivers
from codegen.load.files import Files


def waivers_of(project: str) -> str | None:
    """The path of the waivers beside a project file; None where it has none."""
    path = os.path.join(os.path.dirname(os.path.abspath(project)), WAIVERS)
    return path if os.path.lexists(path) else None


def with_waivers(
    report: Report,
    waivers: str | None,
    rules: Collection[str],
    checked: Collection[str],
    files: Files,
    is_rule: Callable[[str], bool] | None = None,
) -> Report:
    """The findings with those marked that the file ``waivers`` waives today, and what is wrong with the waivers.

    ``rules`` are the ids of the rules that were looked at, ``checked`` the absolute paths of what was. ``is_rule`` says
    whether there is another rule: by default the catalogue does, which an earlier run may have asked already.
    """
    if waivers is None:
        return report
    decoded = decode_waivers(waivers, files, report)
    judged = Report()
    looked_at = LookedAt(rules, checked)
    judged.extend(apply_waivers(report, decoded, datetime.now(UTC).date(), looked_at, is_rule or _is_known))
    return judged


def _is_known(rule: str) -> bool:
    from codegen.findings.catalogue import rule_ids

    return rule in rule_ids()
