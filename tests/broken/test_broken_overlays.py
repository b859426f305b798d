"""Overlays and corrections: what cannot work as drafted is found at its line, and repaired only by a correction.

The drafts of RFC 0018 in specs/dialects/ are faulty on purpose; the other faults are written into copies of them.
"""

import re
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[2]
DIALECTS = ROOT / "specs" / "dialects"
DRAFT, CELLS, FAULTS = (
    f"dialects/{name}_rfc_0018.xml" for name in ("battery", "battery_cell_voltages", "battery_cell_faults")
)
UPSTREAM, INFO, OTHER = (
    f"dialects/{name}.xml" for name in ("battery_upstream", "battery_info_upstream", "protocol_version")
)
REPAIRS = "dialects/corrections_rfc_0018.yaml"

ABOUT_OVERLAYS = ("unknown-overlay", "file-not-found", "known-messages")

Found = list[tuple[str, str]]
Check = Callable[..., Found]


def place(file: str, text: str) -> str:
    """Return the place, as file:line:col, at which the element opens that holds the text."""
    for number, line in enumerate((ROOT / "specs" / file).read_text(encoding="utf-8").split("\n"), 1):
        if text in line:
            return f"specs/{file}:{number}:{line.index('<') + 1}"
    raise AssertionError(text)


@pytest.fixture
def check(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Check:
    """Check a copy of the shipped specification with other overlays; findings as (place, rule), tables left out."""
    specs = tmp_path / "specs"
    shutil.copytree(ROOT / "specs", specs)
    monkeypatch.chdir(tmp_path)

    def check(*overlays: str, is_corrected: bool = True, **edits: tuple[str, str]) -> Found:
        project = specs / "codegen.yaml"
        text = re.sub(r"(?m)^overlays:(\n  - .*)+", f"overlays: [{', '.join((*overlays, OTHER))}]", project.read_text())
        if not is_corrected:
            (specs / REPAIRS).unlink(missing_ok=True)
            text = text.replace(f"corrections: [{REPAIRS}]\n", "")
        project.write_text(text)
        for name, (old, new) in edits.items():
            path = next(path for ending in (".yaml", ".xml") for path in specs.glob(f"**/{name}{ending}"))
            assert path.read_text().count(old) == 1
            path.write_text(path.read_text().replace(old, new))
        main(["check"])
        printed = capsys.readouterr().out
        found = re.findall(r"(?m)^(\S+:\d+:\d+): (?:error|warning) ([\w-]+): ", printed)
        return [one for one in found if "/dialects/" in one[0] or one[1] in ABOUT_OVERLAYS]

    return check


TOO_LONG = (place(CELLS, "<message id"), "message-payload")
TAKEN = (place(CELLS, "<message id"), "taken-elsewhere")
ALL_BITS = (place(DRAFT, "4294967295"), "flag-of-several-bits")
TWO_SENTINELS = (place(DRAFT, "UINT32_MAX"), "text-contradicts-invalid")
NO_NUMBER = (place(FAULTS, "???"), "message-id")


@pytest.mark.requirement("FR-00076.9")
def test_the_drafts_without_corrections(check: Check) -> None:
    """Exactly what does not work is found, each at the line of the XML that states it."""
    assert check(DRAFT, CELLS, is_corrected=False) == [TOO_LONG, TAKEN, ALL_BITS, TWO_SENTINELS]


def test_the_alternative_without_corrections(check: Check) -> None:
    """An id that is no number, and what is wrong in the file beside it."""
    assert check(DRAFT, FAULTS, is_corrected=False) == [NO_NUMBER, ALL_BITS, TWO_SENTINELS]


@pytest.mark.requirement("FR-00072.9")
@pytest.mark.parametrize(
    "overlays", [(UPSTREAM, CELLS), (DRAFT, CELLS), (DRAFT, FAULTS), (UPSTREAM, INFO), (INFO,), (DRAFT,), ()]
)
def test_corrected_overlays_have_no_findings(overlays: tuple[str, ...], check: Check) -> None:
    """The project file alone chooses: corrections of overlays that it does not list are neither used nor missed."""
    assert check(*overlays) == []


@pytest.mark.requirement("FR-00072.9", "FR-00076.9")
@pytest.mark.parametrize(
    ("entry", "finding"),
    [("id", TAKEN), ("type", TOO_LONG), ("value", ALL_BITS), ("text", TWO_SENTINELS)],
)
def test_each_correction_repairs_one_finding(entry: str, finding: tuple[str, str], check: Check) -> None:
    """Without it that finding is back, alone."""
    effects = {
        "id": ('id: "54371"', 'wip: ""'),
        "type": ('{type: "uint16_t[12]"}', '{print_format: ""}'),
        "value": ('{value: "2147483648"}', '{hasLocation: ""}'),
        "text": ("NaN: not provided.", "UINT32_MAX: not provided."),
    }
    found = check(DRAFT, CELLS, corrections_rfc_0018=effects[entry])
    assert [one for one in found if REPAIRS not in one[0]] == [finding]


@pytest.mark.parametrize(
    ("old", "new", "rule"),
    [
        ('id: "54371"', 'id: "371"', "obsolete-correction"),
        ('id: "54371"', 'id: "x"', "correction-value"),
        ('id: "54371"', 'id: "16777216"', "correction-value"),
        ('id: "54371"', 'id: "0"', "message-conflict"),
        ('id: "54371"', 'id: "42000"', "taken-elsewhere"),
        ('id: "54371"', 'number: "54371"', "correction-attribute"),
        ('id: "54371"', 'wip: "true"', "correction-value"),
        ('id: "54371"', 'wip: ""', "obsolete-correction"),
        ("uint16_t[12]", "uint16_t[126]", "obsolete-correction"),
        ("uint16_t[12]", "uint16_t[0]", "correction-value"),
        ("uint16_t[12]", "uint17_t[12]", "correction-value"),
        (
            "voltages_rfc_0018.xml\n    message: BATTERY_CELL_VOLTAGES\n    field",
            "voltage.xml\n    field",
            "unknown-overlay",
        ),
    ],
)
def test_corrections_that_are_wrong(old: str, new: str, rule: str, check: Check) -> None:
    """Reported in the corrections file; what they no longer repair is found, too."""
    found = check(UPSTREAM, CELLS, corrections_rfc_0018=(old, new))
    assert rule in [name for where, name in found if where.startswith(f"specs/{REPAIRS}:")], found


def test_a_unit_that_nobody_knows(check: Check) -> None:
    """At the field of the overlay, although no table answers it."""
    found = check(UPSTREAM, INFO, battery_info_upstream=('units="g"', 'units="grm"'))
    assert found == [(place(INFO, 'units="g"'), "unknown-unit")]


@pytest.mark.parametrize(
    ("target", "attribute"),
    [("message: BATTERY_STATUS", 'id: "200"'), ("message: BATTERY_STATUS\n    field: id", "type: uint16_t")],
)
def test_the_wire_of_known_messages_cannot_be_corrected(target: str, attribute: str, check: Check) -> None:
    """No receiver would accept them; attributes of their meaning can be set."""
    entry = f"corrections:\n  - {target}\n    set: {{{attribute}}}\n    reason: r\n    source: s\n"
    found = check(UPSTREAM, CELLS, corrections_rfc_0018=("corrections:\n", entry))
    assert [rule for _, rule in found] == ["correction-attribute"]


def test_a_table_for_an_overlay_that_does_not_exist(check: Check) -> None:
    """A misspelt path would leave the message out without a word."""
    old = "message: PROTOCOL_VERSION\n"
    found = check(UPSTREAM, CELLS, protocol_version=(old, f"{old}overlay: dialects/protocol_versions.xml\n"))
    assert found == [("specs/messages/protocol_version.yaml:3:10", "unknown-overlay")]


@pytest.mark.parametrize(
    ("old", "new", "found"),
    [
        ("known: [dialects/upstream.xml]", "known: [dialects/upstreams.xml]", ("specs/codegen.yaml", "file-not-found")),
        ('<message id="371" ', '<message id="37l" ', ("specs/dialects/upstream.xml", "known-messages")),
        ('<message id="371" name="FUEL_STATUS"/>', "<message/>", ("specs/dialects/upstream.xml", "known-messages")),
    ],
)
def test_known_dialects_that_cannot_be_read(old: str, new: str, found: tuple[str, str], check: Check) -> None:
    """A file that is missing, a message without a usable id or name."""
    name = "codegen" if old.startswith("known") else "upstream"
    assert [(where.partition(":")[0], rule) for where, rule in check(UPSTREAM, CELLS, **{name: (old, new)})] == [found]


def test_a_name_that_is_taken(check: Check) -> None:
    """Another message of the project under the name of a dialect that it does not use: a warning where it is defined."""
    old, new = '<message id="300" name="PROTOCOL_VERSION">', '<message id="300" name="UAVIONIX_ADSB_OUT_CFG">'
    found = check(UPSTREAM, CELLS, **{"dialects/protocol_version": (old, new)})
    assert found == [("specs/dialects/protocol_version.xml:5:5", "taken-elsewhere")]
