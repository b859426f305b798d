"""pymavlink as the judge: it shares no code with the generator or the firmware.

The dialect that pymavlink ships is used as it is. Where a message is not in it, but in the project's own XML,
pymavlink's generator makes a dialect of both, with what the project's corrections change of ids, types and entries.
Of the shipped XML only the messages that are asked for are taken: the hundreds of others would take most of the time.
Fields with names that Python cannot have there get others for it, and their messages keep their CRC_EXTRA.
"""

import contextlib
import importlib
import importlib.util
import io
import keyword
import tempfile
from pathlib import Path
from unittest.mock import patch
from xml.etree import ElementTree
from zlib import crc32

import pymavlink
from pymavlink.generator import mavgen, mavparse

DIALECTS = (Path(pymavlink.__file__).parent / "dialects" / "v20").resolve()
WIRES = {"v20": "2.0", "v10": "1.0"}
RENAMED = "_in_python"  # behind the names of fields that pymavlink's generator cannot have


def dialects(about, messages, here, also=()):
    """Return pymavlink's modules for MAVLink 2 and 1.

    `about` names the XML files, relative to `here`, and has the corrections of what is sent. They have `messages`, and
    of `also` those that there are.
    """
    if about["shipped"]:
        newest = shipped("v20", about["shipped"])
        if all(message_class(newest, message) for message in messages):
            return [newest, shipped("v10", about["shipped"])]
    files = [DIALECTS / f"{about['shipped']}.xml"] if about["shipped"] else []
    files += [(here / path).resolve() for path in about["files"]]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        plain = [_plain(file, folder, about.get("corrections", ()), {*messages, *also}) for file in files]
        source = folder / "project.xml"
        includes = "".join(f"<include>{file}</include>" for file in plain)
        source.write_text(f'<?xml version="1.0"?><mavlink>{includes}<messages></messages></mavlink>')
        return [_generated(source, wire) for wire in WIRES]


def shipped_names(about, here):
    """Return the names of the shipped dialects whose entries a project has: the one it names, and those it includes."""
    found = [about["shipped"]] if about["shipped"] else []
    own = [(here / path).resolve() for path in about["files"]]
    for file in own:  # it grows
        for element in ElementTree.parse(file).iter("include"):
            included = _included(file, element)
            if included.parent == DIALECTS:
                found.append(included.stem)
            elif included not in own:
                own.append(included)
    return list(dict.fromkeys(found))


def shipped(wire, name):
    """Return pymavlink's module of a dialect that it ships: of wire v20 or v10."""
    return importlib.import_module(f"pymavlink.dialects.{wire}.{name}")


def message_class(dialect, name):
    """Return pymavlink's class of a message, or None where the dialect does not have it."""
    return getattr(dialect, f"MAVLink_{name.lower()}_message", None)


def _generated(source, wire):
    """Return the module that pymavlink's generator makes of an XML file, for a version of the protocol."""
    output = source.with_name(f"project_{wire}.py")
    options = mavgen.Opts(str(output), wire_protocol=WIRES[wire], language="Python3", validate=False)
    quiet = contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO())
    with quiet[0], quiet[1], patch.object(mavparse, "message_checksum", _checksum):
        mavgen.mavgen(options, [str(source)])
    spec = importlib.util.spec_from_file_location(f"project_{wire}", output)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    _call_by_name(module)
    return module


def _plain(file, folder, corrections, messages):
    """Return a corrected copy of an XML file, without descriptions: pymavlink's generator stumbles over quotes.

    There is one of each file, however many include it. Of a shipped file it has only `messages`, and no enums, which
    are not on the wire.
    """
    is_shipped = file.parent == DIALECTS
    copy = folder / (file.name if is_shipped else f"own_{crc32(str(file).encode())}.xml")
    if copy.exists():
        return copy
    copy.touch()  # files that include one another end here
    tree = ElementTree.parse(file)
    if is_shipped:
        for group in tree.iter("enums"):
            group.clear()
        for group in tree.iter("messages"):
            group[:] = [message for message in group if message.get("name") in messages]
    for correction in corrections:
        _correct(tree, correction)
    if not is_shipped:
        _rename(tree)
    for element in tree.iter():
        if element.tag == "description" or (element.tag in ("field", "param") and element.text):
            element.text = ""
        if element.tag == "include":
            element.text = str(_plain(_included(file, element), folder, corrections, messages))
    tree.write(copy)
    return copy


def _rename(tree):
    """Give fields other names for pymavlink whose names are words of Python, or are taken in pymavlink's classes.

    Fields called id and name stay: messages of shipped dialects have them, and nothing of a class asks for its own.
    """
    taken = {"self", "force_mavlink1", *dir(message_class(shipped("v20", "minimal"), "heartbeat"))} - {"id", "name"}
    for field in tree.iter("field"):
        name = field.get("name")
        if keyword.iskeyword(name) or name in taken:
            field.set("name", name + RENAMED)


def _checksum(message, checksum=mavparse.message_checksum):
    """Return the CRC_EXTRA of a message, as pymavlink computes it, with the names that its fields have on the wire."""
    names = [field.name for field in message.ordered_fields]
    for field, name in zip(message.ordered_fields, names, strict=True):
        field.name = name.removesuffix(RENAMED)
    extra = checksum(message)
    for field, name in zip(message.ordered_fields, names, strict=True):
        field.name = name
    return extra


def _call_by_name(module):
    """Let messages of pymavlink be made with the true names of their fields, and tell these."""
    for known in module.mavlink_map.values():
        renamed = {name.removesuffix(RENAMED): name for name in known.fieldnames if name.endswith(RENAMED)}
        if renamed:
            known.fieldnames = [name.removesuffix(RENAMED) for name in known.fieldnames]
            known.ordered_fieldnames = [name.removesuffix(RENAMED) for name in known.ordered_fieldnames]
            known.__init__ = _renaming(known.__init__, renamed)


def _renaming(make, renamed):
    def made(self, /, *values, **named):
        make(self, *values, **{renamed.get(name, name): value for name, value in named.items()})

    return made


def _included(file, element):
    """Return the file that a file includes: one beside it, or a shipped one."""
    beside = (file.parent / element.text.strip()).resolve()
    return beside if beside.exists() else DIALECTS / element.text.strip()


def _correct(tree, correction):
    """Set the attributes of one correction, where the file has what it is about."""
    group, inner = ("message", "field") if "message" in correction else ("enum", "entry")
    for element in tree.iter(group):
        if element.get("name") == correction[group]:
            parts = [part for part in element.iter(inner) if part.get("name") == correction.get(inner)]
            for target in parts if inner in correction else [element]:
                target.attrib.update(correction["set"])
