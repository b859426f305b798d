"""What a document states of parameters and rates has to be true of the programs that it is about, not of any other."""

import re
from pathlib import Path

import pytest
from in_process import codegen

HEAD = """# {id} | What is said

## Metadata

- Type: Functional Requirement
- Status: Draft

## Acceptance Criteria

1. {text}
"""


@pytest.fixture
def specs(tmp_path: Path) -> Path:
    """The boat and a further program whose attitude goes out at 8 Hz at first, of at most 20; the boat's at 5 of 25."""
    assert codegen(tmp_path, "init", "--from", "boat").returncode == 0
    specs = tmp_path / "specs"
    with (specs / "codegen.yaml").open("a") as file:
        file.write("programs: {sail: sail/codegen.yaml}\n")
    (specs / "sail" / "requirements").mkdir(parents=True)
    (specs / "sail" / "codegen.yaml").write_text("base: ..\nproject: sail\n")
    text = (specs / "parameters.yaml").read_text()
    stated = "default: 5, min: 0, max: 25, step: 1, requirement: FR-1.4"
    assert stated in text
    (specs / "sail" / "parameters.yaml").write_text(
        text.replace(stated, "default: 8, min: 0, max: 20, step: 1, requirement: FR-1.4")
    )
    return specs


def cite(specs: Path, folder: str, old: str, new: str) -> None:
    """Let the parameter answer to another criterion."""
    path = specs / folder / "parameters.yaml"
    lines = [
        line.replace(old, new) if "rate of the attitude" in line.lower() else line
        for line in path.read_text().splitlines(keepends=True)
    ]
    path.write_text("".join(lines))


def said(specs: Path, path: str, text: str) -> list[str]:
    """What is found in a document with one criterion, written into a folder."""
    (specs / path).write_text(HEAD.format(id=Path(path).stem, text=text))
    done = codegen(specs.parent, "check")
    found = re.findall(r"(?m)^specs/(\S+?):\d+:\d+: error (claim-[a-z-]+): (.*)$", done.stdout)
    return [f"{rule}: {message}" for file, rule, message in found if file == path]


DEFAULT = "claim-parameter: SR0_EXTRA1 has the default {} Hz, not {}"
RATE = "claim-rate: ATTITUDE is sent at {} Hz, not {} Hz"


@pytest.mark.parametrize(("stated", "other"), [("8", "5"), ("5", "8")])
def test_a_document_of_a_further_program_is_about_that_one(specs: Path, stated: str, other: str) -> None:
    """The boat's numbers were taken in it, though nothing of the boat is in that folder."""
    text = f"ATTITUDE is sent at {stated} Hz, by default of `SR0_EXTRA1`, default {stated}."
    found = said(specs, "sail/requirements/FR-7.md", text)
    wanted = [] if stated == "8" else [RATE.format("8", "5"), DEFAULT.format("8", "5")]
    assert sorted(found) == sorted(wanted), other


@pytest.mark.parametrize("program", ["boat", "sail"])
def test_a_common_document_is_about_whoever_answers_to_it(specs: Path, program: str) -> None:
    """Both have it; only one of them has a parameter that cites it."""
    cite(specs, "sail" if program == "sail" else "", "FR-1.4", "FR-8.1")
    right, wrong = ("8", "5") if program == "sail" else ("5", "8")
    path = "requirements/FR-8.md"
    assert said(specs, path, f"It is the default of `SR0_EXTRA1`, default {right}.") == []
    assert said(specs, path, f"It is the default of `SR0_EXTRA1`, default {wrong}.") == [DEFAULT.format(right, wrong)]
    assert said(specs, path, f"ATTITUDE is sent at {wrong} Hz.") == [RATE.format(right, wrong)]


def test_what_both_answer_to_may_be_true_of_either(specs: Path) -> None:
    """The document says for whom it is; no more can be known. What is true of none is wrong."""
    for folder in ("", "sail"):
        cite(specs, folder, "FR-1.4", "FR-8.1")
    path = "requirements/FR-8.md"
    for value in ("5", "8"):
        assert said(specs, path, f"It is `SR0_EXTRA1`, default {value}.") == []
    assert said(specs, path, "It is `SR0_EXTRA1`, default 6.") == [DEFAULT.format("5", "6")]
    assert said(specs, path, "ATTITUDE is sent at 6 Hz.") == ["claim-rate: ATTITUDE is sent at 5 Hz or 8 Hz, not 6 Hz"]


def test_numbers_of_parameters_are_those_of_the_program(specs: Path) -> None:
    """Each program has a list of its own."""
    path = specs / "sail" / "parameters.yaml"
    more = "  SAILS: {doc: Sails., type: uint8, default: 2, min: 1, max: 3, step: 1}\n"
    path.write_text(f"{path.read_text().rstrip()}\n{more}")
    wrong = "claim-parameter: there are 4 parameters, not 3"
    assert said(specs, "sail/requirements/FR-7.md", "It answers with all 3 parameters.") == [wrong]
    assert said(specs, "sail/requirements/FR-7.md", "It answers with all 4 parameters.") == []
