"""A cache of results of pure functions, kept between runs under the hash of all their inputs.

It lies in the user's cache folder: ``$CODEGEN_CACHE``, or else ``codegen`` below ``$XDG_CACHE_HOME`` (``~/.cache``);
``CODEGEN_CACHE=off`` does without. Nothing depends on it: what is not there, or is damaged, is computed again, and a
folder that cannot be written, or that others could write to, is left alone. Entries never change, as another input has
another name, and each is written whole: several runs at once do not disturb each other.
"""

import hashlib
import os
import stat
from contextlib import suppress
from functools import cache
from io import BytesIO

VARIABLE = "CODEGEN_CACHE"
"""The variable of the environment that names the folder, or says ``off``."""

MOST_BYTES = 64_000_000
"""The largest size of the folder: beyond it the oldest entries go until half of that is left."""

_SEAL_BYTES = 32
_LOOKS = "00"
"""One entry in 256 begins like this; whoever writes one looks at how much there is."""


def entry(*inputs: bytes | str) -> str:
    """The name of an entry: a hash of its inputs, in hexadecimal."""
    digest = hashlib.sha256()
    for part in inputs:
        data = part.encode("utf-8", "surrogatepass") if isinstance(part, str) else part
        digest.update(b"%d\n" % len(data))
        digest.update(data)
    return digest.hexdigest()


_new: dict[str, bytes] = {}


def kept(name: str) -> bytes | None:
    """Return what is kept under the name of an entry; None where there is nothing that can be believed."""
    folder = cache_folder()
    if folder is None or name in _new:
        return _new.get(name)
    try:
        with open(os.path.join(folder, name), "rb") as file:
            content = file.read()
    except OSError:
        return None
    value = content[_SEAL_BYTES:]
    return value if content[:_SEAL_BYTES] == _seal(name, value) else None


def keep(name: str, value: bytes) -> None:
    """Keep ``value`` under the name of an entry: in this run, and beyond it once ``write_new`` says so."""
    if cache_folder() is not None:
        _new[name] = value


def has_new() -> bool:
    """Return whether there is anything to write."""
    return bool(_new)


def write_new() -> None:
    """Write what is new, if the system lets it."""
    folder = cache_folder()
    if folder is None:
        return
    for name, value in _new.items():
        _write(folder, name, value)
    if any(name.startswith(_LOOKS) for name in _new):
        _make_room(folder)
    _new.clear()


def _write(folder: str, name: str, value: bytes) -> None:
    unfinished = os.path.join(folder, f"{name}.{os.urandom(8).hex()}")
    try:
        with open(unfinished, "xb") as file:
            file.write(_seal(name, value) + value)
        os.replace(unfinished, os.path.join(folder, name))
    except OSError:
        with suppress(OSError):
            os.unlink(unfinished)


def kept_object(name: str) -> object | None:
    """The object that is kept under the name of an entry; None where there is none."""
    import pickle  # noqa: PLC0415  a build with nothing to do has no objects

    value = kept(name)
    try:
        return None if value is None else pickle.loads(value)  # noqa: S301  written by keep_object, as the seal shows
    except Exception:  # whatever a class does that is not what it was: the object is made anew
        return None


def pickled(value: object) -> bytes:
    """A value as an input of an entry: equal ones are equal bytes, whatever objects they share."""
    import pickle  # noqa: PLC0415

    content = BytesIO()
    pickler = pickle.Pickler(content, pickle.HIGHEST_PROTOCOL)
    pickler.fast = True
    pickler.dump(value)
    return content.getvalue()


def keep_object(name: str, value: object) -> None:
    """Keep an object (anything but None) under the name of an entry."""
    if cache_folder() is None:
        return
    import pickle  # noqa: PLC0415

    keep(name, pickle.dumps(value, pickle.HIGHEST_PROTOCOL))


@cache
def cache_folder() -> str | None:
    """The absolute path of the folder; None where there is none that only this user can write to."""
    chosen = os.environ.get(VARIABLE)
    if chosen is None:
        above = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
        chosen = os.path.join(above, "codegen")
    if chosen.lower() == "off" or not os.path.isabs(chosen):
        return None
    try:
        os.makedirs(chosen, mode=0o700, exist_ok=True)
        found = os.stat(chosen)
    except OSError:
        return None
    is_own = not hasattr(os, "geteuid") or (found.st_uid == os.geteuid() and not found.st_mode & 0o022)
    return chosen if stat.S_ISDIR(found.st_mode) and is_own else None


def _seal(name: str, value: bytes) -> bytes:
    """Return what stands before a value: an entry that was cut off, changed or renamed does not have it."""
    return hashlib.sha256(name.encode() + value).digest()


def _make_room(folder: str) -> None:
    """Remove the oldest files of a folder that holds too much; another run may do so at the same time."""
    with suppress(OSError):
        found = []
        for file in os.scandir(folder):
            with suppress(FileNotFoundError):
                described = file.stat(follow_symlinks=False)
                if stat.S_ISREG(described.st_mode):
                    found.append((described.st_mtime_ns, described.st_size, file.path))
        total = sum(size for _, size, _ in found)
        if total <= MOST_BYTES:
            return
        for _, size, path in sorted(found):
            if total <= MOST_BYTES // 2:
                break
            with suppress(FileNotFoundError):
                os.unlink(path)
            total -= size
