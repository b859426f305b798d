"""The time of a review of two pymavlink releases, process against process: against pymavlink's own parser."""

import sys
from functools import partial
from pathlib import Path

import measure
from figure import Figure

COMPARES = """codegen diff as a process of its own, from an older wheel to the installed pymavlink, each dialect with
all that it includes, against a process that only parses the same XML files of both with pymavlink's parser: it
compares nothing, keeps no places and prints no report."""

DIALECTS = ("common", "all")
ROUNDS = 7

PARSE = """
import os, sys, zipfile, tempfile
from pymavlink.generator import mavparse
name, wheel, installed = sys.argv[1:]
def parse(path, seen):
    if path in seen:
        return
    seen.add(path)
    xml = mavparse.MAVXML(path, mavparse.PROTOCOL_2_0)
    for include in xml.include:
        parse(os.path.normpath(os.path.join(os.path.dirname(path), include)), seen)
with tempfile.TemporaryDirectory() as folder, zipfile.ZipFile(wheel) as archive:
    for member in archive.namelist():
        if "/v20/" in member and member.endswith(".xml"):
            with open(os.path.join(folder, os.path.basename(member)), "wb") as file:
                file.write(archive.read(member))
    parse(os.path.join(folder, name + ".xml"), set())
parse(installed, set())
"""


def figures(quick: bool) -> list[Figure]:
    """Run everything, and compare."""
    wheels = sorted((Path(sys.prefix) / "releases").glob("pymavlink-*.whl"))
    found = []
    with measure.scratch(in_memory=True) as folder:
        for dialect in DIALECTS[: 1 if quick else None]:
            value = _ratio(dialect, wheels[0], folder, 1 if quick else ROUNDS) if wheels else None
            note = "" if wheels else "no older pymavlink: make test fetches one"
            what = f"codegen diff of two releases, {dialect}.xml"
            found.append(Figure(f"diff_{dialect}_over_parsing", what, "pymavlink's parser", value, note=note))
    return found


def _ratio(dialect: str, wheel: Path, folder: Path, rounds: int) -> float:
    compare = [measure.tool("codegen"), "diff", f"{wheel}:{dialect}", f"pymavlink:{dialect}", "--fail-on", "never"]
    parse = [sys.executable, "-c", PARSE, dialect, str(wheel), measure.dialect(dialect)]
    contestants = {"codegen": partial(_seconds, compare, folder), "pymavlink": partial(_seconds, parse, folder)}
    times = measure.best(contestants, rounds)
    return times["codegen"] / times["pymavlink"]


def _seconds(command: list[str], folder: Path) -> float:
    return measure.weighed(command, folder).seconds


if __name__ == "__main__":
    measure.run(COMPARES, figures)
