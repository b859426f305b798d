"""How often `codegen diff` judges as an experienced reviewer would: ``python tests/diff/corpus/score.py [--all]``.

Each pair of fragments becomes two dialects. The worst that is said of any change between them is the judgement, which
is compared with the one that the pair states. A silent break called harmless is the worst mistake, and a harmless
change for which the comparison fails is a false alarm. ``--tuned`` leaves out the pairs of other folders.
"""

import sys
import tempfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple
from xml.sax.saxutils import escape

import yaml

from codegen.decode.dialect.files import decode_dialect_files
from codegen.diagnostics import Report
from codegen.diff.change import Change, Weight
from codegen.diff.system.system import compare_dialects
from codegen.load.files import DISK
from codegen.model.dialect.dialect import Dialect
from codegen.resolve.dialect.dialect import resolve_dialect

CORPUS = Path(__file__).parent
HELD_OUT = CORPUS / "held_out"
"""A third of the pairs, which nobody looks at while rules are changed."""
SECOND = CORPUS / "second"
THIRD = CORPUS / "third"
"""Pairs of a third one, who had not seen it either: nearly all of them are about texts alone."""

FOURTH = CORPUS / "fourth"
"""Pairs of a fourth one, in the proportions in which releases have them."""

FIFTH = CORPUS / "fifth"
"""Pairs of a fifth one, in such proportions, too."""

SIXTH = CORPUS / "sixth"
"""Pairs of a sixth one, whole messages and enums of them told in other words: nothing was learnt of these."""

IN_WORDS = CORPUS / "in_words"
"""Pairs of texts alone: a file for each class of changes that is told apart, and mixed ones."""

MOST_FALSE_ALARMS = 0.05
_COMMAND = "31000"


class Pair(NamedTuple):
    """Two fragments of a dialect, with the judgement and its reason; ``of`` is the enum, message or command."""

    name: str
    judgement: Weight
    why: str
    before: str
    after: str
    of: str = "OF"
    bitmask: bool = False


class Judged(NamedTuple):
    """A pair, and what was said of it."""

    pair: Pair
    judgement: Weight
    changes: tuple[Change, ...]

    @property
    def is_right(self) -> bool:
        """Whether the reviewer says the same."""
        return self.judgement is self.pair.judgement

    @property
    def is_missed(self) -> bool:
        """Whether a break that nothing tells of is called harmless."""
        return self.pair.judgement is Weight.SILENT and self.judgement is Weight.HARMLESS

    @property
    def is_false_alarm(self) -> bool:
        """Whether a harmless change fails."""
        return self.pair.judgement is Weight.HARMLESS and self.judgement is not Weight.HARMLESS


def pairs_of(folder: Path) -> list[Pair]:
    """The pairs of the files of a folder."""
    return [_pair(each) for file in sorted(folder.glob("*.yaml")) for each in _written(file)]


def pairs_in_words(file: Path) -> list[Pair]:
    """The pairs of a file that has nothing but what each is about, its judgement and both texts."""
    return [_in_words(f"{file.stem}-{number}", each) for number, each in enumerate(_written(file), 1)]


def _written(file: Path) -> list[dict[str, Any]]:
    """Return what is written of the pairs of a file, read by libyaml where there is one: nine times as fast."""
    found: list[dict[str, Any]] = yaml.load(file.read_text(), getattr(yaml, "CSafeLoader", yaml.SafeLoader))  # noqa: S506
    return found


def _in_words(name: str, written: dict[str, Any]) -> Pair:
    about, units = written["about"], written.get("units")
    old, new = _fragment(about, written["old"], None), _fragment(about, written["new"], units)
    return Pair(name, Weight(written["judgement"]), "", old, new)


def _fragment(about: str, text: str | list[str], units: str | None) -> str:
    """The XML of a text about a field, a parameter, a message, an entry, or several of them about entries."""
    attribute = f' units="{units}"' if units else ""
    texts = [escape(one) for one in ([text] if isinstance(text, str) else text)]
    if about == "field":
        return f'<field type="uint16_t" name="a"{attribute}>{texts[0]}</field>'
    if about == "parameter":
        return f'<param index="1" label="Number"{attribute}>{texts[0]}</param>'
    if about == "message":
        field = '<field type="uint8_t" name="a">A thing</field>'
        return f'<message id="902" name="M"><description>{texts[0]}</description>{field}</message>'
    return "".join(
        f'<entry value="{number}" name="OF_{number}"><description>{one}</description></entry>'
        for number, one in enumerate(texts)
    )


def _pair(written: dict[str, Any]) -> Pair:
    return Pair(**{**written, "judgement": Weight(written["judgement"])})


def judged(pairs: Iterable[Pair]) -> Iterator[Judged]:
    """What is said of each pair."""
    with tempfile.TemporaryDirectory() as folder:
        for pair in pairs:
            old, new = (_dialect(Path(folder), pair, fragment) for fragment in (pair.before, pair.after))
            changes = compare_dialects(old, new).changes
            yield Judged(
                pair,
                min((change.weight for change in changes), key=lambda one: one.rank, default=Weight.HARMLESS),
                changes,
            )


def _dialect(folder: Path, pair: Pair, fragment: str) -> Dialect:
    file = folder / "d.xml"
    file.write_text(_whole(pair, fragment))
    report = Report()
    dialect = resolve_dialect("d", decode_dialect_files(str(file), DISK, report), (), report)
    broken = [
        f"{pair.name}: {found.message}"
        for found in report
        if found.is_error and "there is no enum" not in found.message
    ]
    assert not broken, broken
    return dialect


def _whole(pair: Pair, fragment: str) -> str:
    """The dialect around a fragment: its entries, fields and parameters belong to what the pair is about."""
    lines = list(fragment.replace("<enum ", "\n<enum ").replace("<message ", "\n<message ").splitlines())
    enums = [line for line in lines if line.startswith("<enum ")]
    messages = [line for line in lines if line.startswith("<message ")]
    inner = "".join(line for line in lines if line not in enums and line not in messages)
    if inner.startswith("<entry"):
        bits = ' bitmask="true"' if pair.bitmask else ""
        enums.append(f'<enum name="{pair.of}"{bits}>{inner}</enum>')
        user = f'<field type="uint32_t" name="used" enum="{pair.of}">What it is</field>'
        messages.append(f'<message id="900" name="USER"><description>User</description>{user}</message>')
    elif inner.startswith("<param") or pair.of.startswith("MAV_CMD_"):
        entry = f'<entry value="{_COMMAND}" name="{pair.of}"><description>It is done.</description>{inner}</entry>'
        enums.append(f'<enum name="MAV_CMD">{entry}</enum>')
    elif inner:
        messages.append(f'<message id="901" name="{pair.of}"><description>It is told.</description>{inner}</message>')
    return f"<mavlink><enums>{''.join(enums)}</enums><messages>{''.join(messages)}</messages></mavlink>"


def told(found: list[Judged], *, is_all: bool) -> Iterator[str]:
    """The report: each pair that is judged otherwise, then the counts."""
    for each in found:
        if is_all or not each.is_right:
            yield f"{each.pair.name}: {each.pair.judgement} by the reviewer, {each.judgement} here. {each.pair.why}"
            for change in each.changes:
                said = f"{change.old} -> {change.new}: {change.weight}; {change.effect} {change.doubt}"
                yield f"    {change.rule.id} {change.subject}: {said}"
    harmless = sum(each.pair.judgement is Weight.HARMLESS for each in found)
    alarms, missed = (sum(getattr(each, kind) for each in found) for kind in ("is_false_alarm", "is_missed"))
    yield f"{len(found)} pairs, {sum(each.is_right for each in found)} judged alike"
    yield f"silent breaks called harmless: {missed} of {sum(each.pair.judgement is Weight.SILENT for each in found)}"
    yield f"false alarms: {alarms} of {harmless} harmless ones, {alarms / max(1, harmless):.1%}"


if __name__ == "__main__":
    folders = [CORPUS] if "--tuned" in sys.argv else [CORPUS, HELD_OUT, SECOND, THIRD, FOURTH, FIFTH, SIXTH]
    for folder in folders:
        print(f"== {folder.relative_to(CORPUS.parent)}")
        print("\n".join(told(list(judged(pairs_of(folder))), is_all="--all" in sys.argv)))
    for file in () if "--tuned" in sys.argv else sorted(IN_WORDS.glob("*.yaml")):
        print(f"== {file.relative_to(CORPUS.parent)}")
        print("\n".join(told(list(judged(pairs_in_words(file))), is_all="--all" in sys.argv)))
