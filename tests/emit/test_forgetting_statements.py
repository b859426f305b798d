"""Where readings that are too old are forgotten: in plain Python in a function that messages share, else in each."""

import re
from pathlib import Path

from codegen.diagnostics import Report
from codegen.project.systems import read_system
from codegen.targets.firmware import render_firmware

SPECS = Path(__file__).resolve().parents[1] / "projects" / "power_monitor" / "specs" / "codegen.yaml"


def test_messages_share_functions_in_plain_python_only() -> None:
    """A call costs more in machine code than the statements."""
    system = read_system(str(SPECS), Report())
    assert system is not None
    files = render_firmware(system)
    plain, machine = (files[f"firmware/telemetry_{kind}.py"] for kind in ("plain", "viper"))
    functions = re.findall(r"(?m)^def (_expire_\w+)\(value, words\):$", plain)
    assert functions == ["_expire_pack", "_expire_pack_current", "_expire_tank"]
    assert all(plain.count(f"    {name}(value, words)\n") >= 1 for name in functions)
    assert "_expire_" not in machine
    assert all(re.search(rf"_{name.removeprefix('_expire_').upper()}\w*EXPIRES", machine) for name in functions[:1])
