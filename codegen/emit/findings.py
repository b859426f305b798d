"""Findings of a plan: files that must not be overwritten, that nobody generates, or that are out of date."""

from codegen.conflict import line_of_conflict
from codegen.diagnostics import Report, Rule, Severity
from codegen.emit.plan import Change, Plan, PlannedFile

EDITED_BY_HAND = Rule(
    "edited-by-hand",
    "A generated file was changed by hand since codegen wrote it, and what would be written now would undo that. "
    "Nothing was written. Move the change to the specification or the template, or give it up with build --force; "
    "build --diff shows what would be lost.",
    remedy="look at it with --diff, or undo the edit with --force",
)
FOREIGN_FILE = Rule(
    "foreign-file",
    "A file that codegen did not write is where a generated file belongs, and its content differs. Nothing was "
    "written. Move the file away, or let build --force overwrite it.",
    remedy="move it away, or overwrite it with --force",
)
NO_LONGER_GENERATED = Rule(
    "no-longer-generated",
    "An earlier build wrote this file, and nothing in the specification asks for it any more. A module or a test that "
    "nobody has edited is removed by each build; what else there is by build --clean, and what was edited by hand only "
    "together with --force.",
    Severity.WARNING,
)
STRAY_FILE = Rule(
    "stray-file",
    "A file in the output folder that codegen neither wrote nor knows. It is never removed: the output folder is for "
    "generated files, so move it elsewhere.",
    Severity.WARNING,
)
STALE_OUTPUT = Rule(
    "stale-output",
    "A file of the output folder is not what the specification generates now: it is missing, out of date, edited by "
    "hand, or no longer generated. Run the command without --check and commit the result.",
    remedy="run codegen build, and commit what it changes",
)

_STALE = {
    Change.NEW: ("it is missing", "run the command without --check"),
    Change.CHANGED: ("it is out of date", "run the command without --check"),
    Change.EDITED: ("it was edited by hand", "--force undoes the edit, --diff shows it"),
    Change.FOREIGN: ("it was not written by codegen", "move it away, or overwrite it with --force"),
    Change.ORPHAN: ("it is no longer generated", "--clean removes it"),
    Change.EDITED_ORPHAN: (
        "it is no longer generated, and was edited by hand",
        "--clean --force removes it",
    ),
}


def report_refusals(plan: Plan, report: Report) -> None:
    """Report the files that forbid the build (errors, unless it is forced), and those that will stay behind."""
    if not plan.force:
        for file in plan.those(Change.EDITED):
            message, hint = _of_conflict(file) or ("it was edited by hand", "--diff shows the edit, --force undoes it")
            report.add(EDITED_BY_HAND, plan.place(file.path), f"{message}, so nothing is written", hint)
        for file in plan.those(Change.FOREIGN):
            message, hint = _of_conflict(file) or (
                "this file, which codegen did not write, is in the way",
                "move it away, or overwrite it with --force",
            )
            report.add(FOREIGN_FILE, plan.place(file.path), f"{message}, so nothing is written", hint)
    for file in plan.those(Change.ORPHAN, Change.EDITED_ORPHAN):
        if file not in plan.removals:
            message, _ = _STALE[file.change]
            flags = "--clean" if file.change is Change.ORPHAN else "--clean --force"
            report.add(NO_LONGER_GENERATED, plan.place(file.path), message, f"{flags} removes it")


def report_stale(plan: Plan, report: Report) -> None:
    """Report, as errors, every file that the folder has otherwise than the specification generates it."""
    for file in plan.those(*_STALE):
        message, hint = _STALE[file.change]
        if file in plan.removals:
            hint = "run the command without --check, which removes it"
        message, hint = _of_conflict(file) or (message, hint)
        report.add(STALE_OUTPUT, plan.place(file.path), message, hint)


def report_strays(plan: Plan, report: Report) -> None:
    """Warn of the files that do not belong to the output folder."""
    for path in plan.strays:
        report.add(STRAY_FILE, plan.place(path), "codegen does not know this file", "move it out of the output folder")
    if not plan.clean:
        for path in plan.leftovers:
            message = "an interrupted build left this unfinished file behind"
            report.add(STRAY_FILE, plan.place(path), message, "--clean removes it")


def _of_conflict(file: PlannedFile) -> tuple[str, str] | None:
    """Return the message and the hint about a file in which git has left both sides of a merge; None for any other."""
    if file.old is None or line_of_conflict(file.old.decode("utf-8", "replace")) is None:
        return None
    return "a conflict of a merge is open in it", "--force writes it anew: merge the specification alone"
