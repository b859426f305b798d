"""The headline never says that nothing breaks where somebody hears nothing, hears less, or gets other numbers."""

import re
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from codegen.answers.fixed import FixedAnswer
from codegen.commands.trace import read_trace
from codegen.diagnostics import Report
from codegen.diff.reach import traces, with_reach
from codegen.diff.report.review import Review, as_finding, fails, review
from codegen.diff.system.population import population_changes
from codegen.diff.system.system import compare_systems
from codegen.findings.text import finding_text
from codegen.model.answers.answer import Answer
from codegen.model.system import System
from codegen.project.systems import read_systems

ROOT = Path(__file__).resolve().parents[2]

Edit = Callable[[Path], None]


def replaced(file: str, old: str, new: str) -> Edit:
    def edit(specs: Path) -> None:
        path = specs / file
        text = path.read_text()
        assert text.count(old) >= 1, f"{old!r} is not in {file}"
        path.write_text(text.replace(old, new, 1))

    return edit


STATUS = "messages/battery_status.yaml"

CASES: dict[str, tuple[Edit, str, str]] = {
    "off its stream": (
        replaced(STATUS, "stream: EXTRA1\n", ""),
        "error message-schedule-changed: BATTERY_STATUS: stream EXTRA1 -> stream on request; who does not ask for it "
        "hears nothing; breaks old ground station with new vehicle",
        "break",
    ),
    "rate 0": (
        replaced("parameters.yaml", "default: 2\n    min: 0\n    max: 50", "default: 0\n    min: 0\n    max: 50"),
        "who does not ask for it hears nothing; breaks old ground station with new vehicle",
        "break",
    ),
    "lower rate": (
        replaced("parameters.yaml", "default: 2\n    min: 0\n    max: 50", "default: 1\n    min: 0\n    max: 50"),
        "needs a person: whether it is heard often enough: 1 times a second and no longer 2",
        "need",
    ),
    "constant": (
        replaced(STATUS, "current_battery: {state: battery.current", "current_battery: {constant: 5 A} #"),
        "always 500, which receivers take for what is so now; silent on the wire; breaks",
        "break",
    ),
    "no more on a change": (
        replaced("messages/smart_battery_info.yaml", "on_change: battery.swaps\n", ""),
        "needs a person: whether it is heard soon enough that battery.swaps has changed",
        "need",
    ),
    "threshold": (
        replaced("parameters.yaml", "default: 3.5", "default: 3.4"),
        "needs a person: whether another value is meant for the low threshold of the failsafe of battery.voltage",
        "need",
    ),
    "believed for longer": (
        replaced("state.yaml", "stale_after: 1 s", "stale_after: 60 s"),
        "needs a person: whether it is to be unknown just then, which failsafe battery may wait for",
        "need",
    ),
    "about another one": (
        replaced("messages/sys_status.yaml", "{parameter: BATT_SYS_STATUS}", "{first: true}"),
        "needs a person: whether receivers are to be told of another battery, the first",
        "need",
    ),
    "divider": (
        replaced("parameters.yaml", "default: 3.95", "default: 4.95"),
        "the same reading is 99/79 times what it was in ",
        "need",
    ),
    "reference": (
        replaced("board.yaml", "reference: 3.3 V", "reference: 3.0 V"),
        "the same count is 10/11 times what it was in ",
        "need",
    ),
    "criteria": (
        replaced("parameters.yaml", "requirement: FR-00073.6", "requirement: FR-00073.5"),
        "error criterion-uncovered: FR-00073.6",
        "what a requirement asks for",
    ),
    "link": (
        replaced("parameters.yaml", "default: 2\n    min: 0\n    max: 50", "default: 50\n    min: 0\n    max: 50"),
        "error link-overloaded: link.radio: ",
        "break",
    ),
}


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The specification of the rover with a slow radio, in a folder of its own."""
    folder = tmp_path_factory.mktemp("heard")
    shutil.copytree(ROOT / "specs", folder / "old")
    replaced("board.yaml", "links:\n", "links:\n  radio: {uart: 0, tx: 0, rx: 1, baud: 9600}\n")(folder / "old")
    return folder


@pytest.fixture(scope="module")
def before(project: Path) -> tuple[System, ...]:
    return read_systems(str(project / "old" / "codegen.yaml"), Report())


@pytest.mark.parametrize("name", CASES)
def test_what_is_heard_otherwise_fails_and_stands_in_the_headline(
    name: str, project: Path, before: tuple[System, ...]
) -> None:
    edit, said, headline = CASES[name]
    shutil.rmtree(project / "new", ignore_errors=True)
    shutil.copytree(project / "old", project / "new")
    edit(project / "new")
    after = read_systems(str(project / "new" / "codegen.yaml"), Report())
    found = review("old", "new", compare_systems(before, after))
    assert said in "\n".join(finding_text(as_finding(group)) for group in found.groups)
    assert "none of them breaks anybody" not in found.head_line
    assert headline in found.head_line
    assert fails(found, ["breaking", "person"])


@pytest.mark.parametrize("is_full", [False, True])
def test_another_order_of_streams_is_told(before: tuple[System, ...], is_full: bool) -> None:
    """What goes first is a question where a link cannot carry them all; a stream more or less is no other order."""
    main = before[0]
    if is_full:
        slow = tuple(
            replace(each, spec=replace(each.spec, baud=300)) if each.spec.baud else each for each in main.links
        )
        main = replace(main, links=slow)
    first, *others = main.streams.items()
    moved = compare_systems((main,), (replace(main, streams=dict([*others, first])),)).changes
    assert [change.rule.id for change in moved] == ["stream-order-changed"]
    (change,) = moved
    assert change.old is not None
    assert change.old.split(", ") == list(main.streams)
    assert change.new == ", ".join([*(name for name, _ in others), first[0]])
    assert change.doubt == (f"whether {first[0]} may be left out on radio" if is_full else "")
    gone = compare_systems((main,), (replace(main, streams=dict(others)),)).changes
    assert "stream-order-changed" not in {change.rule.id for change in gone}


@pytest.mark.parametrize(
    ("key", "said"),
    [
        ("on_change: battery.swaps\n", "who does not ask for it hears of no change of battery.swaps; breaks"),
        ("on_connection: true\n", "who connects and does not ask for it hears nothing; breaks"),
    ],
)
def test_what_nothing_else_sends_breaks(key: str, said: str, project: Path) -> None:
    """A message without a stream goes out on a change and to who connects: without that nobody hears of it."""
    file = "messages/smart_battery_info.yaml"
    sides = []
    for name, edits in (("one", ("stream: INFO\n",)), ("other", ("stream: INFO\n", key))):
        shutil.rmtree(project / name, ignore_errors=True)
        shutil.copytree(project / "old", project / name)
        for edit in edits:
            replaced(file, edit, "")(project / name)
        report = Report()
        sides.append(read_systems(str(project / name / "codegen.yaml"), report))
        assert sides[-1], list(report)
    found = review("one", "other", compare_systems(*sides))
    (group,) = [each for each in found.groups if each.first.rule.id == "message-schedule-changed"]
    assert said in finding_text(as_finding(group))
    assert "none of them breaks anybody" not in found.head_line
    assert fails(found, ["breaking"])


def test_a_point_of_a_curve_is_a_question(tmp_path: Path) -> None:
    """What follows a reading is another number then, and a failsafe on it acts elsewhere."""
    specs = ROOT / "tests" / "projects" / "radio_rover" / "specs"
    shutil.copytree(specs, tmp_path / "specs")
    board = tmp_path / "specs" / "board.yaml"
    text = board.read_text()
    board.write_text(re.sub(r"(curves:\n(?:.*\n)*?.*?[\d.]+ V: )(\d\d)\b", r"\g<1>51", text, count=1))
    assert board.read_text() != text
    systems = [read_systems(str(folder / "codegen.yaml"), Report()) for folder in (specs, tmp_path / "specs")]
    found = review("old", "new", compare_systems(*systems))
    said = "\n".join(finding_text(as_finding(group)) for group in found.groups)
    assert "error quantity-source-changed" in said
    assert "needs a person: whether it still gives the same numbers" in said
    assert fails(found, ["person"])


def compared(project: Path, before: tuple[System, ...], edit: Edit) -> Review:
    """The review of an edit, with what it reaches."""
    shutil.rmtree(project / "new", ignore_errors=True)
    shutil.copytree(project / "old", project / "new")
    edit(project / "new")
    after = read_systems(str(project / "new" / "codegen.yaml"), Report())
    trace = traces(read_trace(before, Report()), read_trace(after, Report()), (*before, *after))
    found = compare_systems(before, after)
    return review("old", "new", replace(found, changes=with_reach(found.changes, trace)))


def test_the_default_of_a_multiplier_reaches_what_the_reference_voltage_does(
    project: Path, before: tuple[System, ...]
) -> None:
    """Both change each number that comes of a reading: the same tests, criteria, builders; a family is one finding."""
    (divider,) = compared(project, before, CASES["divider"][0]).groups
    assert divider.subject == "BATT_VOLT_MULT, BATT2_VOLT_MULT"
    (reference,) = compared(project, before, CASES["reference"][0]).groups
    assert reference.first.rule.id == "adc-channel-changed"
    assert [each.first.rule.id for each in reference.following] == ["quantity-source-changed"]
    assert "firmware/telemetry.py: build_battery_status" in divider.reach.symbols
    assert {test for test in divider.reach.tests if "test_frames" in test}
    assert set(reference.reach.tests) - set(divider.reach.tests) == set()
    assert {one for one in reference.reach.requirements if one.startswith("FR-00068")} <= set(
        divider.reach.requirements
    )


def test_a_rate_s_default_stands_below_its_stream(project: Path, before: tuple[System, ...]) -> None:
    """It reaches the messages of the stream, and is told once."""
    found = compared(project, before, CASES["lower rate"][0])
    stream = next(group for group in found.groups if group.first.rule.id == "stream-rate-changed")
    assert [each.first.rule.id for each in stream.following] == ["parameter-default-changed"]
    assert not any(group.first.rule.id == "parameter-default-changed" for group in found.groups)
    assert "firmware/telemetry.py: build_battery_status" in stream.following[0].reach.symbols


NAN = float("nan")
"""What a float field carries that is unknown; it is not equal to itself."""


def fixed(value: float, meaning: str = "", *, is_unknown: bool = False) -> Callable[[Answer], Answer]:
    return lambda answer: FixedAnswer(answer.covers, (value,), meaning or str(value), is_unknown)


def as_it_is(answer: Answer) -> Answer:
    return answer


TOLD = "whether it still tells receivers of the same thing"


@pytest.mark.parametrize(
    ("field", "before_it", "after_it", "weight", "said"),
    [
        ("current", as_it_is, fixed(5.5), "silent", "always 5.5, which receivers take for what is so now"),
        ("current", as_it_is, fixed(NAN, is_unknown=True), "breaking", "receivers hear nothing of it any more"),
        ("current", fixed(5.5), as_it_is, "harmless", ""),
        ("current", fixed(NAN, is_unknown=True), as_it_is, "harmless", ""),
        ("current", fixed(5.5), fixed(6.5), "person", "whether 6.5 is what receivers are to be told in place of 5.5"),
        ("current", fixed(5.5), fixed(5.5, "five and a half"), "harmless", ""),
        ("current", fixed(NAN), fixed(NAN, "no number"), "harmless", ""),
        ("current", fixed(NAN, is_unknown=True), fixed(NAN), "harmless", ""),
        ("current", fixed(5.5), fixed(NAN), "person", "whether nan is what receivers are to be told in place of 5.5"),
        ("current", fixed(NAN), fixed(5.5), "person", "whether 5.5 is what receivers are to be told in place of nan"),
        ("current", as_it_is, "voltage", "person", TOLD),
        ("temperature", as_it_is, fixed(32767), "breaking", "receivers hear nothing of it any more"),
        ("id", as_it_is, fixed(1), "silent", "always 1, which receivers take for what is so now"),
    ],
)
def test_what_an_element_carries_from_now_on(
    field: str,
    before_it: Callable[[Answer], Answer],
    after_it: Callable[[Answer], Answer] | str,
    weight: str,
    said: str,
    before: tuple[System, ...],
) -> None:
    """A number that stands still is taken for what is so; one that comes, or means the same, harms nobody."""
    system = before[0]
    message = next(each for each in system.messages if each.name == "BATTERY_STATUS_V2")
    answers = {answer.covers.label: answer for answer in message.answers}

    def changed(answer: Answer, edit: Callable[[Answer], Answer] | str) -> Answer:
        return replace(answers[edit], covers=answer.covers) if isinstance(edit, str) else edit(answer)

    sides = []
    for edit in (before_it, after_it):
        edited = replace(message, answers=tuple({**answers, field: changed(answers[field], edit)}.values()))
        sides.append(replace(system, messages=tuple(edited if one is message else one for one in system.messages)))
    (found,) = population_changes(*sides)
    assert (found.subject, found.weight) == (f"BATTERY_STATUS_V2.{field}", weight)
    assert (found.effect or found.doubt) == said
