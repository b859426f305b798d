"""Holds every frame against pymavlink and against what was set."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import ModuleType
from typing import Any

from population.answer import Answer
from population.building import build
from population.cases import Case, make_cases
from population.expected import Carried
from population.fields import Message
from population.running import FORMS, run, write_cases


@dataclass
class Outcome:
    """The result: proven elements by label, rules of those refused, numbers by message, and differences.

    ``texts`` are fields that a constant answers; ``withheld`` are cases in which nothing goes out.
    """

    proven: set[str] = field(default_factory=set)
    refused: dict[str, str] = field(default_factory=dict)
    texts: set[str] = field(default_factory=set)
    frames: Counter[str] = field(default_factory=Counter)
    withheld: Counter[str] = field(default_factory=Counter)
    values: Counter[str] = field(default_factory=Counter)
    differences: list[str] = field(default_factory=list)

    def add(self, other: "Outcome") -> None:
        """Take in what another batch brought."""
        self.proven |= other.proven
        self.refused |= other.refused
        self.texts |= other.texts
        self.frames += other.frames
        self.withheld += other.withheld
        self.values += other.values
        self.differences += other.differences


def prove(
    dialect: str,
    module: ModuleType,
    messages: Sequence[Message],
    folder: Path,
    seed: int = 1,
    rounds: int = 10,
    forms: Sequence[str] = tuple(FORMS),
) -> Outcome:
    """Build a project of some messages, and compare what it sends in each form; ``module`` is pymavlink's."""
    tables, refused = build(dialect, messages, folder, seed)
    cases = {name: make_cases(tuple(answers), seed, rounds) for name, answers in tables.items()}
    write_cases(folder, tables, cases)
    outcome = Outcome(refused=refused)
    for answers in tables.values():
        outcome.texts |= {each.label for each in answers if each.kind == "text" and each.steps is None}
        outcome.proven |= {each.label for each in answers if each.kind != "fixed"} - outcome.texts
    printed = [run(folder, form) for form in forms]
    assert {len(lines) for lines in printed} == {sum(map(len, cases.values()))}
    sent = zip(*printed, strict=True)
    for name, answers in tables.items():
        for number, case in enumerate(cases[name]):
            first, *others = next(sent)
            problems = _differences(module, name, answers, case, first, outcome)
            odd = [(form, line) for form, line in zip(forms[1:], others, strict=True) if line != first]
            problems += [f"{form} sends {line}, and {forms[0]} {first}" for form, line in odd]
            outcome.differences += [f"{name}, case {number}: {problem}" for problem in problems]
    return outcome


def _differences(
    module: ModuleType, name: str, answers: Sequence[Answer], case: Case, line: str, outcome: Outcome
) -> list[str]:
    """Return the faults of a frame: pymavlink's reading of each field is compared with the setting and packed anew."""
    if case.expected is None or line == "-" or " or " in line:
        outcome.withheld[name] += line == "-"
        is_right = (line == "-") == (case.expected is None) and " or " not in line
        return [] if is_right else [f"{line} in place of {'-' if case.expected is None else 'a frame'}"]
    outcome.frames[name] += 1
    outcome.values[name] += len(answers)
    try:
        decoded = module.MAVLink(None).decode(bytearray.fromhex(line))
    except module.MAVError as error:
        return [f"pymavlink refuses {line}: {error}"]
    found = []
    for each, expected, setting in zip(answers, case.expected, case.settings, strict=True):
        value = _read(decoded, each.field.name)
        if isinstance(value, bytes):
            value = value.partition(b"\0")[0].decode(errors="replace")
        elif each.field.count:
            value = value[each.at]
        if not expected.is_met_by(value):
            found.append(f"{each.key} is {value!r}, not {_shown(expected)}: {setting}, {dict(each.quantity)}")
    known = getattr(module, f"MAVLink_{name.lower()}_message")
    values = {item: _read(decoded, item) for item in known.fieldnames}
    if known(**values).pack(module.MAVLink(None, srcSystem=1, srcComponent=1)).hex() != line:
        found.append(f"the frame is not pymavlink's: {line}")
    return found


def _read(decoded: Any, name: str) -> Any:
    """Return the value that pymavlink decodes; of a text the bytes, since it takes all texts for ASCII."""
    return getattr(decoded, f"_{name}_raw", getattr(decoded, name))


def _shown(expected: Carried) -> str:
    if expected.text is not None:
        return repr(expected.text)
    return repr(expected.low) if expected.low == expected.high else f"{expected.low!r} to {expected.high!r}"
