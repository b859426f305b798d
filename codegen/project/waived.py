"""Findings that a project has waived: these stop no build, and nobody is told of them again, as in a check."""

import os
from collections.abc import Iterable, Iterator
from datetime import UTC, datetime

from codegen.decode.waivers import WAIVERS, decode_waivers
from codegen.diagnostics import Diagnostic, Report
from codegen.findings.waivers import LookedAt, apply_waivers
from codegen.load.files import Files


def with_waived(findings: Iterable[Diagnostic], folder: str, files: Files) -> Iterator[Diagnostic]:
    """Yield findings, of which those are marked that waivers.yaml in ``folder`` waives as of this day of UTC.

    The file is read where there is such a finding only. What is wrong with it, and which waivers are of no use any
    more, codegen check tells.
    """
    path = os.path.join(folder, WAIVERS)
    for finding in findings:
        if finding.fingerprint is not None and files.is_file(path):
            waivers = decode_waivers(path, files, Report())
            judged = apply_waivers([finding], waivers, datetime.now(UTC).date(), LookedAt((), ()), lambda _: True)
            yield judged[0]
        else:
            yield finding
