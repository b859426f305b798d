"""What a regular expression was compiled to is what a later run would make of it, and never in the way of one."""

import re
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import pytest

import codegen
from codegen.pattern import _Pattern
from codegen.tool import cache, pattern_codes
from codegen.tool.pattern_codes import FEWEST, compiled, keep_new_codes

PACKAGE = Path(codegen.__file__).parent
EXPRESSION = r"(?P<what>crc|seed)\b[^\s]{2,5}(?i:extra)?"
OTHERS = [f"{EXPRESSION}{number}" for number in range(FEWEST)]


def later_run() -> None:
    """Forget what this process knows of the folder."""
    cache.cache_folder.cache_clear()
    cache._new.clear()
    pattern_codes._kept.cache_clear()
    pattern_codes._new.clear()


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A cache of the test's own."""
    monkeypatch.setenv(cache.VARIABLE, str(tmp_path / "cache"))
    later_run()
    yield tmp_path / "cache"
    later_run()


def ended() -> None:
    """What the end of a run does."""
    keep_new_codes()
    cache.write_new()
    later_run()


def expressions_of_codegen() -> set[tuple[str, int]]:
    found = set()
    for path in PACKAGE.rglob("*.py"):
        if "pattern(" in path.read_text(encoding="utf-8") and path.stem != "pattern":
            name = ".".join(("codegen", *path.relative_to(PACKAGE).with_suffix("").parts)).removesuffix(".__init__")
            values = vars(import_module(name)).values()
            found |= {(each._expression, int(each._flags)) for each in values if isinstance(each, _Pattern)}
    return found


def test_a_later_run_has_all_patterns_of_codegen_as_re_makes_them(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two compiled patterns are equal if their expressions, flags, groups and codes are."""
    asked = expressions_of_codegen()
    assert len(asked) > 100
    for each in asked:
        compiled(*each)
    ended()
    monkeypatch.delattr(pattern_codes, "_code_of")  # nothing is compiled any more
    for expression, flags in asked:
        kept, made = compiled(expression, flags), re.compile(expression, flags)
        assert kept == made
        assert (kept.groups, kept.groupindex) == (made.groups, made.groupindex)


def test_what_is_kept_finds_the_same() -> None:
    for _ in range(2):
        found = ""
        for expression in (EXPRESSION, *OTHERS):
            match = compiled(expression, 0).search("the crc-x1EXTRA")
            expected = re.search(expression, "the crc-x1EXTRA")
            assert (match is None) == (expected is None)
            if match is not None and expected is not None:
                found = expression
                assert (match.groupdict(), match.lastgroup) == (expected.groupdict(), expected.lastgroup)
        assert found
        ended()


def test_a_few_new_ones_are_not_worth_an_entry(folder: Path) -> None:
    for expression in OTHERS[1:]:
        compiled(expression, 0)
    ended()
    assert list(folder.iterdir()) == []


def test_new_ones_come_to_those_that_are_kept(folder: Path) -> None:
    for number in range(2):
        for expression in OTHERS:
            compiled(expression, number * re.IGNORECASE)
        ended()
    assert len(list(folder.iterdir())) == 1
    assert len(pattern_codes._kept()) == 2 * FEWEST


def test_no_entry_grows_without_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pattern_codes, "MOST", FEWEST)
    for number in range(2):
        for expression in OTHERS:
            compiled(expression, number * re.IGNORECASE)
        ended()
    assert {flags for _, flags in pattern_codes._kept()} == {int(re.IGNORECASE)}


@pytest.mark.parametrize(
    "damage", [(0, b"", 0, {}, ()), (0, b"\xff" * 8, 0, {}, (None,)), (0, b"\x00" * 3, 0, {}, ()), 7]
)
def test_codes_that_the_matcher_does_not_take_are_made_again(damage: object) -> None:
    """Protects a run from an entry of another Python, whatever its version is called."""
    cache.keep_object(pattern_codes._name(), {(EXPRESSION, 0): damage})
    assert compiled(EXPRESSION, 0) == re.compile(EXPRESSION)


def test_another_re_compiles_as_ever(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(module: str) -> object:
        raise ModuleNotFoundError(module)

    monkeypatch.setattr(pattern_codes, "import_module", missing)
    assert compiled(EXPRESSION, 0) == re.compile(EXPRESSION)
    assert pattern_codes._new == {}


def test_without_a_cache_nothing_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(cache.VARIABLE, "off")
    later_run()
    assert compiled(EXPRESSION, 0) == re.compile(EXPRESSION)
    assert pattern_codes._new == {}


def test_what_is_wrong_with_an_expression_is_told_as_re_tells_it() -> None:
    with pytest.raises(re.error, match="missing \\), unterminated subpattern at position 0"):
        compiled("(crc", 0)
    assert pattern_codes._new == {}
