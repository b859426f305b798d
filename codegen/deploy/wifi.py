"""The file with the name and the password of a Wi-Fi, which lies on the board and in no repository."""

import json

from codegen.deploy.findings import BAD_WIFI
from codegen.diagnostics import Report
from codegen.model.system import System
from codegen.source import Place


def wifi_file(path: str, text: str, system: System, report: Report) -> tuple[str, bytes] | None:
    """The name that the program has for it, and its content; None after a finding."""
    names = [link.spec.credentials for link in system.links if link.spec.credentials]
    if not names:
        report.add(
            BAD_WIFI, Place(path), "no link of this program reads a Wi-Fi's file", "links over Wi-Fi have credentials"
        )
        return None
    try:
        written = json.loads(text)
    except ValueError as fault:
        report.add(BAD_WIFI, Place(path), f"it is not JSON: {fault}")
        return None
    lacking = [
        key for key in ("ssid", "password") if not isinstance(written, dict) or not isinstance(written.get(key), str)
    ]
    if lacking:
        report.add(BAD_WIFI, Place(path), f"it has no text for {' and '.join(lacking)}")
        return None
    return names[0], text.encode()
