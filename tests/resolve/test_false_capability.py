"""What AUTOPILOT_VERSION and HEARTBEAT tell of the program has to hold of it, or stations speak another protocol."""

import shutil
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.project.systems import read_system
from codegen.rules.false_capability import check

SPECS = Path(__file__).resolve().parents[1] / "projects" / "guarded" / "specs"
VERSION = Path(__file__).resolve().parents[2] / "specs" / "messages" / "autopilot_version.yaml"
MISSION = "receive: MISSION_COUNT\nrequirement: FR-501.1\nfields: {count: {state: plan.count}}\n"
GENERIC, ARDUPILOT, PX4, INVALID, RESERVED = (
    f"{{enum: MAV_AUTOPILOT_{name}}}" for name in ("GENERIC", "ARDUPILOTMEGA", "PX4", "INVALID", "RESERVED")
)


def found(
    folder: Path,
    autopilot: str = INVALID,
    encoding: str = "c_cast",
    flags: str | None = None,
    *,
    types: str = "as they are",
    receives: str = "",
) -> list[tuple[str, str]]:
    """What is said of a project with that autopilot and encoding, and these capabilities: message and hint."""
    specs = folder / "specs"
    shutil.copytree(SPECS, specs)
    heartbeat = specs / "messages" / "heartbeat.yaml"
    heartbeat.write_text(heartbeat.read_text().replace(GENERIC, autopilot))
    parameters = specs / "parameters.yaml"
    text = parameters.read_text().replace("encoding: bytewise", f"encoding: {encoding}")
    if types == "real32":
        for kind in ("uint8", "int8", "uint16", "int16", "uint32", "int32"):
            text = text.replace(f" type: {kind},", "")
    if types == "none":
        text = f"encoding: {encoding}\n"
    parameters.write_text(text)
    if flags is not None:
        version = VERSION.read_text().replace("FR-00070.2", "FR-501.1")
        head, _, rest = version.partition("  capabilities:\n")
        rest = rest[rest.index("  flight_sw_version:") :]
        (specs / "messages" / "autopilot_version.yaml").write_text(f"{head}  capabilities: {flags}\n{rest}")
    if receives:
        (specs / "receives").mkdir()
        (specs / "receives" / "mission_count.yaml").write_text(receives)
        state = specs / "state.yaml"
        state.write_text(
            state.read_text() + "  plan:\n    quantities:\n      count: {doc: Of what is to come., min: 0, max: 100}\n"
        )
    report = Report()
    system = read_system(str(specs / "codegen.yaml"), report)
    assert system is not None, [each.message for each in report]
    findings = list(check(system))
    assert all((each.rule.id, each.is_error) == ("false-capability", True) for each in findings)
    assert all(each.place.file.startswith(str(specs / "messages")) for each in findings)
    about = {text for each in findings for _, text in each.related}
    assert about <= {"GATE_SPEED would be read and set wrongly"}
    return [(each.message, each.hint or "") for each in findings]


def capabilities(*names: str) -> str:
    """The flags as a table has them."""
    return f"{{flags: [{', '.join(f'MAV_PROTOCOL_CAPABILITY_{name}' for name in names)}]}}"


@pytest.mark.parametrize(
    ("autopilot", "encoding"),
    [
        (ARDUPILOT, "c_cast"),
        (INVALID, "c_cast"),
        (INVALID, "bytewise"),
        (GENERIC, "bytewise"),
        (PX4, "bytewise"),
        ("{state: vehicle.mode}", "c_cast"),
        ("{state: vehicle.mode}", "bytewise"),
    ],
)
def test_an_autopilot_of_which_stations_take_parameters_so(tmp_path: Path, autopilot: str, encoding: str) -> None:
    """Nothing is said, neither of what is no autopilot nor of what is not always the same."""
    assert found(tmp_path, autopilot, encoding) == []


@pytest.mark.parametrize("autopilot", [GENERIC, PX4, RESERVED, "{constant: 3}", "{constant: 0}"])
@pytest.mark.parametrize("types", ["as they are", "real32", "none"])
def test_an_autopilot_of_which_stations_take_bytes(tmp_path: Path, autopilot: str, types: str) -> None:
    """It is an error for C casts, unless all parameters are floats anyway."""
    said = found(tmp_path, autopilot, "c_cast", types=types)
    if autopilot == "{constant: 3}" or types != "as they are":
        assert said == []
        return
    name = {"{constant: 0}": "MAV_AUTOPILOT_GENERIC"}.get(autopilot, autopilot[7:-1])
    words = "parameters are C casts here: PARAM_SET and PARAM_VALUE carry the number as a float"
    hint = f"write encoding: bytewise in parameters.yaml, as stations take parameters of all but {ARDUPILOT[7:-1]}"
    assert said == [(f"autopilot says {name}, and {words}", hint)]


@pytest.mark.parametrize(("types", "number"), [("as they are", 1), ("real32", 0), ("none", 0)])
def test_the_autopilot_of_which_stations_take_floats(tmp_path: Path, types: str, number: int) -> None:
    """So it is the other way round."""
    said = found(tmp_path, ARDUPILOT, "bytewise", types=types)
    assert len(said) == number
    for message, hint in said:
        assert message.startswith("autopilot says MAV_AUTOPILOT_ARDUPILOTMEGA, and parameters are bytewise here: ")
        assert hint == "write encoding: c_cast in parameters.yaml, as stations take parameters of it"


@pytest.mark.parametrize("encoding", ["c_cast", "bytewise"])
@pytest.mark.parametrize("types", ["as they are", "real32"])
@pytest.mark.parametrize("told", [(), ("C_CAST",), ("BYTEWISE",), ("C_CAST", "BYTEWISE")])
def test_encodings_that_capabilities_tell(tmp_path: Path, encoding: str, types: str, told: tuple[str, ...]) -> None:
    """The one that the program has not is an error; both are one."""
    names = [f"PARAM_ENCODE_{name}" for name in told]
    said = found(tmp_path, INVALID, encoding, capabilities("PARAM_FLOAT", "MAVLINK2", *names), types=types)
    wrong = [name for name in told if name.lower() != encoding] if types == "as they are" else []
    assert [message.partition(", and ")[0] for message, _ in said] == [
        f"capabilities says MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_{name}" for name in wrong
    ]
    for _, hint in said:
        right = {"c_cast": "C_CAST", "bytewise": "BYTEWISE"}[encoding]
        assert f"name MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_{right} instead" in hint
        assert f"encoding: {wrong[0].lower()} in" in hint


@pytest.mark.parametrize(
    ("flags", "expected"),
    [
        (capabilities("FTP"), ["FTP"]),
        (capabilities("FTP", "MISSION_INT", "COMMAND_INT"), ["MISSION_INT", "FTP"]),
        (
            capabilities("MISSION_FLOAT", "MISSION_FENCE", "MISSION_RALLY"),
            ["MISSION_FLOAT", "MISSION_FENCE", "MISSION_RALLY"],
        ),
        ("{constant: 32}", ["FTP"]),
        ("{flags: [MAV_PROTOCOL_CAPABILITY_FTP if vehicle.armed]}", ["FTP"]),
        ("{constant: 0}", []),
        (capabilities("MAVLINK2", "COMMAND_INT", "PARAM_FLOAT"), []),
    ],
)
def test_what_the_program_refuses(tmp_path: Path, flags: str, expected: list[str]) -> None:
    """Always, or at times."""
    said = found(tmp_path, flags=flags)
    names = [message.partition(" says MAV_PROTOCOL_CAPABILITY_")[2].partition(",")[0] for message, _ in said]
    assert sorted(names) == sorted(expected)
    assert all(hint.startswith("leave it out") for _, hint in said)


def test_missions_that_a_table_takes(tmp_path: Path) -> None:
    assert found(tmp_path, flags=capabilities("MISSION_INT"), receives=MISSION) == []


def test_a_misspelt_encoding_is_said_once(tmp_path: Path) -> None:
    """As what it is: nobody knows which one is meant, so that nothing is said of what HEARTBEAT and flags tell."""
    flags = "{flags: [MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST, MAV_PROTOCOL_CAPABILITY_FTP]}"
    for autopilot in (GENERIC, ARDUPILOT):
        folder = tmp_path / str(autopilot == GENERIC)
        said = [message for message, _ in found(folder, autopilot, "bytewize", flags)]
        assert said == ["capabilities says MAV_PROTOCOL_CAPABILITY_FTP, and each request for files is refused"]
        report = Report()
        read_system(str(folder / "specs" / "codegen.yaml"), report)
        assert [each.message for each in report if each.rule.id != "false-capability"] == [
            "encoding is 'bytewize', not c_cast or bytewise"
        ]
