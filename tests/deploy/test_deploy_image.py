"""codegen deploy --image: a real MicroPython mounts the image and runs the program from it."""

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from whole_program import module_folders

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[2]
STARTED = """
import os
import sys
import vfs
import mock_time
mock_time.install()
import mock_asyncio
mock_asyncio.install()
with open(sys.argv[1], "rb") as file:
    vfs.mount(vfs.VfsRom(memoryview(file.read())), "/rom")
sys.path.append("/rom")
print(sorted(os.listdir("/rom")))
from rover import Rover
rover = Rover()
rover.run_pass()
print(Rover.PUMP, rover.is_armed)
"""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """The rover with code of its own that has a package, and without machine code."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    table = tmp_path / "specs" / "codegen.yaml"
    table.write_text(table.read_text() + "machine_code: false\n")
    text = "from pumps.first import PUMP as FIRST\nfrom vehicle import Vehicle\n\n\nclass Rover(Vehicle):\n"
    (tmp_path / "rover.py").write_text(f"{text}    PUMP = FIRST\n")
    (tmp_path / "pumps").mkdir()
    (tmp_path / "pumps" / "__init__.py").write_text("")
    (tmp_path / "pumps" / "first.py").write_text("PUMP = 'a pump'\n")
    assert main(["build", "--project", str(tmp_path)]) == 0
    return tmp_path


def test_the_program_runs_from_its_image(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """All of it but main.py, which a board starts from its flash; packages keep their folders."""
    image, script = project / "program.romfs", project / "started.py"
    assert main(["deploy", "--project", str(project), "--image", str(image)]) == 0
    assert f"mpremote romfs deploy {image}" in capsys.readouterr().err
    script.write_text(STARTED)
    command = [str(Path(sys.executable).parent / "micropython"), str(script), str(image)]
    paths = {"MICROPYPATH": os.pathsep.join([".frozen", *map(str, module_folders(project / "generated", "mocks"))])}
    done = subprocess.run(command, env={**os.environ, **paths}, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    listed, said = done.stdout.splitlines()[0], done.stdout.splitlines()[-1]
    assert "'vehicle.mpy'" in listed
    assert "'pumps'" in listed
    assert "main" not in listed
    assert said.startswith("a pump False")


def test_an_image_that_cannot_be_made_says_why(
    project: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without mpremote, or where a folder has its name."""

    def told(*arguments: str) -> tuple[int, Any]:
        capsys.readouterr()
        code = main(["deploy", "--project", str(project), *arguments])
        return code, capsys.readouterr().out

    code, out = told("--image", str(project / "pumps"))
    assert code == 2
    assert "error file-unwritable: it cannot be written" in out
    monkeypatch.setitem(sys.modules, "mpremote.romfs", None)
    code, out = told("--image", str(project / "program.romfs"))
    assert code == 2
    assert "error mpremote-missing" in out
    assert not (project / "program.romfs").exists()
