"""Carrying a plan out, so that a cable pulled at any moment leaves a board that the next deploy repairs.

First the manifest says which files may come, then main.py goes: from here on the board starts nothing. What is outdated
is removed, what is new copied, each file under a passing name until it is whole. When all of it is there and has been
read back, main.py comes last.
"""

import json
from base64 import b64encode
from collections.abc import Collection, Iterator, Mapping
from hashlib import sha256

from codegen.deploy.board import Board, Found, board_of
from codegen.deploy.built_in import ANYWHERE, built_in
from codegen.deploy.connection import Connection
from codegen.deploy.contents import module_names
from codegen.deploy.findings import BOARD_REFUSED, BoardFaultError
from codegen.deploy.missing import Importable
from codegen.deploy.plan import MAIN, MANIFEST, PART, Owned, Plan, of_interest, plan

_PIECE = 1536
"""Bytes that go out at once: a raw REPL compiles them in the board's heap."""


def identified(connection: Connection) -> Board:
    """The board."""
    return board_of(connection.ask("identify()")[0])


def owned_files(connection: Connection) -> dict[str, list[str]]:
    """Return what the manifest on the board says; nothing where there is none, or a damaged one."""
    return _read_manifest(connection, MANIFEST) or _read_manifest(connection, PART)


def _read_manifest(connection: Connection, path: str) -> dict[str, list[str]]:
    """Return the manifest on the board; empty where it is cut, as on FAT between removing and renaming."""
    try:
        written = json.loads(connection.run(f"show({path!r})"))
        return {str(path): [str(digest) for digest in digests] for path, digests in written["files"].items()}
    except (ValueError, KeyError, TypeError, AttributeError):
        return {}


def found_files(connection: Connection, wanted: Mapping[str, str], owned: Owned) -> dict[str, Found]:
    """The files on the board by their paths, folders with a slash behind them."""
    rows = connection.ask(f"survey({of_interest(wanted.keys(), owned)!r})")
    return {path: Found(size, digest, is_made) for path, size, digest, is_made in rows}


def importable(connection: Connection, found: Collection[str], gone: Collection[str]) -> Importable:
    """Return what can be imported on the board once the files ``gone`` are, of those ``found``, by their paths."""
    here, *folders = connection.ask("importable()")
    looked_at = {_absolute(here, path) for path in found}
    left = {_absolute(here, path) for path in found if not path.endswith("/") and path not in gone}
    names: set[str] = set()
    for folder, listed in folders:
        for name in listed:
            path = f"{_absolute(here, folder).rstrip('/')}/{name}"
            is_elsewhere = not {path, f"{path}/"} & looked_at  # another file system, such as a ROMFS
            if is_elsewhere or any(each == path or each.startswith(f"{path}/") for each in left):
                names.add(name)
    known = built_in(connection.run("built_in()"))
    return Importable(module_names(names) | (ANYWHERE if known is None else known), is_known=known is not None)


def _absolute(here: str, path: str) -> str:
    """Return a path on the board, which is relative to the working folder or begins with a slash."""
    return path if path.startswith("/") else f"{here.rstrip('/')}/{path}"


def digests_of(files: Mapping[str, bytes]) -> dict[str, str]:
    """The hashes of files, by path, as the board writes them."""
    return {path: sha256(content).hexdigest() for path, content in files.items()}


def transfer(connection: Connection, files: Mapping[str, bytes], todo: Plan, owned: Owned) -> Iterator[str]:
    """Do what the plan says; yields each step before it is done, as words for people."""
    digests = digests_of(files)
    may_come = {
        path: {*owned.get(path, ()), *([digests[path]] if path in digests else [])} for path in {*owned, *digests}
    }
    write_manifest(connection, {path: sorted(listed) for path, listed in may_come.items()})
    for each in todo.removals:
        yield f"{'keep' if each.kept else 'remove'} {each.path}"
        connection.run(f"move({each.path!r}, {each.kept!r})" if each.kept else f"remove({each.path!r})")
    for path in todo.copies:
        if path != MAIN:
            yield f"copy {path}"
            put(connection, path, files[path])
    rest = {path: digest for path, digest in digests.items() if path != MAIN}
    left = plan(rest, found_files(connection, rest, owned), {})
    if not left.is_empty:
        wrong = [*left.copies, *(each.path for each in left.removals)]
        raise BoardFaultError(
            BOARD_REFUSED, f"the board does not hold what was sent: {', '.join(wrong)}", "run it again"
        )
    write_manifest(connection, {path: [digest] for path, digest in digests.items()})
    if MAIN in todo.copies:
        yield f"copy {MAIN}"
        put(connection, MAIN, files[MAIN])


def put(connection: Connection, path: str, content: bytes) -> None:
    """Write one file, whole or not at all."""
    pieces = [content[start : start + _PIECE] for start in range(0, len(content), _PIECE)]
    lines = [f"add({b64encode(piece)!r})" for piece in pieces] or ["pass"]
    lines[0] = f"begin()\n{lines[0]}"
    lines[-1] += f"\nfinish({path!r}, {sha256(content).hexdigest()!r})"
    for line in lines:
        connection.run(line)


def write_manifest(connection: Connection, files: Mapping[str, list[str]]) -> None:
    """Say on the board what deploys have put there."""
    text = json.dumps(
        {"doc": "Written by codegen deploy.", "files": dict(sorted(files.items()))}, separators=(",", ":")
    )
    put(connection, MANIFEST, text.encode())
