"""What a field cannot mean is told where it is known: entries, lengths of arrays, and texts without their end.

Each case is a project of one message, or two fields of one.
"""

from pathlib import Path

import pytest

from codegen.cli import main
from codegen.diagnostics import Report
from codegen.model.dialect.stated_length import stated_lengths
from codegen.project.systems import read_systems

ENUMS = (
    '<enum name="GRADE"><entry value="1" name="GRADE_LOW"/><entry value="3" name="GRADE_HIGH"/></enum>'
    '<enum name="MARKS" bitmask="true"><entry value="1" name="MARKS_ONE"/><entry value="4" name="MARKS_THIRD"/></enum>'
)
FILES = {
    "codegen.yaml": "project: e\ndialect: minimal\noverlays: [e.xml]\n",
    "board.yaml": "board: pico_2\nfacts:\n  m: {name: ABCDEFGH}\n",
    "streams.yaml": "streams:\n  only: {doc: d., rate: 1 Hz}\n",
    "requirements/FR-1.md": "# FR-1 | T\n\n## Metadata\n\n- Status: Draft\n\n## Acceptance Criteria\n\n1. a.\n",
}
TABLE = "message: E\nrequirement: FR-1.1\nstream: only\nsend: while_known\nfields:\n  f: "
RULES = ("not-an-enum-value", "beyond-entries", "length-beyond-data", "unterminated-text", "cut-initial-text")
GRADE, MARKS = 'type="uint8_t" enum="GRADE"', 'type="uint8_t" enum="MARKS" display="bitmask"'
CHARS = 'type="char[8]"'
DATA = '<field type="uint8_t[6]" name="data">d</field>'
LENGTH = 'type="uint8_t" units="bytes"'
BYTES = "unit: bytes"


@pytest.fixture
def told(tmp_path, monkeypatch, capsys):
    """Return a call for the findings of these rules: for a field, its words, the quantity m.q and the answer."""

    def check(field, words, quantity, answer, parameter="type: uint8, default: 3, min: 1, max: 3, step: 1"):
        name = "len" if field == LENGTH else "f"
        message = (
            f'<message id="54440" name="E"><description>d</description><field {field} name="{name}">{words}</field>'
            f"{DATA if field == LENGTH else ''}</message>"
        )
        table = TABLE.replace("  f:", "  data: {constant: 0}\n  len:") if field == LENGTH else TABLE
        is_known = "initial" in quantity or "{state" not in answer
        files = FILES | {
            "e.xml": f"<mavlink><enums>{ENUMS}</enums><messages>{message}</messages></mavlink>",
            "state.yaml": f"components:\n  m:\n    doc: d\n    quantities:\n      q: {{doc: d, {quantity}}}\n",
            "parameters.yaml": f"parameters:\n  PAR: {{doc: d, {parameter}}}\n",
            "messages/e.yaml": f"{table.replace('send: while_known' + chr(10), '') if is_known else table}{answer}\n",
        }
        for path, text in files.items():
            (tmp_path / "specs" / path).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / "specs" / path).write_text(text)
        monkeypatch.chdir(tmp_path)
        main(["check"])
        out = capsys.readouterr().out.splitlines()
        found = [
            " ".join(out[at : at + 2]) for at, line in enumerate(out) if any(f" {rule}:" in line for rule in RULES)
        ]
        assert len([line for line in out if ": error " in line]) == sum(": error " in line for line in found), out
        return found

    return check


STATE, PAR = "{state: m.q}", "{parameter: PAR}"
TOLD = [
    (GRADE, "d", "initial: 2, min: 1, max: 3", STATE, "error not-an-enum-value: f is m.q, initially 2, which is no"),
    (GRADE, "d", "min: 1, max: 4", STATE, "warning beyond-entries: f is a GRADE, and m.q goes up to 4, and GRADE_HIGH"),
    (
        GRADE,
        "d",
        "min: 0, max: 3",
        STATE,
        "m.q goes down to 0, and GRADE_LOW is 1   hint: limits of m.q from 1 to 3, or",
    ),
    (MARKS, "d", "initial: 2, min: 0, max: 5", STATE, "error not-an-enum-value: f is m.q, initially 2"),
    (LENGTH, "d", BYTES, "{constant: 7}", "warning length-beyond-data: len is 7, and E.data has 6   hint: 6 bytes at"),
    (LENGTH, "d", f"{BYTES}, min: 0, max: 7", STATE, "m.q makes len up to 7, and E.data has 6"),
    (LENGTH, "d", "unit: bits, min: 0, max: 56", STATE, "m.q makes len up to 7, and E.data has 6"),
    (CHARS, "Its name, 0 terminated.", "max: 1", "{constant: ABCDEFGH}", "unterminated-text: 'ABCDEFGH' takes all 8"),
    (CHARS, "Null-terminated name", "max: 1", "{board: m.name}", "unterminated-text: 'ABCDEFGH' takes all 8 bytes"),
    (CHARS, "7+null", "text: 8, initial: a", STATE, "m.q can take all 8 bytes of E.f, whose words say '7+null'"),
    (CHARS, "7 + NUL", "text: 8, initial: a", STATE, "hint: text: 7 at m.q"),
    (CHARS, "d", "text: 9, initial: ABCDEFGHI", STATE, "cut-initial-text: m.q is initially 'ABCDEFGHI', 9 bytes, and"),
]


@pytest.mark.parametrize(("field", "words", "quantity", "answer", "says"), TOLD, ids=range(len(TOLD)))
def test_what_no_receiver_takes_as_it_is_meant_is_told(told, field, words, quantity, answer, says):
    """Each is one finding, whether a constant, a fact or a quantity says it."""
    (found,) = told(field, words, quantity, answer)
    assert says in found


@pytest.mark.parametrize(
    ("parameter", "says"),
    [
        ("type: uint8, default: 2, min: 1, max: 3, step: 1", "not-an-enum-value: f is PAR, by default 2, which is no"),
        ("type: uint8, default: 3, min: 1, max: 9, step: 1", "beyond-entries: f is a GRADE, and PAR goes up to 9"),
    ],
)
def test_what_a_parameter_is_by_default_and_at_its_ends(told, parameter, says):
    """Nobody has to set it for that."""
    (found,) = told(GRADE, "d", "max: 1", PAR, parameter)
    assert says in found


RIGHT = [
    (GRADE, "d", "initial: 3, min: 1, max: 3", STATE),
    (GRADE, "d", "max: 1", PAR),
    (GRADE, "d", "initial: 3", STATE),  # nothing is declared
    (GRADE, "d", "initial: 1, min: 0, max: 9", "{state: m.q, min: 1, max: 3}"),
    (GRADE, "Numbers greater than 3 are private.", "min: 1, max: 200", STATE),
    (GRADE, "d", "enum: GRADE", STATE),
    (MARKS, "d", "initial: 5, min: 0, max: 7", STATE),
    (LENGTH, "d", BYTES, "{constant: 6}"),
    (LENGTH, "d", f"{BYTES}, min: 0, max: 6", STATE),
    (LENGTH, "d", f"{BYTES}, min: 0, max: 9", "{state: m.q, max: 6}"),
    (CHARS, "Its name, 0 terminated.", "max: 1", "{constant: ABCDEFG}"),
    (CHARS, "Terminated by NULL, WITHOUT null termination if it has 8.", "text: 8, initial: a", STATE),
    (CHARS, "Filled with nulls.", "text: 9, initial: ABCDEFGH", STATE),
    (CHARS, "7+null", "text: 7, initial: a", STATE),
]


@pytest.mark.parametrize(("field", "words", "quantity", "answer"), RIGHT, ids=range(len(RIGHT)))
def test_what_is_right_is_not(told, field, words, quantity, answer):
    """Entries, what a table limits on purpose, what a description leaves free, and what has room."""
    assert told(field, words, quantity, answer) == []


def test_the_lengths_of_arrays_that_common_has():
    """All that is found in common.xml, and has been read there; a length of several pages is none of one."""
    specs = Path(__file__).resolve().parents[1] / "projects" / "satellites" / "specs"
    (system, *_) = read_systems(str(specs / "codegen.yaml"), Report())
    found = {
        f"{message.name}.{name}": array.name
        for message in system.dialect.messages.values()
        for name, array in stated_lengths(message.fields).items()
    }
    assert found == {
        "LOG_DATA.count": "data",
        "GPS_INJECT_DATA.len": "data",
        "SERIAL_CONTROL.count": "data",
        "GPS_RTCM_DATA.len": "data",
        "LOGGING_DATA.length": "data",
        "LOGGING_DATA_ACKED.length": "data",
        "TUNNEL.payload_length": "payload",
        "CAN_FRAME.len": "data",
        "CANFD_FRAME.len": "data",
    }
