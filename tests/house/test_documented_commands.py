"""Every command that a page shows can be typed, with its options and values; targets of make and files are there."""

import argparse
import re
import shlex
from collections.abc import Iterator
from pathlib import Path

import pytest

from codegen.cli.parser import COMMANDS, parser_for

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted([ROOT / "README.md", ROOT / "CONTRIBUTING.md", *(ROOT / "docs").glob("*.md")])
BLOCK = re.compile(r"^ *```(?:console|text|make)\n(.*?)^ *```", re.MULTILINE | re.DOTALL)
CALL = re.compile(r"^\s*(?:\$ )?(?:\.venv/bin/)?codegen (.*)$", re.MULTILINE)
INLINE = re.compile(r"(?<!`)`(?:\.venv/bin/)?(codegen [^`]+)`")
TARGET = re.compile(r"`?\bmake ([a-z]\w*)`|^(?:\$ )?make (\w+)", re.MULTILINE)
FILE = re.compile(r"`((?:benchmarks|tests|codegen|templates|examples)/[a-z0-9_./-]+\.(?:py|yaml|yml|j2|md))`")


def calls(page: Path) -> Iterator[list[str]]:
    """The arguments of the calls of codegen in the blocks of a page; no patterns such as DOC... or [--all]."""
    for block in BLOCK.findall(page.read_text(encoding="utf-8")):
        for call in CALL.findall(block):
            text = re.split(r"2?[|>;#]| {3,}|&&", call)[0].strip()
            if not re.search(r"\.\.\.$|\.\.\. |[\[\]]|\b[A-Z]+\|", text):
                yield shlex.split(text)


@pytest.mark.parametrize("page", [page for page in PAGES if page.stem != "command-line"], ids=lambda page: page.stem)
def test_blocks_can_be_typed(page: Path) -> None:
    """With all of their arguments."""
    for argv in calls(page):
        assert callable(parser_for(argv).parse_args(argv).run), argv


def test_blocks_are_found() -> None:
    assert sum(len(list(calls(page))) for page in PAGES) > 30


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_names_in_sentences_are_those_of_commands(page: Path) -> None:
    """`codegen build --check` in a sentence: the command and its options, without the values."""
    for call in INLINE.findall(page.read_text(encoding="utf-8")):
        words = call.split()[1:]
        if not re.fullmatch("[a-z]+", words[0]):
            continue
        assert words[0] in COMMANDS, call
        for option in re.findall(r"(?<!\w)--[a-z-]+", call):
            assert option in options(words[0]), call


def options(command: str) -> str:
    """The help of one command."""
    parser = parser_for([command])
    chosen = next(action for action in parser._actions if isinstance(action, argparse._SubParsersAction))
    return str(chosen.choices[command].format_help())


def test_the_page_of_the_command_has_all_of_them() -> None:
    """Each command, and no option that there is not."""
    text = (ROOT / "docs/command-line.md").read_text(encoding="utf-8")
    known: dict[str, str] = {}
    command = ""
    for line in BLOCK.findall(text)[0].splitlines():
        command = line.split()[1] if line.startswith("codegen ") else command
        known[command] = known.get(command, "") + line
    assert set(known) == set(COMMANDS)
    for name, line in known.items():
        for option in re.findall(r"--[a-z-]+", line):
            assert option in options(name), (name, option)


def test_targets_of_make_and_files_are_there() -> None:
    makefile = (ROOT / "Makefile").read_text()
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        for groups in TARGET.findall(text):
            name = "".join(groups)
            assert re.search(rf"^{name}:", makefile, re.MULTILINE), (page.name, name)
        for name in FILE.findall(text):
            assert (ROOT / name).exists(), (page.name, name)
