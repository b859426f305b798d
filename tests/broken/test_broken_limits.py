"""Values of a quantity, a parameter or a constant that a field cannot carry are each reported at their line, with the
limit that would fit. A field's minValue and maxValue count as its type does.

Each case is a project of one message with one field.
"""

import pytest

from codegen.cli import main

MV = 'type="uint16_t" units="mV" invalid="UINT16_MAX"'
UP_TO_20 = 'type="uint16_t" units="mV" maxValue="20000"'
FILES = {
    "codegen.yaml": "project: e\ndialect: minimal\noverlays: [e.xml]\n",
    "board.yaml": "board: pico_2\nfacts:\n  m: {volts: 21 V, cells: 3}\n",
    "streams.yaml": "streams:\n  only: {doc: d., rate: 1 Hz}\n",
    "requirements/FR-1.md": "# FR-1 | T\n\n## Metadata\n\n- Status: Draft\n\n## Acceptance Criteria\n\n1. a.\n",
}
TABLE = "message: E\nrequirement: FR-1.1\nstream: only\nfields:\n  f: "
VOLTS = "unit: V, stored: mV"
ENUMS = (
    '<enum name="GRADE"><entry value="0" name="GRADE_LOW"/><entry value="300" name="GRADE_HIGH"/></enum>'
    '<enum name="MARKS" bitmask="true"><entry value="1" name="MARKS_ONE"/><entry value="256" name="MARKS_NINTH"/></enum>'
)
PAGED = "{page: true}\n  g: {each: m.q}\npages: m.q\nfor_each: m"
PARAMETER = "type: real32, unit: V, default: 5, step: 0.1"


@pytest.fixture
def told(tmp_path, monkeypatch, capsys):
    """Return a call for the output of codegen check: for a field, the quantity m.q, the parameter PAR and the answer."""

    def check(field, quantity, answer, parameter=f"{PARAMETER}, min: 0, max: 10", sensor="", extra=""):
        quantity = f"{{doc: d, {quantity}}}"
        files = FILES | {
            "e.xml": f'<mavlink><enums>{ENUMS}</enums><messages><message id="54440" name="E"><description>d</description><field {field} '
            f'name="f">d{extra}</field></message></messages></mavlink>',
            "state.yaml": f"components:\n  m:\n    doc: d\n    quantities:\n      q: {quantity}\n",
            "parameters.yaml": f"parameters:\n  PAR: {{doc: d, {parameter}}}\n",
            "messages/e.yaml": f"{TABLE}{answer}\n",
            "board.yaml": FILES["board.yaml"] + (f"sources:\n  s: {{driver: user, {sensor}}}\n" if sensor else ""),
        }
        for name, text in files.items():
            path = tmp_path / "specs" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        monkeypatch.chdir(tmp_path)
        main(["check"])
        return capsys.readouterr().out

    return check


@pytest.mark.parametrize(
    ("field", "quantity", "answer", "says"),
    [
        (MV, f"{VOLTS}, min: 0, max: 100", "{state: m.q}", "goes up to 100 V, and f (uint16_t) ends at 65.534 V"),
        (MV, f"{VOLTS}, min: -5, max: 60", "{state: m.q}", "goes down to -5 V, and f (uint16_t) ends at 0 V"),
        (UP_TO_20, f"{VOLTS}, initial: 0, max: 50", "{state: m.q}", "goes up to 50 V, and f (uint16_t) ends at 20 V"),
        (UP_TO_20, f"{VOLTS}, initial: 21", "{state: m.q}", "is initially 21 V, and f (uint16_t) ends at 20 V"),
        (
            'type="uint8_t" minValue="3"',
            "initial: 5, min: 0",
            "{state: m.q}",
            "goes down to 0, and f (uint8_t) ends at 3",
        ),
        (
            'type="float" units="rad" invalid="NaN" maxValue="3.1415"',
            "unit: rad, max: 7",
            "{state: m.q}",
            "goes up to 7 rad, and f (float) ends at 3.1415 rad",
        ),
        (
            'type="int32_t" units="degE7" invalid="INT32_MAX"',
            "unit: deg, stored: degE7, max: 360",
            "{state: m.q}",
            "goes up to 360 deg, and f (int32_t) ends at 214.7483646 deg",
        ),
        (
            'type="uint16_t[2]" units="mV" invalid="[UINT16_MAX]"',
            f"{VOLTS}, min: 0, max: 200",
            "{state: m.q, split: true}",
            "goes up to 200 V, and f (uint16_t) ends at 131.068 V",
        ),
        (
            'type="uint16_t[3]" units="mV" invalid="[UINT16_MAX]"',
            f"{VOLTS}, min: 0, max: 200, elements: cells",
            "{each: m.q}",
            "goes up to 200 V, and f (uint16_t) ends at 65.534 V",
        ),
    ],
)
def test_a_quantity_that_its_field_ends_before(told, field, quantity, answer, says):
    """At the answer; the hint has the limit that fits, in the unit of the quantity."""
    found = told(field, quantity, answer)
    place = f"specs/messages/e.yaml:5:{6 + answer.index('m.q')}: error beyond-field: m.q {says}\n"
    assert place in found
    end = says.rsplit(" at ", 1)[1].split(" ")[0]
    key = "min" if "down" in says else "max"
    assert f"  hint: {key}: {end} at m.q, or here, if the field is to end there\n" in found
    assert "it is declared here" in found


@pytest.mark.parametrize(
    ("field", "quantity", "hint"),
    [
        ('type="int16_t" units="mm/s" invalid="INT16_MIN"', "unit: kn, stored: kn, max: 60, min: -300", "min: -63"),
        ('type="int16_t" units="mm/s" invalid="INT16_MIN"', "unit: kn, stored: kn, min: -60, max: 300", "max: 63"),
        ('type="uint8_t" units="s" invalid="UINT8_MAX"', "unit: h, stored: s, min: 0, max: 1", "max: 0.07"),
    ],
)
def test_the_limit_of_a_hint_can_be_written(told, field, quantity, hint):
    """Where the end of the field is no whole number of steps, or no decimal, in the unit of the quantity."""
    assert f"  hint: {hint} at m.q, or here" in told(field, quantity, "{state: m.q}")
    assert told(field, f"{quantity.rsplit(', ', 1)[0]}, {hint}", "{state: m.q}") == ""


@pytest.mark.parametrize(
    ("field", "quantity", "answer"),
    [
        (MV, VOLTS, "{state: m.q}"),
        (MV, f"{VOLTS}, min: 0, max: 100", "{state: m.q, max: 60 V}"),
        (MV, f"{VOLTS}, min: 0, max: 65.534", "{state: m.q}"),
        (MV, f"{VOLTS}, min: 0, max: 65.535", "{state: m.q}"),  # the sentinel, beside which is a step for it
        ('type="uint16_t" units="V"', f"{VOLTS}, initial: 0, min: 0, max: 65535.4", "{state: m.q}"),
        ('type="float" units="rad" invalid="NaN" maxValue="3.1415"', "unit: rad, max: 3.1415", "{state: m.q}"),
    ],
)
def test_what_a_field_carries_is_no_finding(told, field, quantity, answer):
    """Nor what the table says itself, what is rounded, or what the state keeps beyond limits that nobody declared."""
    assert told(field, quantity, answer) == ""


@pytest.mark.parametrize(("field", "end"), [(MV, "65.534"), (UP_TO_20, "20")])
def test_a_parameter_that_its_field_ends_before(told, field, end):
    """Somebody may set it so at run time."""
    found = told(field, "initial: 0", "{parameter: PAR}", f"{PARAMETER}, min: 0, max: 100")
    assert f"e.yaml:5:18: error beyond-field: PAR goes up to 100 V, and f (uint16_t) ends at {end} V" in found
    assert f"hint: max: {end} at PAR" in found
    assert told(field, "initial: 0", "{parameter: PAR, max: 12 V}", f"{PARAMETER}, min: 0, max: 100") == ""


@pytest.mark.parametrize(
    ("field", "answer", "says"),
    [
        (UP_TO_20, "{constant: 21 V}", "21 V is 21000, but f (uint16_t) carries 0 to 20000"),
        ('type="int16_t" minValue="-20"', "{constant: -21}", "-21 is -21, but f (int16_t) carries -20 to 32767"),
        (
            'type="float" units="V" maxValue="20"',
            "{constant: 21 V}",
            "21 V is 21.0, but f (float) carries -3.402823e+38 to 20",
        ),
        (UP_TO_20, "{board: m.volts}", "21 V is 21000, but f (uint16_t) carries 0 to 20000"),
    ],
)
def test_a_constant_that_its_field_does_not_carry(told, field, answer, says):
    """At the key that names it."""
    found = told(field, "initial: 0", answer)
    assert f"specs/messages/e.yaml:5:{6 + answer.index(':') + 2}: error constant-out-of-range: {says}" in found
    assert "f is declared here" in found


@pytest.mark.parametrize(
    ("field", "quantity", "answer", "is_coarse"),
    [
        (MV, "unit: V, min: 0, max: 60", "{state: m.q}", False),  # it is kept in mV
        ('type="uint16_t[3]" units="mV" invalid="[UINT16_MAX]"', "unit: V, elements: cells", "{each: m.q}", True),
        (
            'type="uint16_t[3]" units="mV" invalid="[UINT16_MAX]"',
            "unit: V, stored: V, elements: cells",
            "{each: m.q}",
            False,
        ),
        ('type="uint16_t[2]" units="mV" invalid="[UINT16_MAX]"', "unit: V", "{state: m.q, split: true}", True),
    ],
)
def test_a_quantity_that_is_kept_more_coarsely_than_its_field(told, field, quantity, answer, is_coarse):
    """A warning at the quantity, with what to write, unless it says itself how finely it is kept."""
    found = told(field, quantity, answer)
    assert ("specs/state.yaml:5:7: warning coarse-quantity: m.q is kept in whole V" in found) == is_coarse
    assert "error" not in found


@pytest.mark.parametrize(
    ("field", "answer", "hint"),
    [
        ('type="int16_t" units="m" invalid="INT16_MAX"', "{state: m.q}", "E.f leaves -32768000 to 32766000 mm\n"),
        ('type="int16_t" units="m"', "{state: m.q, min: -9}", "E.f leaves any number to 32767000 mm\n"),
        ('type="int16_t" units="m"', "{state: m.q, max: 30000, min: -9}", None),
        ('type="int32_t" units="mm"', "{state: m.q}", None),
    ],
)
def test_a_sensor_that_passes_what_a_field_carries(told, field, answer, hint):
    """The field is named, with all digits of what it leaves: the balloon is at 38 km."""
    sensor = "class: s.S, unit: m, stored: mm, min: -40000, max: 90000"
    found = told(field, "unit: m, stored: mm, source: s, invalid_after: 3, initial: 0", answer, sensor=sensor)
    assert ("source-beyond-limits: s gives m.q -40000000 to 90000000 mm" in found) == (hint is not None), found
    assert hint is None or (hint in found and "hint: write min and max at E.f: limited on purpose, or narrow" in found)


@pytest.mark.parametrize(
    ("field", "quantity", "output", "hint"),
    [
        ('type="float" units="rad" invalid="NaN"', "unit: rad", "unit: rad, min: -4, max: 4", "stored: urad"),
        ('type="float" units="rad" invalid="NaN"', "unit: rad", "unit: rad", "stored: mrad"),
        (
            'type="float" units="rad" invalid="NaN"',
            "unit: rad, stored: mrad",
            "unit: rad, min: -4, max: 4",
            "stored: urad",
        ),
        ('type="float" units="rad" invalid="NaN"', "unit: rad", "unit: rad, stored: mrad", None),
        ('type="float" units="rad" invalid="NaN"', "unit: rad", "unit: rad, stored: rad", None),
        (MV, "unit: V", "unit: V, min: 0, max: 60", "stored: mV"),
        (MV, "unit: mV", "unit: V, min: 0, max: 60", "stored: mV"),
        (MV.replace("mV", "cV"), "unit: V", "unit: V, min: 0, max: 60", "stored: cV"),  # so that it is rounded once
        (MV, "unit: mV", "unit: mV, min: 0, max: 60000", None),  # the field has no finer steps
        ('type="uint16_t" multiplier="1E-2" invalid="UINT16_MAX"', "stale_after: 1 s", "min: 0, max: 99", "unit with"),
        ('type="uint8_t" invalid="UINT8_MAX"', "stale_after: 1 s", "min: 0, max: 99", None),
    ],
)
def test_a_number_that_code_gives_and_that_is_rounded_to_whole_units(told, field, quantity, output, hint):
    """A warning at the output, whose read() gives a float: an angle in rad would be 0 or 57.3 degrees."""
    found = told(field, f"{quantity}, source: s", "{state: m.q}", sensor=f"class: s.S, {output}")
    assert ("specs/board.yaml:5:3: warning coarse-quantity: s is rounded to whole" in found) == (hint is not None)
    assert hint is None or f"hint: {hint}" in found or f"hint: give the output a {hint} steps" in found
    assert "error" not in found


@pytest.mark.parametrize(("unit", "is_told"), [("kn", True), ("km/h", False), ("m/s", True)])
def test_an_output_in_coarser_steps_than_its_quantity(told, unit, is_told):
    """However little coarser they are: some steps of the quantity are never kept."""
    sensor = f"class: s.S, unit: {unit}, stored: {unit}, min: 0, max: 50"
    quantity = "unit: km/h, stored: km/h, source: s"
    found = told('type="float" units="m/s" invalid="NaN"', quantity, "{state: m.q}", sensor=sensor)
    assert (f"s is rounded to whole {unit}, and m.q is kept in km/h" in found) == is_told, found


@pytest.mark.parametrize(
    ("field", "quantity", "answer", "says"),
    [
        (
            'type="uint8_t" enum="GRADE" invalid="UINT8_MAX"',
            "enum: GRADE",
            "{state: m.q}",
            "beyond-field: m.q goes up to 300",
        ),
        (
            'type="uint8_t" enum="MARKS"',
            "enum: MARKS, initial: MARKS_ONE",
            "{state: m.q}",
            "beyond-field: m.q goes up to 257",
        ),
        ('type="uint16_t" enum="GRADE"', "enum: GRADE, initial: GRADE_LOW", "{state: m.q}", None),
        ('type="uint16_t" enum="MARKS"', "enum: MARKS, initial: MARKS_ONE", "{state: m.q}", None),
        (
            'type="float" enum="MARKS"',
            "boolean: true, initial: false",
            "{flags: [MARKS_ONE if m.q]}",
            "not-an-enum-field: f (float) is no",
        ),
        ('type="uint16_t" enum="MARKS"', "boolean: true, initial: false", "{flags: [MARKS_ONE if m.q]}", None),
        (
            'type="float"',
            "initial: 0",
            "{constant: 1e39}",
            "is 1e+39, but f (float) carries -3.402823e+38 to 3.402823e+38",
        ),
        ('type="double"', "initial: 0", "{constant: 1e309}", "is inf, but f (double) carries -1.797693e+308 to"),
        ('type="double"', "initial: 0", "{constant: 1e39}", None),
        ('type="float"', "initial: 1e39", "{state: m.q}", "beyond-storage: initial of q is beyond 3.402823e+38"),
        ('type="float"', "max: 1e39", "{state: m.q}", "beyond-storage: max of q is beyond 3.402823e+38"),
    ],
)
def test_a_number_that_no_field_of_its_kind_has(told, field, quantity, answer, says):
    """An entry of an enum beyond its field, which went out as the sentinel; bits of a float; what no float is."""
    out = told(field, quantity, answer)
    assert says in out if says else "error" not in out, out


PERCENT = 'type="int8_t" units="%" invalid="-1"'


@pytest.mark.parametrize(
    ("field", "quantity", "answer", "parameter", "says"),
    [
        (
            PERCENT,
            'unit: "%", min: -1, initial: -1',
            "{state: m.q}",
            "",
            "m.q is initially -1 %, which means unknown in f",
        ),
        (MV, f"{VOLTS}, initial: 65.535", "{state: m.q}", "", "m.q is initially 65.535 V, which means unknown in f"),
        (PERCENT, 'unit: "%", min: -1, initial: -1', "{state: m.q, min: 0}", "", None),
        (PERCENT, 'unit: "%", initial: 0', "{state: m.q}", "", None),
        (
            'type="uint64_t" invalid="UINT64_MAX"',
            "initial: 18446744073709551615, max: 18446744073709551615",
            "{state: m.q}",
            "",
            "means unknown",
        ),
        (
            'type="uint16_t" enum="GRADE" invalid="GRADE_LOW"',
            "enum: GRADE, initial: GRADE_LOW",
            "{state: m.q}",
            "",
            None,
        ),
        (
            PERCENT,
            VOLTS,
            "{parameter: PAR}",
            "unit: '%', min: -1, max: 9, step: 1, default: -1",
            "PAR is by default -1 %",
        ),
        (PERCENT, VOLTS, "{parameter: PAR}", "unit: '%', min: -1, max: 9, step: 1, default: 1", None),
    ],
)
def test_what_stands_in_at_first_does_not_mean_unknown(told, field, quantity, answer, parameter, says):
    """An initial value or a default that is the sentinel goes out as the number beside it: it is an error.

    An entry of an enum says what it says, and a limit of the table says what goes out.
    """
    out = told(field, quantity, answer, **({"parameter": parameter} if parameter else {}))
    assert ("sentinel-as-initial" in out) == (says is not None), out
    assert says is None or says in out, out


@pytest.mark.parametrize(
    ("field", "answer", "says"),
    [
        ('type="uint8_t"', "{state: m.instance}\nfor_each: m", None),
        ('type="uint8_t" minValue="1"', "{state: m.instance}\nfor_each: m", "f cannot carry an instance number"),
        ('type="uint8_t" invalid="0"', "{state: m.instance}\nfor_each: m", "f cannot carry an instance number"),
        ('type="uint8_t" invalid="UINT8_MAX"', "{state: m.instance}\nfor_each: m", None),
        ('type="uint8_t" maxValue="1"', PAGED, "f cannot carry the number 2, the first of the last page"),
        ('type="uint8_t" maxValue="2"', PAGED, None),
        ('type="uint8_t" invalid="0"', PAGED, "f cannot carry the numbers of pages, 0 to 2"),
        ('type="uint8_t" invalid="1"', PAGED, None),
    ],
)
def test_what_the_program_counts_is_carried(told, field, answer, says):
    """The dialect's limits and its number for unknown hold for numbers of instances and of pages, too."""
    two = '</field><field type="uint8_t[2]" name="g" invalid="[UINT8_MAX]">d'
    out = told(field.replace("/>", ""), "elements: cells", answer, extra=two if answer == PAGED else "")
    assert (out == "") == (says is None), out
    assert says is None or says in out, out
