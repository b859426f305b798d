"""The difference that a build would make, as a patch."""

from collections.abc import Iterator
from difflib import unified_diff

from codegen.emit.plan import Change, Plan, PlannedFile
from codegen.source import shown_path


def differences(plan: Plan, base: str | None = None) -> Iterator[str]:
    """One patch for each file that would become another one, as ``git apply`` and ``patch -p1`` read it.

    Paths are relative to ``base`` (default: the working directory), or to the output folder if that lies elsewhere.
    A hand edit is shown with what would undo it, forced or not; a file that would be removed is shown only if the
    plan cleans.
    """
    removals = plan.removals
    for file in plan.files:
        if file.change is Change.UNCHANGED or (file.new is None and file not in removals):
            continue
        shown = shown_path(plan.place(file.path).file, base)
        yield _patch(file, file.path if shown.startswith("/") else shown.replace("\\", "/"))


def _patch(file: PlannedFile, path: str) -> str:
    head = f"diff --git a/{path} b/{path}\n"
    before, after = f"a/{path}", f"b/{path}"
    if file.old is None:
        head += "new file mode 100644\n"
        before = "/dev/null"
    if file.new is None:
        head += "deleted file mode 100644\n"
        after = "/dev/null"
    try:
        old, new = _lines(file.old), _lines(file.new)
    except UnicodeDecodeError:
        return f"{head}Binary files {before} and {after} differ\n"
    patch = unified_diff(old, new, before, after)
    return head + "".join(line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in patch)


def _lines(content: bytes | None) -> list[str]:
    """The lines with their ends; only a line feed ends a line, as patches have it."""
    lines = (content or b"").decode("utf-8").split("\n")
    return [f"{line}\n" for line in lines[:-1]] + ([lines[-1]] if lines[-1] else [])
