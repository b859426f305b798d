"""An entry of the cache is believed only while it is as it was written, and never stands in the way of a run."""

import os
from collections.abc import Iterator
from pathlib import Path

import pytest

from codegen.tool import cache
from codegen.tool import digest as tool
from codegen.tool.cache import entry, keep, keep_object, kept, kept_object, pickled, write_new


def later_run() -> None:
    """Forget what this process knows of the folder."""
    cache.cache_folder.cache_clear()
    cache._new.clear()


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A cache of the test's own."""
    monkeypatch.setenv(cache.VARIABLE, str(tmp_path / "cache"))
    later_run()
    yield tmp_path / "cache"
    later_run()


def written(name: str, value: bytes) -> str:
    keep(name, value)
    write_new()
    later_run()
    return name


def test_a_later_run_finds_what_was_kept(folder: Path) -> None:
    name = written(entry("a"), b"value")
    assert kept(name) == b"value"
    assert kept(entry("b")) is None
    assert [path.name for path in folder.iterdir()] == [name]


def test_nothing_is_written_before_the_run_says_so(folder: Path) -> None:
    """A run that fails, or whose code was changed under it, leaves nothing behind."""
    keep(entry("a"), b"value")
    assert kept(entry("a")) == b"value"
    assert list(folder.iterdir()) == []


def test_inputs_that_differ_have_names_that_differ() -> None:
    names = {entry(*parts) for parts in (("ab", "c"), ("a", "bc"), ("abc",), ("abc", ""), ("", "abc"), ("ab", b"d"))}
    assert len(names) == 6


def test_equal_values_are_equal_inputs_whatever_they_share() -> None:
    shared = "x" * 5
    other = "".join(["x"] * 5)
    assert pickled([shared, shared]) == pickled([shared, other])


@pytest.mark.parametrize(
    "damage",
    [
        pytest.param(lambda content: content[:-1], id="cut-off"),
        pytest.param(lambda _: b"", id="empty"),
        pytest.param(lambda content: content[:40] + b"?" + content[41:], id="one-byte"),
        pytest.param(lambda content: content + b"?", id="longer"),
        pytest.param(lambda _: bytes(100), id="zeros"),
    ],
)
def test_what_is_damaged_is_not_there(folder: Path, damage: object) -> None:
    keep_object(entry("a"), ["value"] * 10)
    write_new()
    later_run()
    path = folder / entry("a")
    path.write_bytes(damage(path.read_bytes()))  # type: ignore[operator]
    assert kept_object(entry("a")) is None


def test_an_entry_under_another_name_is_not_that_one(folder: Path) -> None:
    name = written(entry("a"), b"value")
    (folder / name).rename(folder / entry("b"))
    assert kept(entry("b")) is None


@pytest.mark.usefixtures("folder")
def test_an_object_of_a_class_that_is_gone_is_not_there() -> None:
    assert kept_object(written(entry("a"), b"ccodegen.nowhere\nThing\n.")) is None


@pytest.mark.parametrize("chosen", ["off", "OFF", "", "relative/folder"])
def test_it_can_be_switched_off(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, chosen: str) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv(cache.VARIABLE, chosen)
    later_run()
    written(entry("a"), b"value")
    assert kept(entry("a")) is None
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("mode", [0o777, 0o770])
def test_a_folder_that_others_could_write_to_is_left_alone(folder: Path, mode: int) -> None:
    """Entries are code and objects: whoever puts them there decides what codegen does."""
    name = written(entry("a"), b"value")
    folder.chmod(mode)
    later_run()
    assert kept(name) is None
    written(entry("b"), b"value")
    assert not (folder / entry("b")).exists()


def test_a_folder_that_cannot_be_made_is_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("")
    for path in ("file", "file/below"):
        monkeypatch.setenv(cache.VARIABLE, str(tmp_path / path))
        later_run()
        assert kept(written(entry("a"), b"value")) is None


def test_a_full_disk_takes_nothing_and_stops_nothing(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(_old: str, _new: str) -> None:
        raise OSError(28, "No space left on device")

    assert cache.cache_folder()
    monkeypatch.setattr(os, "replace", refuse)
    written(entry("a"), b"value")
    assert list(folder.iterdir()) == []


def test_it_stays_small(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The oldest entries go; what somebody was about to write long ago goes with them."""
    monkeypatch.setattr(cache, "MOST_BYTES", 20_000)
    monkeypatch.setattr(cache, "_LOOKS", "0")
    folder.mkdir(mode=0o700)
    unfinished = folder / "unfinished"
    unfinished.write_bytes(bytes(1000))
    os.utime(unfinished, (1, 1))
    names = [entry(str(number)) for number in range(200)]
    for number, name in enumerate(names):
        written(name, bytes(1000))
        os.utime(folder / name, (1000 + number, 1000 + number))
    last_look = max(number for number, name in enumerate(names) if name.startswith("0"))
    assert len(list(folder.iterdir())) <= 20 + len(names) - last_look
    assert not unfinished.exists()
    assert not (folder / names[0]).exists()
    assert kept(names[-1]) is not None


def test_what_code_made_that_changed_meanwhile_is_not_kept(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    keep(entry("a"), b"value")
    with monkeypatch.context() as patch:
        patch.setattr(tool, "_files_at_start", lambda: [("a.py", "as it was")])
        tool.keep_what_is_new()
        assert list(folder.iterdir()) == []
    tool.keep_what_is_new()
    assert (folder / entry("a")).exists()
