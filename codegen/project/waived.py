"""Findings that a project has waived: these stop no build, and nobody is told of them again, as in a check."""

import os
from collections.abc import Iterable
from datetime import UTC, datetime

from codegen.decode.waivers import WAIVERS, decode_waivers
from codegen.diagnostics import Diagnostic, Report
from codegen.findings.waivers import LookedAt, apply_waivers
from codegen.load.files import Files


def with_waived(findings: Iterable[Diagnostic], folder: str, files: Files) -> list[Diagnostic]:
    """Return findings, of which those are marked that waivers.yaml in ``folder`` waives as of this day of UTC.

    The file is read where one of them can be waived only. What is wrong with it, and which waivers are of no use any
    more, codegen check tells.
    """
    found, path = list(findings), os.path.join(folder, WAIVERS)
    if all(finding.fingerprint is None for finding in found) or not files.is_file(path):
        return found
    waivers = decode_waivers(path, files, Report())
    judged = apply_waivers(found, waivers, datetime.now(UTC).date(), LookedAt((), ()), lambda _: True)
    return judged[: len(found)]  # what is wrong with the waivers stands behind them
