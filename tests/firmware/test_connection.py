"""One port: texts and their chunks, a share of work in each pass, full and broken ports, faults, and memory."""

import json
import os
import re
import subprocess
from pathlib import Path
from typing import Any

import pymavlink_oracle as oracle
import pytest
from firmware_runs import PROGRAM, tool
from pymavlink.dialects.v20 import common
from service_runs import PLAIN, Services, command, fields, packed, start

COMMAND = packed(command(520, 0))


def texts(messages: list[Any]) -> list[tuple[Any, ...]]:
    """(severity, text, id, chunk) of each STATUSTEXT."""
    return [fields(message, "severity", "text", "id", "chunk_seq") for message in messages]


def test_each_text_is_sent_once(services: Services) -> None:
    """On every connection, in order, and in one chunk up to 50 characters."""
    long = "x" * 50
    answer = services.run(("say", (4, "first")), ("say", (6, long)), ("passes", 9), versions=(2, 2))
    for connection in (0, 1):
        found = [message for message in answer.replies[-1][connection] if message.get_type() == "STATUSTEXT"]
        assert texts(found) == [(4, "first", 0, 0), (6, long, 0, 0)]


@pytest.mark.parametrize("length", [51, 99, 100, 101, 150, 151])
def test_long_texts_are_sent_in_chunks(services: Services, length: int) -> None:
    """A NUL ends the last chunk, which so may be empty; each text has its own id."""
    long = "".join(chr(97 + index % 26) for index in range(length))
    answer = services.run(("say", (3, long)), ("say", (3, "short")), ("say", (2, long)), ("passes", 20))
    found = texts(answer.of("STATUSTEXT"))
    chunks = [long[at : at + 50] for at in range(0, length + 1, 50)]
    first = [(3, chunk, 1, index) for index, chunk in enumerate(chunks)]
    second = [(2, chunk, 2, index) for index, chunk in enumerate(chunks)]
    assert found == [*first, (3, "short", 0, 0), *second]


def test_long_texts_are_cut_in_mavlink_1(services: Services) -> None:
    """It has no chunks."""
    answer = services.run(("say", (3, "y" * 70)), ("say", (4, "short")), ("passes", 9), versions=(1,))
    found = [fields(message, "severity", "text") for message in answer.of("STATUSTEXT")]
    assert found == [(3, "y" * 50), (4, "short")]


@pytest.mark.parametrize("said", ["x" + 40 * "ä", 30 * "€", "x" + 30 * "€", "xy" + 30 * "€", 50 * "ä", 49 * "x" + "ä"])
def test_texts_that_are_cut_end_with_a_whole_character(services: Services, said: str) -> None:
    """As much as has room in MAVLink 1, which nothing follows."""
    answer = services.run(("say", (3, said)), ("say", (4, 25 * "ä")), ("passes", 9), versions=(1,))
    cut, whole = (bytes(message.get_msgbuf())[7:-2].rstrip(b"\0").decode() for message in answer.of("STATUSTEXT"))
    assert said.startswith(cut)
    assert len(cut.encode()) <= 50 < len(said[: len(cut) + 1].encode())
    assert whole == 25 * "ä"


def test_texts_that_are_not_ascii(services: Services) -> None:
    """They are UTF-8, as the dialect says, and put together from their chunks they are what was said."""
    said = "Übertemperatur: 85 °C " * 4
    answer = services.run(("say", (4, said)), ("passes", 9))
    frames = [bytes(message.get_msgbuf())[10:-2].ljust(54, b"\0")[1:51] for message in answer.of("STATUSTEXT")]
    assert b"".join(frames).rstrip(b"\0").decode() == said
    assert answer.state["faults"] == 0


def test_texts_that_were_overwritten_are_passed_over(services: Services) -> None:
    """The newest 16 are there when the port comes up."""
    steps: list[tuple[str, Any]] = [("port", {"is_up": False}), ("passes", 3)]
    steps += [("say", (6, f"text {number}")) for number in range(40)]
    answer = services.run(*steps, ("passes", 30), ("port", {"is_up": True}), ("passes", 30))
    assert [message.text for message in answer.of("STATUSTEXT")] == [f"text {number}" for number in range(24, 40)]


def test_a_full_port_delays_texts_and_loses_none(services: Services) -> None:
    """One frame fits in every second pass."""
    said = [f"a text of some length {number}" for number in range(6)]
    steps: list[tuple[str, Any]] = [("say", (6, text)) for text in said]
    for _ in range(12):
        steps += [("port", {"room": 45}), ("passes", 1), ("port", {"room": 0}), ("passes", 1)]
    answer = services.run(*steps)
    assert [message.text for message in answer.of("STATUSTEXT")] == said
    sequence = [message.get_seq() for message in answer.all]
    assert sequence == list(range(sequence[0], sequence[0] + len(sequence)))


def test_a_flood_is_taken_in_piece_by_piece(services: Services) -> None:
    """Two messages in a pass, or 256 bytes, which is more than a UART brings: the rest comes in the next ones."""
    answer = services.run(("arrive", COMMAND * 20), *[("passes", 1)] * 12)
    counts = [len([m for m in step[0] if m.get_type() == "COMMAND_ACK"]) for step in answer.replies[1:]]
    assert counts == [2] * 10 + [0, 0]
    answer = services.run(("arrive", bytes(2000) + COMMAND), *[("passes", 1)] * 12)
    counts = [len([m for m in step[0] if m.get_type() == "COMMAND_ACK"]) for step in answer.replies[1:]]
    assert counts == [0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0]


def test_bytes_that_look_like_frames_take_no_longer(services: Services) -> None:
    """To check one counts as much as its length: what comes behind many waits for a later pass, and is not lost."""
    looks = COMMAND[:-1] + bytes([COMMAND[-1] ^ 1])
    answer = services.run(("arrive", looks * 9 + COMMAND), *[("passes", 1)] * 4)
    counts = [len([m for m in step[0] if m.get_type() == "COMMAND_ACK"]) for step in answer.replies[1:]]
    assert counts == [0, 0, 1, 0]


@pytest.mark.parametrize(
    "false", [b"\xfd\xff\x00", b"\xfd\xff\x00\x00\x00\xff\xbe\x4c\x00\x00", b"\xfe\xff\x00\x01\x01\x00"]
)
def test_a_stray_start_of_a_frame_delays_nothing_for_long(services: Services, false: bytes) -> None:
    """Half a second at most, where it looks like a message that is known; the frames behind it are all found."""
    answer = services.run(("arrive", false + COMMAND), ("passes", 240), ("arrive", COMMAND), ("passes", 4))
    assert len(answer.of("COMMAND_ACK")) == 2
    assert answer.state["received"] == 2


def test_a_stray_start_is_given_up_though_bytes_go_on_arriving(services: Services) -> None:
    """A byte now and then does not keep it waiting for all that it announces."""
    steps = [("arrive", b"\xfd\xff\x00\x00\x00\xff\xbe\x4c\x00\x00" + b"\x00" + COMMAND)]
    steps += [step for _ in range(60) for step in (("arrive", b"\x00"), ("passes", 4))]
    assert len(services.run(*steps).of("COMMAND_ACK")) == 1


def test_heartbeats_go_on_during_a_flood(services: Services) -> None:
    """10 s of full load: all ten HEARTBEATs, and nothing is lost of what arrives."""
    answer = services.run(*[("arrive", COMMAND * 2), ("passes", 4)] * 1000)
    assert len(answer.of("HEARTBEAT")) == 10
    assert len(answer.of("COMMAND_ACK")) == 2000
    assert answer.state["left"] == 0


@pytest.mark.parametrize("size", [1, 7, 31, 32, 33, 64, 511, 512, 513])
def test_frames_arrive_in_any_pieces(services: Services, size: int) -> None:
    """The bytes read are handed on whole, wherever they are cut."""
    stream = (COMMAND + b"\xfd\x00garbage" + oracle.raw_frame(70000, bytes(range(200)), 3)) * 6 + bytes(300)
    steps: list[tuple[str, Any]] = []
    for at in range(0, len(stream), size):
        steps += [("arrive", stream[at : at + size]), ("passes", 1)]
    answer = services.run(*steps, ("passes", 20))
    assert len(answer.of("COMMAND_ACK")) == 6
    assert answer.state["received"] == 6


def test_replies_wait_for_a_full_port(services: Services) -> None:
    """A COMMAND_ACK is not lost, and what it announces still comes after it."""
    full: dict[str, Any] = {"room": 10, "left": 0}
    arrived = [("in", packed(command(512, 148))), ("in", packed(command(246, 0)))]
    answer = services.run(("passes", 1), ("port", full), *arrived, ("port", {"room": None}), ("passes", 1))
    assert [step[0] for step in answer.replies[1:-1]] == [[]] * (len(answer.replies) - 2)
    names = [message.get_type() for message in answer.replies[-1][0]]
    assert names == ["COMMAND_ACK", "AUTOPILOT_VERSION", "COMMAND_ACK"]
    assert [ack.command for ack in answer.of("COMMAND_ACK")] == [512, 246]
    sequence = [message.get_seq() for message in answer.all]
    assert sequence == list(range(sequence[0], sequence[0] + len(sequence)))


def test_what_was_asked_for_waits_for_a_full_port(services: Services) -> None:
    """The COMMAND_ACK fits, AUTOPILOT_VERSION does not before the port is empty."""
    answer = services.run(
        ("passes", 1),
        ("port", {"room": 25, "left": 25}),
        ("in", packed(command(512, 148))),
        ("port", {"room": None}),
        ("passes", 1),
    )
    names = [[message.get_type() for message in step[0]] for step in answer.replies[3:]]
    assert names == [["COMMAND_ACK"], [], ["AUTOPILOT_VERSION"]]
    sequence = [message.get_seq() for message in answer.all]
    assert sequence == list(range(sequence[0], sequence[0] + len(sequence)))
    assert answer.state["tx_errors"] == 0
    # Room for one of two instances: it does not come again and again.
    full = ("port", {"room": 65, "left": 65})
    batteries = services.run(("passes", 1), full, ("in", packed(command(512, 147)))).of("BATTERY_STATUS")
    assert [message.id for message in batteries] == [0]


def test_replies_that_wait_are_limited(services: Services) -> None:
    """A port that takes nothing for long loses the oldest, and they are counted."""
    arrived = [("in", packed(command(number))) for number in range(20)]
    answer = services.run(("port", {"room": 10, "left": 0}), *arrived, ("port", {"room": None}), ("passes", 2))
    assert [ack.command for ack in answer.of("COMMAND_ACK")] == list(range(12, 20))
    assert answer.state["lost_replies"] == 12


def test_replies_are_given_up_when_the_port_is_down(services: Services) -> None:
    """Nobody waits for them when it is up again, hours later perhaps."""
    down = ("port", {"is_up": False})
    answer = services.run(down, ("in", COMMAND), ("in", COMMAND), ("port", {"is_up": True}), ("passes", 9))
    assert answer.of("COMMAND_ACK") == []
    assert answer.state["lost_replies"] == 2


def test_broken_streams_stop_nothing_else(services: Services) -> None:
    """They are caught and counted in each pass, and told once a second."""
    broken = ("streams", {"is_broken": True})
    answer = services.run(broken, ("passes", 800), ("in", COMMAND), ("streams", {"is_broken": False}), ("passes", 800))
    assert answer.state["faults"] == 808
    assert len(answer.of("COMMAND_ACK")) == 1
    assert len(answer.of("HEARTBEAT")) == 5  # those that were due in between too: it catches up
    said = [message.text for message in answer.of("STATUSTEXT")]
    assert len(said) == 3
    assert re.fullmatch(r"bench fault ValueError\('broken stream',?\)", said[0])


def test_memory(service_folders: tuple[Path, ...]) -> None:
    """Streams alone, and any bytes that are no request, allocate nothing; requests leave nothing behind."""
    damaged = oracle.raw_frame(76, bytes(range(1, 34)), extra=3)
    unknown = oracle.raw_frame(70000, bytes(range(200)), 3)
    for_others = packed(common.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3), source=(1, 1))
    noise = damaged + unknown + for_others + bytes(range(256)) + b"\xfe" * 600 + b"\xfd" * 50 + bytes(300)
    asked = [command(512, 147), command(511, 147, 5e5), command(400, 1), command(7), command(510, 147)]
    asked += [common.MAVLink_param_request_list_message(1, 1), common.MAVLink_ping_message(2**63, 6, 0, 0)]
    asked += [common.MAVLink_param_set_message(1, 1, b"BATT_LOW_VOLT", 99.0, 9)]
    asked += [common.MAVLink_param_request_read_message(1, 1, b"NONE", -1)]
    asked += [common.MAVLink_file_transfer_protocol_message(0, 1, 1, [1] * 251)]
    asked += [common.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3)]
    requests = b"".join(map(packed, asked))
    running = start("micropython", service_folders, "allocation.py", "-X", "heapsize=4m")
    question = json.dumps({"noise": noise.hex(), "requests": requests.hex(), "count": 61})
    answer, _ = running.communicate(question + "\n", timeout=100)
    found = json.loads(answer)
    assert found["taken"] > 250000
    assert found["answered"] > 4000
    assert found["polls"] == 4500
    assert found["faults"] == [0, 0, 0]
    assert (found["quiet"], found["noise"]) == (0, 0)
    assert found["kept"] <= 64


STEADY = {
    "connection": {"turn_to", "_has_place", "_wait_ms", "_end_pass", "_send_waiting", "_note", "send"},
    "inbox": {"_is_given_up"},
    "stations": {"forget_silent", "_find"},
    "station": {"run"},
    "services": {"run", "handle"},
    "parameter_service": {"run"},
}


@pytest.mark.parametrize("module", PLAIN)
def test_steady_functions_are_small_enough_for_the_stack(service_folders: tuple[Path, ...], module: str) -> None:
    """MicroPython puts the variables of functions with more than 11 words on the heap at every call."""
    command = [tool("micropython"), "-X", "heapsize=4m", "-v", "-v", str(PROGRAM / f"{module}.py")]
    path = os.pathsep.join(map(str, service_folders))
    done = subprocess.run(command, env={"MICROPYPATH": path}, capture_output=True, text=True, check=True)
    blocks = re.findall(r"File \S+/(\w+)\.py, code block '([^']+)'.*?\(N_STATE (\d+)\)", done.stdout, re.DOTALL)
    found = {function: int(words) for file, function, words in blocks if file == module}
    assert STEADY.get(module, set()) <= set(found)
    assert {function for function in STEADY.get(module, set()) if found[function] > 11} == set()
