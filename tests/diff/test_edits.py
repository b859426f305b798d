"""A reviewer is told of edits: each at its line, with what it was, who breaks and what it reaches."""

import json
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from urllib.parse import unquote

import pytest
from jsonschema import Draft202012Validator

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[1]

Run = Callable[..., tuple[int, str, str]]

STATUS = "specs/messages/battery_status.yaml"
V2 = "specs/dialects/battery_v2.xml"


def git(folder: Path, *arguments: str) -> str:
    command = ["git", "-c", "user.name=T", "-c", "user.email=t@example.com", *arguments]
    return subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True).stdout


@pytest.fixture(scope="module")
def committed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A repository with one commit of a project."""
    folder = tmp_path_factory.mktemp("repository")
    shutil.copytree(ROOT / "projects" / "two_batteries" / "specs", folder / "specs")
    git(folder, "init", "-q", "-b", "main")
    git(folder, "add", "-A")
    git(folder, "commit", "-q", "-m", "as it was")
    return folder


@pytest.fixture
def repository(committed: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """It, as committed, and the working directory."""
    git(committed, "checkout", "-q", "-f", "main")
    git(committed, "clean", "-q", "-f", "-d")
    monkeypatch.chdir(committed)
    return committed


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    def command(*argv: str) -> tuple[int, str, str]:
        code = main(["diff", *argv])
        captured = capsys.readouterr()
        return code, captured.out, captured.err

    return command


def edit(repository: Path, file: str, old: str, new: str) -> None:
    path = repository / file
    text = path.read_text()
    assert text.count(old) == 1, f"{old!r} is in {file} {text.count(old)} times"
    path.write_text(text.replace(old, new))


BOTH = "breaks old ground station with new vehicle and new ground station with old vehicle"

EDITS: dict[str, tuple[str, str, str, list[str]]] = {
    "sentinel": (
        "specs/dialects/corrections.yaml",
        'set: {invalid: "[0]"}',
        'set: {invalid: "[7]"}',
        [
            "specs/dialects/corrections.yaml:7:5: error field-sentinel-changed: BATTERY_STATUS.voltages_ext: [0] -> [7]; "
            f"old receivers take [7] for a measurement, new ones take [0] for one; silent on the wire; {BOTH}",
            f"{STATUS}:21:3: follows: population-unknown-changed: BATTERY_STATUS.voltages_ext[2..3]: unknown 0 -> unknown 7",
        ],
    ),
    "source": (
        STATUS,
        "current_battery: {state: pack.current, rounding: toward_zero}",
        "current_battery: unknown",
        [f"{STATUS}:14:3: error population-source-changed: BATTERY_STATUS.current_battery: source pack.current; "],
    ),
    "constant": (
        STATUS,
        "voltages[1]: {constant: 3700 mV}",
        "voltages[1]: {constant: 3.8 V}",
        [
            f"{STATUS}:11:3: error population-constant-changed: BATTERY_STATUS.voltages[1]: value 3700 (3700 mV) -> value 3800"
        ],
    ),
    "limits": (
        STATUS,
        "min: -20 degC, max: 60.5 degC",
        "min: -20 degC, max: 61 degC",
        [
            f"{STATUS}:9:3: warning population-limits-changed: BATTERY_STATUS.temperature: limits -2000..6050 -> "
            "limits -2000..6100; not in CRC_EXTRA"
        ],
    ),
    "flags": (
        STATUS,
        "flags: [MAV_BATTERY_FAULT_OVER_CURRENT]",
        "flags: [MAV_BATTERY_FAULT_OVER_CURRENT if pack.charging]",
        [f"{STATUS}:23:3: warning population-flags-changed: BATTERY_STATUS.fault_bitmask: "],
    ),
    "stream": (
        STATUS,
        "stream: SLOW",
        "stream: V2",
        [f"{STATUS}:4:9: warning message-schedule-changed: BATTERY_STATUS: stream SLOW -> stream V2"],
    ),
    "rate": (
        "specs/streams.yaml",
        "rate: 0.5 Hz",
        "rate: 1 Hz",
        [
            "specs/streams.yaml:2:30: warning stream-rate-changed: stream SLOW: rate 0.5 Hz; fastest 0.5 Hz -> "
            "rate 1 Hz; fastest 1 Hz",
            "specs/streams.yaml:2:3: warning bandwidth-changed: bandwidth: ",
        ],
    ),
    "unit": (
        "specs/state.yaml",
        "stored: mA}",
        "stored: cA}",
        [
            "specs/state.yaml:6:81: warning quantity-unit-changed: pack.current: kept as current_ma in mA; "
            "steps 1000 mA each A -> kept as current_ca in cA; steps 100 cA each A",
            f"{STATUS}:14:3: follows: population-conversion-changed: BATTERY_STATUS.current_battery: conversion "
            "mA * 0.1 = cA, rounded toward zero -> conversion cA = cA, rounded toward zero",
            "specs/messages/battery_status_v2.yaml:9:3: follows: population-conversion-changed: BATTERY_STATUS_V2.current: ",
            "specs/messages/battery_status_v2.yaml:9:3: follows: population-limits-changed: BATTERY_STATUS_V2.current: ",
        ],
    ),
    "parameter": (
        "specs/parameters.yaml",
        "default: 3.3\n",
        "default: 5\n",
        [
            "specs/parameters.yaml:5:14: error parameter-default-changed: BATT_CAPACITY: default 3.3 Ah -> default 5 Ah; "
            "needs a person: whether other numbers in SMART_BATTERY_INFO.capacity_full_specification, "
        ],
    ),
    "channel": (
        "specs/board.yaml",
        "samples: 4",
        "samples: 8",
        ["specs/board.yaml:7:14: warning adc-channel-changed: adc.pack: samples 4 -> samples 8"],
    ),
    "identity": (
        "specs/codegen.yaml",
        "system_id: 42",
        "system_id: 43",
        [f"specs/codegen.yaml:5:12: error identity-changed: project: system id 42 -> system id 43; {BOTH}"],
    ),
    "criterion": (
        "specs/requirements/R-1-two-packs.md",
        "1. Both packs are reported.",
        "1. Both packs are reported at 1 Hz.",
        [
            "specs/requirements/R-1-two-packs.md:10:1: warning requirement-text-changed: FR-1.1: Both packs are "
            "reported. -> Both packs are reported at 1 Hz.",
        ],
    ),
    "citation": (
        STATUS,
        "requirement: FR-1.1",
        "requirement: FR-1.2",
        [
            "specs/requirements/R-1-two-packs.md:10:1: error criterion-untested: FR-1.1: shown by generated/tests/",
            f"{STATUS}:2:14: warning citation-changed: BATTERY_STATUS: answers to FR-1.1 -> answers to FR-1.2",
        ],
    ),
    "description": (
        V2,
        'units="%" invalid="NaN">Charge that is left, relative to a full battery</field>',
        'units="%" invalid="NaN">Charge that is left</field>',
        [f"{V2}:78:7: warning description-changed: BATTERY_STATUS_V2.state_of_charge: "],
    ),
    "type": (
        V2,
        '<field type="int16_t" name="temperature"',
        '<field type="int32_t" name="temperature"',
        [
            f"{V2}:70:5: error crc-extra-changed: BATTERY_STATUS_V2: 145 -> 31; receivers of the other version drop every "
            "frame, because temperature is int32_t, no longer int16_t; noticed: CRC_EXTRA differs, the frame is dropped; "
            f"{BOTH}",
            f"{V2}:73:7: follows: field-type-changed: BATTERY_STATUS_V2.temperature: int16_t -> int32_t",
        ],
    ),
    "entry": (
        V2,
        'value="2" name="MAV_BATTERY_STATUS_FLAGS_CHARGING"',
        'value="524288" name="MAV_BATTERY_STATUS_FLAGS_CHARGING"',
        [
            f"{V2}:10:7: error enum-entry-value-changed: MAV_BATTERY_STATUS_FLAGS.MAV_BATTERY_STATUS_FLAGS_CHARGING: "
            f"2 -> 524288; used by BATTERY_STATUS_V2.status_flags; silent on the wire; {BOTH}",
            "specs/messages/battery_status_v2.yaml:13:3: follows: population-flags-changed: "
            "BATTERY_STATUS_V2.status_flags: ",
        ],
    ),
    "a line feed in a text": (
        "specs/messages/smart_battery_info.yaml",
        "device_name: {constant: two packs}",
        'device_name: {constant: "two\\npacks"}',
        [
            "specs/messages/smart_battery_info.yaml:13:3: error population-constant-changed: SMART_BATTERY_INFO.device_name: "
            'value "two packs" (text) -> value "two\\npacks" (text); not in CRC_EXTRA; needs a person: whether '
            "two\\npacks is what receivers are to be told in place of two packs",
        ],
    ),
}


@pytest.mark.parametrize("name", EDITS)
def test_an_edit_is_told_at_its_line(name: str, repository: Path, run: Run) -> None:
    """Every finding of each edit is expected; errors, and only those, make the exit code 1."""
    file, old, new, expected = EDITS[name]
    edit(repository, file, old, new)
    code, out, err = run("HEAD")
    lines = [line.strip() for line in out.splitlines() if not line.startswith("  ") or ": follows: " in line]
    assert len(lines) == len(expected), out
    for one in expected:
        assert any(line.startswith(one) for line in lines), f"{one}\nis not among\n{out}"
    assert code == (1 if any(": error " in line for line in lines) else 0)
    assert err.startswith("HEAD -> work tree: ")


def test_nothing_is_printed_where_nothing_changed(repository: Path, run: Run) -> None:
    """Nor for comments and line breaks, which no resolved model has."""
    edit(repository, STATUS, "stream: SLOW\n", "# Rarely is enough.\n\nstream: SLOW\n")
    for form in ("text", "markdown", "github"):
        assert run("HEAD", "--format", form) == (0, "", "")


def test_messages_that_move_between_included_files_are_no_change(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, run: Run
) -> None:
    """They do so between releases of the dialect."""
    message = '<message id="7" name="M"><description>d</description><field type="uint8_t" name="a">a</field></message>'
    other = message.replace('"7"', '"8"').replace('"M"', '"N"')
    frame = "<mavlink>{}<messages>{}</messages></mavlink>"
    for side, (inner, outer) in {"old": (message + other, ""), "new": (other, message)}.items():
        (tmp_path / side).mkdir()
        (tmp_path / side / "inner.xml").write_text(frame.format("", inner))
        (tmp_path / side / "outer.xml").write_text(frame.format("<include>inner.xml</include>", outer))
    monkeypatch.chdir(tmp_path)
    assert run("old/outer.xml", "new/outer.xml") == (0, "", "")
    assert "message-removed: M" in run("old/inner.xml", "new/inner.xml")[1]


def test_an_extension_before_others_is_the_dangerous_kind(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, run: Run
) -> None:
    """At the end it breaks nobody; where it moves others, nothing tells, and both sides read wrong bytes."""
    frame = (
        '<mavlink><messages><message id="7" name="M"><description>d</description>'
        '<field type="uint8_t" name="a">a</field><extensions/>{}</message></messages></mavlink>'
    )
    one, two = (f'<field type="uint16_t" name="{name}">x</field>' for name in ("one", "two"))
    for name, inner in {"old": one, "end": one + two, "front": two + one}.items():
        (tmp_path / f"{name}.xml").write_text(frame.format(inner))
    monkeypatch.chdir(tmp_path)
    code, out, _ = run("old.xml", "end.xml")
    assert code == 0
    assert out.startswith("end.xml:1:")
    assert "warning extension-added: M.two: now uint16_t; old receivers pass over it" in out
    code, out, _ = run("old.xml", "front.xml")
    assert code == 1
    assert "it moves one: the other version reads them from the wrong bytes" in out
    assert "silent on the wire" in out


def test_a_review_says_everything_in_markdown(repository: Path, run: Run) -> None:
    """A reader of only the comment on a pull request learns of wire, sentinels, bandwidth and requirements."""
    for name in ("sentinel", "rate", "criterion", "type"):
        edit(repository, *EDITS[name][:3])
    code, out, _ = run("HEAD", "--format", "markdown")
    assert code == 1
    for part in (
        "## Specification: `HEAD` → `work tree`",
        "| Wire: ids, layout, CRC\\_EXTRA, enum values | 1 | none | 1 |".replace("\\_", "_"),
        "- **silent and breaking** · **BATTERY\\_STATUS.voltages\\_ext**: `[0]` → `[7]` (`field-sentinel-changed`)",
        "breaks old ground station with new vehicle and new ground station with old vehicle",
        "because temperature is int32\\_t, no longer int16\\_t",
        "### Bandwidth, bytes/s at the default rates",
        "| BATTERY\\_STATUS |",
        "`Both packs are reported.` → `Both packs are reported at 1 Hz.` (`requirement-text-changed`)",
        "`firmware/telemetry.py: build_battery_status`",
        "Reaches FR-1.1",
    ):
        assert part in out, f"{part}\nis not in\n{out}"


def test_what_cites_a_document_answers_to_each_of_its_criteria(repository: Path, run: Run) -> None:
    """As in the trace: a table that cites FR-1 in place of FR-1.1 leaves nothing uncovered."""
    edit(repository, STATUS, "requirement: FR-1.1", "requirement: FR-1")
    code, out, _ = run("HEAD", "--fail-on", "criterion-uncovered")
    assert code == 0, out
    assert "citation-changed: BATTERY_STATUS: answers to FR-1.1 -> answers to FR-1" in out
    (repository / "specs/messages/smart_battery_info.yaml").unlink()  # cites FR-1, too
    edit(repository, STATUS, "requirement: FR-1\n", "requirement: FR-1.2\n")
    code, out, _ = run("HEAD", "--fail-on", "criterion-uncovered")
    assert code == 1
    assert "error criterion-uncovered: FR-1.1" in out


def test_json_is_as_its_schema_says(repository: Path, run: Run) -> None:
    """The schema is closed: a key that it does not know would fail."""
    schema = json.loads(run("--schema")[1])
    Draft202012Validator.check_schema(schema)
    for name in ("sentinel", "rate", "type", "citation"):
        edit(repository, *EDITS[name][:3])
    stated = json.loads(run("HEAD", "--format", "json")[1])
    Draft202012Validator(schema).validate(stated)
    found = {change["rule"]: change for change in stated["changes"]}
    assert found["field-sentinel-changed"]["notice"] == "silent"
    assert found["field-sentinel-changed"]["breaks"] == ["old_station", "new_station"]
    assert found["field-type-changed"]["notice"] == "noticed"
    assert found["crc-extra-changed"]["causes"] == ["temperature is int32_t, no longer int16_t"]
    assert stated["summary"]["silent"] == 1, "what follows from another change is not counted again"
    heads = {change["fingerprint"]: change["rule"] for change in stated["changes"] if not change["follows"]}
    assert heads[found["population-unknown-changed"]["follows"]] == "field-sentinel-changed"
    assert heads[found["field-type-changed"]["follows"]] == "crc-extra-changed"
    assert found["field-type-changed"]["symbols"][0] == "firmware/telemetry.py: build_battery_status_v2"
    git(repository, "checkout", "-q", "-f", "main")
    Draft202012Validator(schema).validate(json.loads(run("HEAD", "--format", "json")[1]))


MARKED = 'import pytest\n\n\n@pytest.mark.requirement("FR-1.{}")\ndef test_it():\n    pass\n'


def test_a_criterion_that_lost_its_test_and_a_test_that_lost_its_criterion(repository: Path, run: Run) -> None:
    """Tests that are written by hand count, those of a revision too."""
    before = git(repository, "rev-parse", "HEAD").strip()
    edit(repository, "specs/codegen.yaml", "protocol: 2", "protocol: 2\ntests: [../tests]")
    edit(repository, "specs/requirements/R-1-two-packs.md", "2. In the old", "2. It is tested.\n3. In the old")
    edit(repository, "specs/messages/battery_status_v2.yaml", "FR-1.2", "FR-1.3")
    (repository / "tests").mkdir()
    (repository / "tests" / "test_it.py").write_text(MARKED.format(2))
    git(repository, "add", "-A")
    git(repository, "commit", "-q", "-m", "with a test")
    try:
        (repository / "tests" / "test_it.py").write_text(MARKED.format(1))
        code, out, _ = run("HEAD")
        lost = (
            "requirements/R-1-two-packs.md:11:1: error criterion-untested: FR-1.2: shown by tests/test_it.py::test_it"
        )
        assert lost in out
        assert code == 1, "nobody breaks, and yet a requirement lost what showed it"
        assert run("HEAD", "--fail-on", "silent")[0] == 0
        edit(repository, "specs/requirements/R-1-two-packs.md", "# FR-1 |", "# FR-9 |")
        edit(repository, "specs/requirements/R-1-two-packs.md", "Status: Approved", "Status: Approved\n- Aliases: FR-1")
        assert lost.replace("FR-1.2", "FR-9.2").replace(":11:", ":12:") in run("HEAD")[1]
        git(repository, "checkout", "-q", "specs/requirements")
        git(repository, "commit", "-q", "-a", "-m", "another test")
        edit(repository, "specs/requirements/R-1-two-packs.md", "\n1. Both packs are reported.", "")
        edit(repository, "specs/requirements/R-1-two-packs.md", "2. It is tested.", "1. It is tested.")
        edit(repository, "specs/requirements/R-1-two-packs.md", "3. In the old", "2. In the old")
        edit(repository, "specs/messages/battery_status_v2.yaml", "FR-1.3", "FR-1.2")
        (repository / "tests" / "test_it.py").write_text(MARKED.format(3))
        git(repository, "commit", "-q", "-a", "-m", "renumbered")
        out = run("HEAD~1", "HEAD")[1]
        assert (
            "HEAD:tests/test_it.py:4:26: error citation-orphaned: tests/test_it.py::test_it: answers to FR-1.3 -> FR-1.3 is gone"
            in out
        )
    finally:
        git(repository, "reset", "-q", "--hard", before)


def test_a_document_with_a_new_id_that_keeps_the_old_one_is_the_same(repository: Path, run: Run) -> None:
    """Rows that cite it, by either id, are as they were; its text is still compared, and so are its answers."""
    document = "specs/requirements/R-1-two-packs.md"
    edit(repository, document, "# FR-1 |", "# FR-9 |")
    edit(repository, document, "- Status: Approved", "- Status: Approved\n- Aliases: FR-1")
    edit(repository, STATUS, "requirement: FR-1.1", "requirement: FR-9.1")
    out = run("HEAD")[1]
    findings = [line for line in out.splitlines() if not line.startswith("  ")]
    assert findings == [
        f"{document}:1:1: warning requirement-status-changed: FR-9: id FR-1 -> id FR-9; aliases FR-1",
    ]
    edit(repository, document, "Both packs are reported.", "Both packs are sent.")
    edit(repository, STATUS, "requirement: FR-9.1", "requirement: FR-9.2")
    out = run("HEAD")[1]
    for said in (
        "requirement-text-changed: FR-9.1: Both packs are reported. -> Both packs are sent.",
        "criterion-untested: FR-9.1: shown by generated/tests/test_frames.py::test_frames -> shown by no test",
        "citation-changed: BATTERY_STATUS: answers to FR-1.1 -> answers to FR-9.2",
    ):
        assert said in out
    edit(repository, document, "- Aliases: FR-1\n", "")
    assert "requirement-removed: FR-1" in run("HEAD")[1]


def test_sarif_and_annotations_stand_at_files_of_the_repository(repository: Path, run: Run) -> None:
    """A service knows no lines that are gone: they are named in the text, beside their file."""
    edit(repository, STATUS, "requirement: FR-1.1\n", "requirement: FR-1\n")
    (repository / "specs/messages/smart_battery_info.yaml").unlink()
    code, out, _ = run("HEAD", "--format", "github")
    assert code == 1
    gone = "::error file=specs/messages/smart_battery_info.yaml,line=1,col=1,title=message-no-longer-sent::"
    assert gone in out
    assert "HEAD:specs/messages/smart_battery_info.yaml:1:10: it stood here" in unquote(out)
    assert "HEAD:" not in out.split("::")[1]
    log = json.loads(run("HEAD", "--format", "sarif")[1])
    results = log["runs"][0]["results"]
    uris = {one["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] for one in results}
    assert "specs/messages/smart_battery_info.yaml" in uris
    assert all(uri.startswith("specs/") for uri in uris)
    ids = [rule["id"] for rule in log["runs"][0]["tool"]["driver"]["rules"]]
    assert len(ids) == len(set(ids))


def test_the_page_escapes_what_the_specification_says(repository: Path, run: Run) -> None:
    """Nothing that stands in a table or a document becomes markup of the page or of the comment."""
    edit(repository, "specs/requirements/R-1-two-packs.md", "Both packs are", "`<script>alert(1)</script>` | @all are")
    page = run("HEAD", "--format", "html")[1]
    assert "&lt;script&gt;alert(1)" in page
    assert "<script>alert(1)" not in page
    comment = run("HEAD", "--format", "markdown")[1]
    line = next(line for line in comment.splitlines() if "requirement-text-changed" in line)
    assert "`<script>alert(1)</script> | @all are reported.`" in line


@pytest.mark.parametrize(
    ("kinds", "code"),
    [
        ("breaking", 1), ("silent", 1), ("any", 1), ("never", 0), ("behaviour", 1), ("wire", 0),
        ("trace,documentation", 0), ("field-sentinel-changed", 1), ("field-units-changed", 0), ("wire,field-sentinel-changed", 1),
    ],
)  # fmt: skip
def test_what_fails_is_chosen(kinds: str, code: int, repository: Path, run: Run) -> None:
    edit(repository, *EDITS["sentinel"][:3])
    assert run("HEAD", "--fail-on", kinds)[0] == code


def test_a_waived_change_is_shown_and_does_not_count(repository: Path, run: Run) -> None:
    """The fingerprint is that of the JSON; a change that says something else needs another waiver."""
    edit(repository, *EDITS["identity"][:3])
    found = json.loads(run("HEAD", "--format", "json")[1])["changes"][0]
    waiver = (
        f"waivers:\n  - id: W-1\n    rule: {found['rule']}\n    document: specs/codegen.yaml\n"
        f'    fingerprint: "{found["fingerprint"]}"\n    reason: All stations are updated at once.\n    owner: us\n'
        '    expires: "2999-01-01"\n'
    )
    (repository / "specs" / "waivers.yaml").write_text(waiver)
    code, out, err = run("HEAD")
    assert code == 0
    assert "waived identity-changed" in out
    assert "waived: W-1, us, until 2999-01-01: All stations are updated at once." in out
    assert "0 changes: none of them breaks anybody, 1 waived" in err
    edit(repository, "specs/codegen.yaml", "system_id: 43", "system_id: 44")
    code, out, err = run("HEAD")
    assert code == 1
    assert "waiver-unused" in err
