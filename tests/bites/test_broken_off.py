"""A script of the generated suite that breaks off fails its tests at once, and one that takes long has the time."""

import os
import sys
import time
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

import pytest
from generated_suite import run_suite
from whole_program import whole_program

GENERATED = Path(__file__).resolve().parents[2] / "generated"
SILENT_S = 2
"""So long a script of the copied suite may print nothing."""
LOOKED = """
import json, sys, time
with open(__file__ + ".run", "a") as file:
    file.write("once\\n")
names = sys.argv[1:]
"""
HANGS = LOOKED + "print('{')\nsys.stdout.flush()\ntime.sleep(600)\n"
NO_JSON = LOOKED + "print('{' + json.dumps(names[0]) + ': null')\n"
ENDS = LOOKED + "print('{')\nraise MemoryError('memory allocation failed')\n"
LONG = LOOKED + "from telling import tell\n\n\ndef slow(name):\n    time.sleep(1)\n    return name, None\n\n\n"
LONG += "tell(slow(name) if at < 4 else (name, None) for at, name in enumerate(names))\n"


@pytest.fixture(scope="module")
def tests(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The suite of the rover, whose scripts may be silent for two seconds."""
    folder = whole_program(GENERATED, tmp_path_factory.mktemp("broken_off"))
    interpreters = folder / "tests" / "interpreters.py"
    text = interpreters.read_text()
    assert "\nSILENT_S = 120\n" in text
    interpreters.write_text(text.replace("\nSILENT_S = 120\n", f"\nSILENT_S = {SILENT_S}\n"))
    return folder / "tests"


def behaviour(tests: Path, script: str) -> tuple[str, int, float]:
    """Return what the tests of a script say under CPython that has the place of behaviour.py, its runs, and seconds."""
    path = tests / "behaviour.py"
    whole = path.read_text()
    checks = whole[whole.index("CHECKS = (") : whole.index("def outcome")]
    path.write_text(f"{script}sys.exit()\n\n{checks}")
    begun = time.monotonic()
    try:
        done = run_suite(tests, "test_behaviour.py", options=("-k", "cpython", "-rN", "--tb=line"))
    finally:
        path.write_text(whole)
    runs = Path(f"{path}.run")
    count = len(runs.read_text().splitlines())
    runs.unlink()
    return done.stdout, count, time.monotonic() - begun


@pytest.mark.parametrize(
    ("script", "said"),
    [(HANGS, f"prints nothing for {SILENT_S} s"), (NO_JSON, "no JSON"), (ENDS, "memory allocation failed")],
    ids=["hangs", "no-json", "ends"],
)
def test_its_tests_fail_at_once(tests: Path, script: str, said: str) -> None:
    """None of them passes, each says why, the script is run once, and nobody waits for what does not come."""
    told, runs, seconds = behaviour(tests, script)
    summary = told.strip().splitlines()[-1]
    assert " failed" in summary
    assert "passed" not in summary
    assert told.count(said) >= int(summary.split(" failed")[0].split()[-1])
    assert runs == 1
    assert seconds < SILENT_S + 20


def test_what_takes_long_has_the_time(tests: Path) -> None:
    """The limit is for what prints nothing: a large specification has many checks, and all together take long."""
    told, runs, seconds = behaviour(tests, LONG)
    assert "failed" not in told
    assert runs == 1
    assert seconds > 2 * SILENT_S


@pytest.fixture
def conftest(tests: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The conftest of the suite as a module, for which makers are gone after a second."""
    monkeypatch.syspath_prepend(str(tests))
    for name in ("interpreters", "selection"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    spec = spec_from_file_location("conftest_of_a_suite", tests / "conftest.py")
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    for name in ("interpreters", "selection"):
        sys.modules.pop(name)
    monkeypatch.setattr(module, "GONE_S", 1)
    monkeypatch.setattr(module, "GOES_ON_S", 0.1)
    return module


def test_a_result_is_awaited_while_somebody_makes_it(conftest: ModuleType, tmp_path: Path) -> None:
    """A process that waits for another one's result has it however long that takes, and ends with that process."""
    path = tmp_path / "result.json"

    def make() -> dict[str, str]:
        os.utime(path.with_suffix(".started"), (0, 0))
        time.sleep(1.5)  # whoever looks finds that it goes on
        assert time.time() - path.with_suffix(".started").stat().st_mtime < 1
        raise ValueError("broken")

    assert conftest._shared(path, make) == {"": "ValueError: broken"}
    assert conftest._shared(path, make) == {"": "ValueError: broken"}, "it is made once"
    gone = tmp_path / "gone.json"
    gone.with_suffix(".started").touch()
    begun = time.monotonic()
    assert "does not come" in conftest._shared(gone, make)[""]
    assert time.monotonic() - begun < 10
