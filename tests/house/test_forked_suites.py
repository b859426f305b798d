"""Suites are run in forks of one process: each begins anew, ends for itself, and is told apart from others."""

from pathlib import Path

from generated_suite import run_suite


def suite(folder: Path, body: str) -> Path:
    """A folder with one test."""
    folder.mkdir()
    (folder / "test_one.py").write_text(f"import json, os, sys\n\ndef test_one():\n    {body}\n")
    return folder


def test_how_a_suite_ends_is_told(tmp_path: Path) -> None:
    """Green, red, with nothing to run, or in the middle: none is told what another one did."""
    for number, (body, code) in enumerate((("pass", 0), ("assert not 1", 1), ("os._exit(7)", 7), ("pass", 0))):
        done = run_suite(suite(tmp_path / str(number), body), "test_one.py")
        assert done.returncode == code, done.stdout
    assert run_suite(tmp_path / "0", "test_one.py", options=("-k", "nothing")).returncode == 5
    assert "AssertionError" in run_suite(tmp_path / "1", "test_one.py").stdout


def test_a_suite_finds_nothing_of_another_one(tmp_path: Path) -> None:
    """Modules are as they were imported, the folder and the environment are those of this run."""
    body = "assert not hasattr(json, 'left'); json.left = 1; assert os.getcwd() == os.path.dirname(__file__)"
    body += "; assert os.environ.get('MICROPYTHON') == {!r}; assert sys.stdin.read() == ''"
    for number, micropython in enumerate((None, Path("another"), None)):
        expected = str(micropython) if micropython else None
        done = run_suite(suite(tmp_path / str(number), body.format(expected)), "test_one.py", micropython=micropython)
        assert done.returncode == 0, done.stdout
