"""codegen codec --package: the codec inside of a package, for libraries: imports, stubs and the list for mip."""

import ast
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from codegen.targets.codec.package import OWN, STUBS

BIN = Path(sys.executable).parent
EXAMPLE = """
from inner.mymav import messages
from inner.mymav.enums import MAV_STATE_ACTIVE
from inner.mymav.mavlink import Link


class Wire:
    def __init__(self) -> None:
        self.data = b""

    def write(self, data: memoryview) -> int:
        self.data += bytes(data)
        return len(data)


wire = Wire()
link = Link(wire, messages=messages.ALL)
link.send(messages.BatteryStatus().update(id=1, voltages=[12600] + [None] * 9))
link.send(messages.Heartbeat().update(system_status=MAV_STATE_ACTIVE))
for message in link.feed(wire.data):
    if isinstance(message, messages.BatteryStatus):
        print(message.id, message.current_battery, message.voltages)
"""
MESSAGES = "HEARTBEAT,BATTERY_STATUS,STATUSTEXT"


def codec(run: Any, folder: Path, *options: str) -> Path:
    """The folder with the package."""
    arguments = ["--dialect", "common", "--messages", MESSAGES, "--out", str(folder), "--package", "inner.mymav"]
    code, out, err = run("codec", *arguments, *options)
    assert (code, out) == (0, ""), err
    return folder


@pytest.fixture
def lib(run: Any, tmp_path: Path) -> Path:
    return codec(run, tmp_path / "lib")


@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_package_is_imported_from_where_it_is(lib: Path, tmp_path: Path, interpreter: str) -> None:
    """Modules of the user with the names of the codec's are in nobody's way."""
    for name in (
        "messages",
        "message",
        "receiver",
        "frames",
        "fields",
        "live_fields",
        "nearest",
        "checksum",
        "signing",
    ):
        (tmp_path / f"{name}.py").write_text("raise ImportError('not this one')\n")
    (tmp_path / "example.py").write_text(EXAMPLE)
    environment = {**os.environ, "PYTHONPATH": str(lib), "MICROPYPATH": f".:{lib}"}
    command = [str(BIN / interpreter), "example.py"]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"1 None {(12600, *[None] * 9)}\n"


def test_stubs_satisfy_mypy_and_find_mistakes(lib: Path, tmp_path: Path) -> None:
    """Fields have their types; there are no others."""
    wrong = EXAMPLE.replace("id=1,", "id='a', volts=1,").replace("message.id,", "message.voltage,")
    (tmp_path / "right.py").write_text(EXAMPLE)
    (tmp_path / "wrong.py").write_text(wrong)
    environment = {**os.environ, "MYPYPATH": str(lib)}
    command = [sys.executable, "-m", "mypy", "--strict", "--no-error-summary", "right.py", "wrong.py"]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    found = [line.split(": error: ")[1] for line in done.stdout.splitlines() if ": error: " in line]
    assert not [line for line in done.stdout.splitlines() if line.startswith(("right.py", str(lib), "lib"))], (
        done.stdout
    )
    assert len(found) == 3
    assert any("volts" in line for line in found)
    assert any('"BatteryStatus" has no attribute "voltage"' in line for line in found)
    assert any('incompatible type "str"; expected "int | None"' in line for line in found)


@pytest.mark.parametrize(("options", "ending"), [([], ".py"), (["--mpy", "armv6m"], ".mpy")])
def test_mip_copies_each_module(run: Any, tmp_path: Path, options: list[str], ending: str) -> None:
    """Paths are relative to package.json; stubs and the page stay behind."""
    lib = codec(run, tmp_path / "lib", *options)
    urls = json.loads((lib / "package.json").read_text())["urls"]
    assert all(target == source for target, source in urls)
    modules = {path.relative_to(lib).as_posix() for path in lib.rglob(f"*{ending}")}
    assert {target for target, _ in urls} == modules
    assert {f"inner/__init__{ending}", f"inner/mymav/mavlink{ending}"} <= modules


def test_page_shows_how_the_package_is_imported(lib: Path) -> None:
    page = (lib / "inner/mymav/README.md").read_text()
    assert "from inner.mymav.mavlink import Link\n" in page
    assert "\nfrom inner.mymav import messages\n" in page


@pytest.mark.parametrize("name", ["my-mav", "class", "a..b", "../a", ""])
def test_names_that_no_package_has_are_refused(run: Any, tmp_path: Path, name: str) -> None:
    arguments = ["--dialect", "common", "--messages", MESSAGES, "--out", str(tmp_path), "--package", name]
    code, _, err = run("codec", *arguments)
    assert code == 2
    assert "is no name of a package" in err
    assert list(tmp_path.iterdir()) == []


def public(path: Path) -> dict[str, set[str]]:
    """The names that each class of a module, or of a stub, has for others."""
    found = {}
    for each in ast.parse(path.read_text()).body:
        if isinstance(each, ast.ClassDef):
            names = {item.name for item in each.body if isinstance(item, ast.FunctionDef)}
            names |= {item.target.id for item in each.body if isinstance(item, ast.AnnAssign)}  # type: ignore[union-attr]
            names |= {ast.unparse(item.targets[0]) for item in each.body if isinstance(item, ast.Assign)}
            kept = {
                item.attr
                for item in ast.walk(each)
                if isinstance(item, ast.Attribute)
                and isinstance(item.ctx, ast.Store)
                and ast.unparse(item.value) == "self"
            }
            found[each.name] = {name for name in names | kept if not name.startswith("_")}
    return found


INTERNAL = {
    "Link": {"send"},  # found sooner there, stated by Sender
    "Sender": {"room"},
    "Receiver": {"receive", "put"},
    "Signing": {"sign", "accepts"},
}


@pytest.mark.parametrize("module", STUBS)
def test_stubs_have_what_the_modules_have(module: str) -> None:
    templates = Path(__file__).resolve().parents[2] / "templates" / "codec"
    stub, stated = public(templates / "stubs" / f"{module}.pyi"), public(templates / f"{module}.py")
    stub.pop("Stream", None)
    assert stub.keys() == stated.keys()
    for name, members in stated.items():
        kept = {"wire", "live"} if name == "Message" else set()  # by object.__setattr__
        assert stub[name] == (members | kept) - INTERNAL.get(name, set()), name
    if module == "message":
        assert stub["Message"] == OWN
