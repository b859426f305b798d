"""docs/your-own-vehicle.md: from an empty folder, word by word, to the output that it shows."""

import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def test_the_page_leads_to_what_it_shows(tmp_path: Path) -> None:
    """Its commands succeed without a finding; its texts go where it says; the simulation prints what it prints."""
    blocks = BLOCK.findall((ROOT / "docs" / "your-own-vehicle.md").read_text())
    kinds = [kind for kind, _ in blocks]
    assert kinds == ["console", "yaml", "yaml", "markdown", "python", "console", "text", "yaml", "console", "text"]
    (begin, quantity, table, criterion, code, again, shown, scenario, slower, told) = [text for _, text in blocks]
    environment = {**os.environ, "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"}

    def run(commands: str, folder: Path) -> str:
        bash = ["bash", "-ec", commands.replace("--quiet", "--quiet --out udp:127.0.0.1:9")]
        done = subprocess.run(bash, cwd=folder, env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    assert "HEARTBEAT" in run(begin, tmp_path)
    project = tmp_path / "harbour"
    with (project / "specs/state.yaml").open("a") as file:
        file.write(quantity)
    with (project / "specs/requirements/FR-1-presence.md").open("a") as file:
        file.write(criterion)
    (project / "specs/messages/raw_rpm.yaml").write_text(table)
    (project / "app.py").write_text(code)
    assert run(again, project) == shown
    with (project / "specs/scenarios.yaml").open("a") as file:
        file.write(scenario)
    assert run(slower, project) == told
