"""The corrections that come with codegen: quoted from the installed pymavlink, complete, and subject to the project."""

import re
import shutil
import zlib
from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path
from types import SimpleNamespace

import pytest
import yaml

from codegen.decode.dialect.files import decode_dialect_files
from codegen.decode.shipped_corrections import FOLDER, shipped_corrections
from codegen.diagnostics import Report
from codegen.explain.corrections import line_of
from codegen.explain.story import explain
from codegen.load.files import DISK
from codegen.load.shipped import dialects_in, shipped_dialect_names, shipped_dialect_path
from codegen.model.dialect.dialect import AttributeCorrection, Dialect, DialectFile, SentinelForm, Standing
from codegen.model.dialect.literals import LIMITS
from codegen.model.spec.spec import Correction, Refusal, ShippedCorrection
from codegen.model.units.unit import Unit
from codegen.project.systems import read_system
from codegen.resolve.dialect.dialect import resolve_dialect
from codegen.resolve.dialect.patterns import matching
from codegen.source import Place
from tests.dialect.candidate_phrases import candidates

LOOKED_AT = Path(__file__).with_name("looked_at.yaml")
HERE = Place("/corrections.yaml", 3, 5)
FILES = sorted(Path(FOLDER).glob("*.yaml"))


def read(name: str) -> tuple[Dialect, tuple[DialectFile, ...], tuple[ShippedCorrection, ...]]:
    """A shipped dialect with nothing but the corrections that come with codegen."""
    report = Report()
    files = decode_dialect_files(str(shipped_dialect_path(name, DISK)), DISK, report)
    shipped = shipped_corrections(files, DISK, report)
    dialect = resolve_dialect(name, files, (), report, shipped)
    assert not list(report)
    return dialect, files, shipped


@pytest.fixture(scope="module")
def dialects() -> dict[str, tuple[Dialect, tuple[DialectFile, ...], tuple[ShippedCorrection, ...]]]:
    return {name: read(name) for name in shipped_dialect_names(DISK)}


def own(path: Path, name: str) -> tuple[Dialect, tuple[ShippedCorrection, ...]]:
    """A dialect and what the file of corrections states for it, without those of what it includes."""
    dialect, _, shipped = read(name)
    return dialect, tuple(one for one in shipped if one.place.file == str(path))


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_correction_holds_for_the_installed_release(path: Path) -> None:
    """Each is applied to every field of its pattern, and its words stand on a line of the XML that can be named."""
    dialect, shipped = own(path, path.stem)
    assert shipped
    for correction in shipped:
        fields = matching(correction.fields, [field.name for field in dialect.messages[correction.message].fields])
        done = {(one.part, one.attribute): one for one in dialect.corrections if one.place == correction.place}
        assert fields, correction
        assert set(done) == {(field, attribute) for field in fields for attribute in correction.set}
        assert {one.standing for one in done.values()} == {Standing.APPLIED}
        for one in done.values():
            check_words(one)


def check_words(one: AttributeCorrection) -> None:
    """The line on which the words begin; and they name the value, at least as its number or its unit is written."""
    assert one.stated is not None
    place = line_of(one.grounds, one.stated)
    line = Path(place.file).read_text(encoding="utf-8").splitlines()[place.line - 1]
    assert one.grounds in " ".join(line.split()).replace("&lt;", "<"), one
    words = one.grounds.lower()
    if one.attribute == "invalid":
        text = one.text.strip("[]")
        number = {"0": ["0", "zero"], "MAV_TUNNEL_PAYLOAD_TYPE_UNKNOWN": ["0 for unknown"]}.get(text, [text.lower()])
        assert any(word in words for word in [*number, str(LIMITS.get(text, text)).lower()]), one
    elif one.attribute == "multiplier":
        assert str(int(1 / Fraction(one.text))) in words.replace("1e2", "100"), one
    elif one.attribute in ("unchanged", "unknown"):
        parts = one.text.replace(" ", "").lower().split(",")
        assert all(re.search(rf"\b{'(?:0|zero)' if part == '0' else part}\b(?!-)", words) for part in parts), one
    else:
        assert Unit.parse(one.text) is not None, one


UNIT_WORDS = {
    "%": "percent",
    "c%": "(100%) 10000",
    "rpm": "rpm",
    "s": "seconds",
    "us": "microseconds",
    "ms": "milliseconds",
    "mm": "millimeters",
    "cm/s": "cm/s",
    "deg": "degrees",
    "mAh": "milli amp hours",
    "degC": "temperature in c",
    "bytes/s": "bytes/s",
    "l/h": "litres/hour",
}


def test_every_unit_is_named_in_words() -> None:
    """The millimetres of a barometric altitude are the one that is written as a factor of metres."""
    units = [(one, one.text) for path in FILES for one in read(path.stem)[0].corrections if one.attribute == "units"]
    assert len({text for _, text in units}) == len(UNIT_WORDS)
    for one, text in units:
        assert UNIT_WORDS[text] in one.grounds.lower() or one.grounds == "altitude (m * 1E-3)", one


def found_phrases(dialects: dict) -> Iterator[tuple[str, str]]:
    """Each phrase of the dialects that may state something, with its text, for which there is no correction."""
    for dialect, files, _ in dialects.values():
        corrected = {(one.attribute, one.owner, one.part) for one in dialect.corrections}
        by_message = {
            (one.attribute, one.owner) for one in dialect.corrections if one.stated and is_message(one, dialect)
        }
        for message in (message for file in files for message in file.messages):
            for one in candidates(message):
                fields = {field.name: field for field in message.fields}
                text = message.description if one.field == "*" else fields[one.field].description
                is_done = (one.kind, one.message) in by_message if one.field == "*" else one[:3] in corrected
                if not is_done:
                    yield f"{one.kind} {one.name}", f"{zlib.crc32(text.encode()):08x}"


def is_message(one: AttributeCorrection, dialect: Dialect) -> bool:
    return one.stated == dialect.messages[one.owner].definition.place


def test_every_phrase_is_corrected_or_was_looked_at(dialects: dict) -> None:
    """Another release of pymavlink with other words fails here, until somebody has read them."""
    looked_at = yaml.safe_load(LOOKED_AT.read_text(encoding="utf-8"))
    assert all(entry["reason"] for entry in looked_at)
    listed = [pair for entry in looked_at for pair in entry["phrases"].items()]
    assert len(listed) == len(dict(listed)), "each phrase once"
    found = set(found_phrases(dialects))
    assert not found - set(listed), "correct it, or list it with the reason why not"
    assert not set(listed) - found, "no longer there, or corrected by now"


def test_sentinels_of_what_is_sent_most(dialects: dict) -> None:
    """Of each kind one, and how many channels of a radio there are."""
    dialect = dialects["all"][0]
    sentinels = {
        "RC_CHANNELS.chan18_raw": (65535,),
        "RC_CHANNELS.rssi": (255,),
        "BATTERY_STATUS.time_remaining": (0,),
        "SCALED_IMU.temperature": (0,),
        "MANUAL_CONTROL.x": (32767,),
        "BATTERY2.current_battery": (-1,),
        "OPEN_DRONE_ID_LOCATION.speed_vertical": (6300,),
        "EXTENDED_SYS_STATE.landed_state": (0,),
    }
    for name, values in sentinels.items():
        message, _, field = name.partition(".")
        assert dialect.messages[message].field(field).sentinel.values == values, name
    missing_cells = dialect.messages["BATTERY_STATUS"].field("voltages_ext").sentinel
    assert (missing_cells.form, missing_cells.values) == (SentinelForm.EACH, (0, 0, 0, 0))
    assert dialect.messages["GPS2_RAW"].field("eph").definition.multiplier == "1E-2"
    assert len([one for one in dialect.corrections if one.owner == "RC_CHANNELS"]) == 19


WORDS = "A value of UINT16_MAX implies the channel is unused."
RC = """<mavlink><messages><message id="65" name="RC_CHANNELS"><description>{}</description>
<field type="uint16_t" name="chan1_raw" {}>RC channel 1 value.</field>
<field type="uint16_t" name="chan2_raw">RC channel 2 value.</field>
<field type="uint8_t" name="rssi">255: invalid/unknown</field>
</message></messages></mavlink>"""


@pytest.fixture
def resolved(tmp_path: Path) -> Callable[..., SimpleNamespace]:
    """Resolve a ``common.xml`` of these words as if pymavlink shipped it."""

    def resolve(
        description: str = WORDS, attribute: str = "", own: tuple = (), refuse: tuple = (), is_shipped: bool = True
    ) -> SimpleNamespace:
        path = tmp_path / "common.xml"
        path.write_text(RC.format(description, attribute), encoding="utf-8")
        report = Report()
        files = DISK.with_dialects({"common": str(path)} if is_shipped else {})
        found = decode_dialect_files(str(path), files, report)
        shipped = shipped_corrections(found, files, report)
        dialect = resolve_dialect("common", found, own, report, shipped, refuse)
        message = dialect.messages["RC_CHANNELS"]
        written = {field.name: field.definition.invalid for field in message.fields}
        standing = {one.part: one.standing for one in dialect.corrections}
        return SimpleNamespace(written=written, standing=standing, report=list(report), dialect=dialect)

    return resolve


def refusals(*targets: tuple[str, str]) -> tuple[Refusal, ...]:
    return tuple(Refusal(message=message, fields=fields, reason="no", place=HERE) for message, fields in targets)


def correction(**keys: object) -> Correction:
    return Correction(**{"reason": "why", "source": "where", "place": HERE, "message": "RC_CHANNELS", **keys})


def test_words_that_are_gone_correct_nothing(resolved: Callable) -> None:
    """Of two corrections one quotes the message, which says something else now; the other goes on to hold."""
    found = resolved("A value of UINT16_MAX implies that the channel is failing.")
    assert found.written == {"chan1_raw": None, "chan2_raw": None, "rssi": "UINT8_MAX"}
    assert found.standing["chan1_raw"] is Standing.OUTDATED
    assert found.report == [], "reported by a rule, where the message is sent"


def test_an_attribute_of_the_dialect_goes_first(resolved: Callable) -> None:
    found = resolved(attribute='invalid="0"')
    assert found.written == {"chan1_raw": "0", "chan2_raw": "UINT16_MAX", "rssi": "UINT8_MAX"}
    assert found.report == []


def test_a_correction_of_the_project_goes_first(resolved: Callable) -> None:
    """The project's own correction holds, the same or not, and without a finding."""
    found = resolved(own=(correction(field="chan2_raw", set={"invalid": "0"}),))
    assert found.written == {"chan1_raw": "UINT16_MAX", "chan2_raw": "0", "rssi": "UINT8_MAX"}
    same = resolved(own=(correction(fields="chan*_raw", set={"invalid": "UINT16_MAX"}),))
    assert same.written["chan2_raw"] == "UINT16_MAX"
    assert [one.source for one in same.dialect.corrections_of("RC_CHANNELS", "chan2_raw")] == ["where"]
    assert found.report == same.report == []


def test_a_project_refuses(resolved: Callable) -> None:
    """Some fields, or all of a message; what nothing corrects cannot be refused."""
    refusal = Refusal(message="RC_CHANNELS", fields="chan?_raw", reason="our receiver", place=HERE)
    found = resolved(refuse=(refusal,))
    assert found.written == {"chan1_raw": None, "chan2_raw": None, "rssi": "UINT8_MAX"}
    assert found.standing["chan2_raw"] is Standing.REFUSED
    assert found.report == []
    every = resolved(refuse=(Refusal(message="RC_CHANNELS", reason="our receiver", place=HERE),))
    assert set(every.written.values()) == {None}
    wrong = resolved(refuse=refusals(("RC_CHANNEL", "rssi"), ("RC_CHANNELS", "rsi")))
    assert [(one.rule.id, one.place, one.hint) for one in wrong.report] == [
        ("refusal-unknown", HERE, "did you mean RC_CHANNELS?"),
        ("refusal-unknown", HERE, "did you mean rssi?"),
    ]


def test_xml_of_the_project_has_corrections_of_its_own_only(resolved: Callable) -> None:
    found = resolved(is_shipped=False)
    assert set(found.written.values()) == {None}
    assert found.standing == {}


def test_a_pattern_corrects_many_fields(resolved: Callable) -> None:
    """Those that state it already are left; none at all, or a pattern of no field, is reported once."""
    refuse = (Refusal(message="RC_CHANNELS", reason="tested by itself", place=HERE),)
    one = resolved(attribute='units="us"', own=(correction(fields="chan*", set={"units": "us"}),), refuse=refuse)
    units = [field.definition.units for field in one.dialect.messages["RC_CHANNELS"].fields]
    assert (units, one.report) == (["us", "us", None], [])
    none = resolved(own=(correction(fields="chn*_raw", set={"units": "us"}),))
    assert [(each.rule.id, each.hint) for each in none.report] == [
        ("correction-unknown", "did you mean chan2_raw or chan1_raw?")
    ]
    again = resolved(own=(correction(fields="chan*", set={"units": ""}),))
    assert [each.rule.id for each in again.report] == ["obsolete-correction"]
    both = resolved(own=(correction(fields="chan*", field="rssi", set={"units": "us"}),))
    assert [each.rule.id for each in both.report] == ["correction-target"]
    twice = (correction(fields="chan*", set={"units": "us"}), correction(field="chan1_raw", set={"units": "ms"}))
    assert "obsolete-correction" not in [each.rule.id for each in resolved(own=twice).report]


ROVER = Path(__file__).parents[2] / "specs" / "codegen.yaml"


def test_a_project_hears_of_words_that_are_gone(tmp_path: Path) -> None:
    """One warning for a message that it sends, at the field; and what explain says then."""
    folder = tmp_path / "v20"
    folder.mkdir()
    for name in shipped_dialect_names(DISK):
        text = Path(str(shipped_dialect_path(name, DISK))).read_text(encoding="utf-8")
        changed = text.replace("Battery weight. 0: field not provided.", "Battery weight. 0: it flies by itself.")
        (folder / f"{name}.xml").write_text(changed.replace("0: Not supported/available", "0: nil"), encoding="utf-8")
    report = Report()
    files = DISK.with_dialects(dialects_in(str(folder), DISK, report))
    system = read_system(str(ROVER), report, files)
    assert system is not None
    field = system.dialect.messages["SMART_BATTERY_INFO"].field("weight")
    assert field.sentinel is None
    (finding,) = [one for one in report if one.rule.id == "outdated-correction"]
    assert finding.place == field.definition.place
    assert finding.message == (
        "SMART_BATTERY_INFO.weight no longer says '0: field not provided', so invalid is not corrected to 0"
    )
    story = explain("SMART_BATTERY_INFO.weight", system, report)
    assert "not used     invalid: 0 in place of nothing" in story
    assert "because      the dialect no longer says '0: field not provided'" in story


def test_explain_names_the_words_and_their_line() -> None:
    """Of what no table populates, too; an unknown field of such a message is no topic."""
    report = Report()
    system = read_system(str(ROVER), report)
    xml = Path(str(shipped_dialect_path("common", DISK)))
    story = explain("rc_channels.chan5_raw", system, report)
    (line,) = re.findall(rf'in words     "{re.escape(WORDS)}"  \(.*common\.xml:(\d+):1\)', story)
    assert WORDS in " ".join(xml.read_text(encoding="utf-8").splitlines()[int(line) - 1].split())
    assert re.search(r"corrected    invalid: UINT16_MAX in place of nothing  \(.*common\.yaml:\d+:\d+\)", story)
    assert not list(report)
    assert explain("RC_CHANNELS.chan99_raw", system, report) is None
    assert [one.rule.id for one in report] == ["unknown-topic"]


def test_a_refusal_in_a_file_of_the_project(tmp_path: Path) -> None:
    """explain tells the reason and where it stands; the correction is not applied."""
    specs = tmp_path / "specs"
    shutil.copytree(ROVER.parent, specs)
    refusal = "refuse:\n  - {message: RC_CHANNELS, fields: chan*_raw, reason: Our receiver sends 65535 us.}\n"
    path = specs / "dialects" / "corrections_rfc_0018.yaml"
    path.write_text(refusal + path.read_text(encoding="utf-8"), encoding="utf-8")
    report = Report()
    system = read_system(str(specs / "codegen.yaml"), report)
    story = explain("RC_CHANNELS.chan5_raw", system, report)
    assert "unknown      no sentinel" in story
    assert "refused      invalid: UINT16_MAX in place of nothing" in story
    assert f"because      Our receiver sends 65535 us.  ({path}:2:5)" in story
    assert not [one for one in report if one.is_error]
