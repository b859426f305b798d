"""A cable that is pulled at any moment: the board never starts half a program, and the next deploy repairs it."""

import shutil
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
from board_on_pty import Board, powered

from codegen.deploy.connection import Connection
from codegen.deploy.findings import BoardFaultError
from codegen.deploy.plan import MANIFEST, PART, Plan, plan
from codegen.deploy.transfer import digests_of, found_files, owned_files, transfer
from codegen.diagnostics import Report

MAIN = b"import one\nfrom package import two\n"
OLD = {"main.py": b"import one, gone\n", "one.mpy": b"old", "gone.mpy": b"goes", "same.mpy": b"same" * 200}
NEW = {"main.py": MAIN, "one.mpy": b"new", "same.mpy": OLD["same.mpy"], "package/two.mpy": bytes(range(256)) * 7}
OWN = {
    "parameters.0": b"SLOT" + bytes(60),
    "parameters.1": b"SLOT" + bytes(range(60)),
    "wifi.json": b'{"ssid": "x", "password": "y"}',
    "notes.txt": b"mine",
    "boot.py": b"# mine\n",
}
"""Files that a deploy never touches."""
MADE = b"# Generated from specs/state.yaml: do not edit.\n"
ASKED = sorted({*OLD, *NEW, *OWN, "one.py", PART, MANIFEST})


@pytest.fixture(scope="module")
def before(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The flash of a board with an older program, with a source that hides a module, and with files of its own."""
    image = tmp_path_factory.mktemp("flash") / "before"
    with powered(image, blocks=64) as board:
        connection = Connection(board.port)
        deploy(connection, OLD)
        for path, content in {**OWN, "one.py": MADE}.items():
            connection.run(f"with open({path!r}, 'wb') as file: file.write({content!r})")
        connection.close()
    return image


def deploy(connection: Connection, files: Mapping[str, bytes]) -> Plan:
    owned = owned_files(connection)
    digests = digests_of(files)
    todo = plan(digests, found_files(connection, digests, owned), owned)
    if not todo.is_empty:
        for _ in transfer(connection, files, todo, owned):
            pass
    return todo


def listed(connection: Connection) -> dict[str, str]:
    """The files on the board with their hashes."""
    rows: list[list[Any]] = connection.ask(f"survey({ASKED!r})")
    return {path: digest for path, _, digest, _ in rows if not path.endswith("/")}


def has_all(found: Mapping[str, str], files: Mapping[str, bytes]) -> bool:
    return digests_of(files).items() <= found.items()


def interrupted(board: Board, last: int) -> bool:
    """Deploy until that many pieces have been written to the port, then pull the cable; whether it came that far."""
    connection = Connection(board.port)
    write, count = connection.transport.serial.write, 0

    def counted(data: bytes) -> None:
        nonlocal count
        write(data)
        count += 1
        if count == last:
            board.cut()

    connection.transport.serial.write = counted
    try:
        deploy(connection, NEW)
    except BoardFaultError:
        return True
    finally:
        connection.close()
    return False


def repaired(image: Path, moment: str) -> None:
    """The board is whole or starts nothing; another deploy makes it whole, and what is its own is as it was."""
    with powered(image) as board:
        connection = Connection(board.port)
        found = listed(connection)
        if "main.py" in found:
            assert has_all(found, NEW) or (has_all(found, OLD) and "one.py" in found), (moment, found)
        assert has_all(found, OWN), moment
        deploy(connection, NEW)
        found = listed(connection)
        assert set(found) == {*NEW, *OWN, MANIFEST}, moment
        assert has_all(found, {**NEW, **OWN}), moment
        connection.close()


def test_a_cable_pulled_at_every_write_to_the_port(before: Path, tmp_path: Path) -> None:
    moments = 0
    for moment in range(1, 1000):
        image = Path(shutil.copy(before, tmp_path / "flash"))
        with powered(image) as board:
            if not interrupted(board, moment):
                break
        repaired(image, f"write {moment}")
        moments = moment
    assert moments > 30


def test_power_that_goes_between_two_writes_to_the_flash(before: Path, tmp_path: Path) -> None:
    """The file may have been written in part."""
    moments = 0
    for moment in range(2, 1000, 9):
        image = Path(shutil.copy(before, tmp_path / "flash"))
        with powered(image, writes=moment) as board:
            if not interrupted(board, 0):
                break
        repaired(image, f"block {moment}")
        moments += 1
    assert moments > 3


def test_what_the_command_says_of_it(before: Path, tmp_path: Path) -> None:
    """board-lost and board-refused are findings about the port."""
    report = Report()
    with powered(Path(shutil.copy(before, tmp_path / "flash"))) as board:
        connection = Connection(board.port)
        with pytest.raises(BoardFaultError) as refused:
            connection.run("open('nothing.txt')")
        refused.value.tell(board.port, report)
        board.cut()
        with pytest.raises(BoardFaultError) as lost:
            connection.run("identify()")
        lost.value.tell(board.port, report)
        connection.close()
    assert [finding.rule.id for finding in report] == ["board-lost", "board-refused"]
    assert "the board says: OSError: [Errno 2] ENOENT" in {finding.message for finding in report}
