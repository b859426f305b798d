"""Talks to the services as a ground station does: pymavlink makes what goes in and reads what comes out."""

import json
import os
import re
import shutil
import struct
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from firmware_runs import FIRMWARE, MOCKS, PROGRAM, tool
from pymavlink.dialects.v10 import common as common_1
from pymavlink.dialects.v20 import common
from pymavlink.generator import mavparse

from codegen.render.templates import render_template

BENCH = Path(__file__).with_name("service_bench")
PLAIN = ("bytewise", "connection", "inbox", "rare_commands", "services", "station", "stations")
COMMANDS = Path(__file__).resolve().parents[2] / "generated" / "firmware" / "commands.py"
GROUND = (255, 190)
MESSAGES = (
    "HEARTBEAT,PING,PARAM_REQUEST_READ,PARAM_REQUEST_LIST,PARAM_VALUE,PARAM_SET,PARAM_ERROR,REQUEST_DATA_STREAM,COMMAND_INT,"
    "COMMAND_LONG,COMMAND_ACK,FILE_TRANSFER_PROTOCOL,BATTERY_STATUS,AUTOPILOT_VERSION,MESSAGE_INTERVAL,STATUSTEXT,"
    "PROTOCOL_VERSION"
)
# pymavlink's common.xml does not have it.
OVERLAY = """<mavlink><include>common.xml</include><messages>
<message id="300" name="PROTOCOL_VERSION"><description>Versions.</description>
<field type="uint16_t" name="version">1</field><field type="uint16_t" name="min_version">1</field>
<field type="uint16_t" name="max_version">1</field><field type="uint8_t[8]" name="spec_version_hash">1</field>
<field type="uint8_t[8]" name="library_version_hash">1</field></message></messages></mavlink>"""


def prepare(folder: Path, *, is_bytewise: bool = False) -> tuple[Path, ...]:
    """Make the modules that are rendered for a vehicle, as far as the services use them; where to import from."""
    shipped = Path(mavparse.__file__).parents[1] / "dialects" / "v20"
    for name in ("common.xml", "standard.xml", "minimal.xml"):
        shutil.copy(shipped / name, folder)
    (folder / "overlay.xml").write_text(OVERLAY, encoding="utf-8")
    codec = folder / "codec"
    arguments = ["--dialect", str(folder / "overlay.xml"), "--messages", MESSAGES, "--out", str(codec)]
    subprocess.run([sys.executable, "-m", "codegen", "codec", *arguments], check=True, capture_output=True)
    service = codec / "parameter_service.py"
    view = SimpleNamespace(is_bytewise=is_bytewise)
    service.write_text(render_template("firmware/program/parameter_service.py.j2", view), "utf-8")
    sources = [service, *(PROGRAM / f"{name}.py" for name in PLAIN), *sorted(BENCH.glob("*.py"))]
    names = sorted({name for path in sources for name in re.findall(r"dialect\.(\w+)", path.read_text("utf-8"))})
    (codec / "dialect.py").write_text("".join(f"{name} = {_number(name)}\n" for name in names), "utf-8")
    shutil.copy(COMMANDS, codec)  # of the rover, with arming
    return BENCH, codec, PROGRAM, FIRMWARE, MOCKS


def _number(name: str) -> int:
    """A number of the dialect; PING_SEQ_AT is where a payload has a field."""
    if not name.endswith("_AT"):
        return int(getattr(common, name))
    kinds = [kind for kind in common.mavlink_map.values() if name.startswith(f"{kind.msgname}_")]
    kind = max(kinds, key=lambda each: len(each.msgname))
    before = kind.ordered_fieldnames.index(name.removeprefix(f"{kind.msgname}_").removesuffix("_AT").lower())
    return struct.calcsize("<" + "".join(re.findall(r"\d*[a-zA-Z]", kind.unpacker.format)[:before]))


def start(interpreter: str, folders: tuple[Path, ...], script: str, *options: str) -> subprocess.Popen[str]:
    """Start a script of the bench on an interpreter."""
    path = os.pathsep.join(map(str, folders))
    command = [sys.executable, "-B"] if interpreter == "cpython" else [tool("micropython"), *options]
    return subprocess.Popen(
        [*command, str(BENCH / script)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env=os.environ | {"MICROPYPATH": path, "PYTHONPATH": path},
    )


@dataclass
class Answer:
    """The end of a scenario; `replies` are the messages of the vehicle by step and connection."""

    state: dict[str, Any]
    replies: list[list[list[Any]]]

    @property
    def all(self) -> list[Any]:
        """Messages of the first connection."""
        return [message for step in self.replies for message in step[0]]

    def of(self, *names: str) -> list[Any]:
        """Messages of these names on the first connection."""
        return [message for message in self.all if message.get_type() in names]


class Services:
    """The services on one interpreter, which runs until close()."""

    def __init__(self, interpreter: str, folders: tuple[Path, ...]) -> None:
        self._process = start(interpreter, folders, "answer.py", "-X", "heapsize=64m")

    def close(self) -> None:
        """End the interpreter."""
        self._process.communicate(timeout=20)

    def run(self, *steps: tuple[str, Any], versions: tuple[int, ...] = (2,)) -> Answer:
        """Do the steps with a new vehicle that has a connection for each version.

        Bytes of a step "in" are followed by 8 passes, those of a step "arrive" by none.
        """
        whole: list[tuple[str, Any]] = []
        for what, argument in steps:
            whole.append((what, argument.hex() if isinstance(argument, bytes) else argument))
            if what == "in":
                whole.append(("passes", 8))
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(json.dumps({"versions": versions, "steps": whole}) + "\n")
        self._process.stdin.flush()
        state = json.loads(self._process.stdout.readline())
        sides = [common.MAVLink(None) for _ in versions]
        replies = []
        for outputs in state.pop("outputs"):
            texts = [bytes.fromhex(output) for output in outputs]
            replies.append([side.parse_buffer(data) or [] for side, data in zip(sides, texts, strict=True)])
        assert all(message.get_type() != "BAD_DATA" for step in replies for found in step for message in found)
        return Answer(state, replies)

    def ask(self, *messages: Any, **arguments: Any) -> Answer:
        """Let messages of pymavlink arrive, each by itself."""
        return self.run(*[("in", packed(message)) for message in messages], **arguments)


def packed(message: Any, source: tuple[int, int] = GROUND, version: int = 2) -> bytes:
    """A frame of pymavlink."""
    dialect = common if version == 2 else common_1
    return bytes(message.pack(dialect.MAVLink(None, srcSystem=source[0], srcComponent=source[1])))


def command(number: int, *params: float, target: tuple[int, int] = (1, 1)) -> Any:
    """A COMMAND_LONG."""
    values = [*params, *[0.0] * (7 - len(params))]
    return common.MAVLink_command_long_message(*target, number, 0, *values)


def command_int(number: int, *params: float, target: tuple[int, int] = (1, 1)) -> Any:
    """The same command as a COMMAND_INT."""
    values = [*params, *[0.0] * (7 - len(params))]
    return common.MAVLink_command_int_message(
        *target, 0, number, 0, 0, *values[:4], int(values[4]), int(values[5]), values[6]
    )


def fields(message: Any, *names: str) -> tuple[Any, ...]:
    """Some fields of a message."""
    return tuple(getattr(message, name) for name in names)
