"""The board's file system: a folder that the firmware finds as its working directory."""

import json
import os
import shutil
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress

from codegen.sim.address import Address, LinkEnd

CREDENTIALS = "wifi.json"
_KEPT = CREDENTIALS + ".kept"


@contextmanager
def flash_folder(
    given: str | None, to: Address, local_port: int, ends: Mapping[str, LinkEnd] | None = None
) -> Iterator[str]:
    """The absolute path of the flash folder, with the Wi-Fi settings of the simulation in it while the block runs.

    ``given`` is a folder that stays (made if it is not there; its own wifi.json is put aside and back again); without
    it the folder is temporary. ``ends`` are those of links over TCP, by their names. OSError: the folder cannot be
    used.
    """
    if given is None:
        with tempfile.TemporaryDirectory(prefix="codegen-sim-") as folder:
            _write_credentials(folder, to, local_port, ends)
            yield folder
        return
    folder = os.path.abspath(given)
    os.makedirs(folder, exist_ok=True)
    credentials, kept = os.path.join(folder, CREDENTIALS), os.path.join(folder, _KEPT)
    if os.path.exists(credentials) and not os.path.exists(kept):  # else it was kept by a run that could not end
        os.replace(credentials, kept)
    try:
        _write_credentials(folder, to, local_port, ends)
        yield folder
    finally:
        with suppress(FileNotFoundError):
            os.remove(credentials)
        with suppress(FileNotFoundError):
            os.replace(kept, credentials)


def _write_credentials(folder: str, to: Address, local_port: int, ends: Mapping[str, LinkEnd] | None) -> None:
    settings: dict[str, object] = {"ssid": "sim", "password": "", "host": to.host, "port": to.port}
    settings["local_port"] = local_port
    for name, end in (ends or {}).items():
        settings[name] = {"port": end.port} if end.host is None else {"host": end.host, "port": end.port}
    with open(os.path.join(folder, CREDENTIALS), "w", encoding="utf-8") as file:
        json.dump(settings, file)


@contextmanager
def code_folder(code: str | None, module: str) -> Iterator[tuple[str, ...]]:
    """The folders that the path of the interpreter needs for the user's ``module``; a file of another name is copied.

    OSError: the file cannot be read.
    """
    name = f"{module}.py"
    if code is None:
        yield ()
        return
    folder = os.path.dirname(os.path.abspath(code))
    if os.path.basename(code) == name:
        yield (folder,)
        return
    with tempfile.TemporaryDirectory(prefix="codegen-code-") as copy:
        shutil.copyfile(code, os.path.join(copy, name))
        yield (copy, folder)
