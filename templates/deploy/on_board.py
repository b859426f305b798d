"""The part of `codegen deploy` that runs on the board, over the raw REPL; nothing of it is stored there.

A file is written as PART, and has its name only once it is whole. Answers are lines of JSON.
"""

import gc
import json
import os
import sys
from binascii import a2b_base64, hexlify
from hashlib import sha256

PART = "deploy.part"
MADE = b"# Generated from "


def identify():
    """Print what the board is, how many bytes its file system and its heap have, and how many ROMFS partitions."""
    told = sys.implementation
    block, room, free = [os.statvfs(os.getcwd())[place] for place in (1, 2, 3)]
    answer = {
        "version": list(told.version[:3]),
        "machine": getattr(told, "_machine", sys.platform),
        "mpy": getattr(told, "_mpy", 0),
        "block": block,
        "room": block * room,
        "free": block * free,
        "roms": rom_partitions(),
        "heap": gc.mem_alloc() + gc.mem_free(),
    }
    print(json.dumps(answer))


def rom_partitions():
    """Return how many partitions for a ROMFS there are; most builds of MicroPython have none."""
    try:
        import vfs  # not every board has it

        return vfs.rom_ioctl(1)
    except (ImportError, AttributeError, OSError):
        return 0


def survey(hashed):
    """Print each file: path, size, and of those that are asked for, the hash and whether codegen made the text."""
    wanted = set(hashed)
    folders = [""]
    while folders:
        folder = folders.pop()
        for entry in os.ilistdir(folder or os.getcwd()):
            path = folder + "/" + entry[0] if folder else entry[0]
            if entry[1] & 0x4000:
                folders.append(path)
                print(json.dumps([path + "/", 0, "", False]))
            else:
                size = entry[3] if len(entry) > 3 else os.stat(path)[6]
                about = look(path) if path in wanted else ("", False)
                print(json.dumps([path, size, about[0], about[1]]))


def importable():
    """Print the working folder, then each folder that modules are looked for in, with the names of what is there."""
    print(json.dumps(os.getcwd()))
    for folder in sys.path:
        try:
            print(json.dumps([folder, [entry[0] for entry in os.ilistdir(folder or os.getcwd())]]))
        except OSError:  # .frozen is none, and others need not be there
            pass


def built_in():
    """Print the names of the modules that this MicroPython has itself, in columns; not every build can."""
    try:
        help("modules")
    except NameError:
        pass


def look(path):
    """Return the hash of a file as 64 hexadecimal digits, and whether it begins as what codegen generates."""
    digest = sha256()
    made = False
    with open(path, "rb") as file:
        piece = file.read(512)
        made = piece.startswith(MADE)
        while piece:
            digest.update(piece)
            piece = file.read(512)
    return hexlify(digest.digest()).decode(), made


def show(path):
    """Print a file of text, or nothing where there is none of that name."""
    try:
        with open(path) as file:
            print(file.read())
    except (OSError, UnicodeError):
        pass


def begin():
    """Open PART to be written to."""
    global part  # noqa: PLW0603 - it stays open from call to call
    part = open(PART, "wb")  # noqa: SIM115


def add(data):
    """Write a piece, given in base64."""
    part.write(a2b_base64(data))


def finish(path, digest):
    """Close PART, and give it its name if it is what was sent."""
    part.close()
    if look(PART)[0] != digest:
        raise ValueError(path + " did not arrive whole")
    at = path.find("/")
    while at > 0:
        try:
            os.mkdir(path[:at])
        except OSError:  # it is there
            pass
        at = path.find("/", at + 1)
    move(PART, path)


def move(old, new):
    """Give a file another name, over one that may be there."""
    try:
        os.rename(old, new)
    except OSError:  # FAT does not replace a file
        os.remove(new)
        os.rename(old, new)


def remove(path):
    """Remove a file, and its folder if that is empty then."""
    try:
        os.remove(path)
    except OSError as error:
        if error.errno != 2:  # ENOENT
            raise
    folder = path.rpartition("/")[0]
    if folder and not os.listdir(folder):
        os.rmdir(folder)
