"""Checks the release of pymavlink that a project was reviewed with: another one is told before its consequences."""

import os

from codegen.diagnostics import Report, Rule
from codegen.load.files import Files
from codegen.load.shipped import shipped_dialect_path
from codegen.model.spec.spec import Project

OTHER_DIALECT_VERSION = Rule(
    "other-dialect-version",
    "codegen.yaml states the release of pymavlink that the specification was reviewed with, dialect_version, and "
    "another one is installed: its dialects may lay out messages differently, or state other sentinels. Look at what "
    "differs with codegen diff, then state the new release; or install the one that is stated.",
    unreadable=True,
)
SOURCE = "pymavlink"


def is_stated_version(project: Project, files: Files, report: Report) -> bool:
    """Return whether the dialects are those that a project states, or it states none; else a finding says how to
    compare them.

    A release that a command was given in place of the installed one is compared as it is.
    """
    stated = project.dialect_version
    if stated is None or files.dialects is not None:
        return True
    from importlib import metadata  # noqa: PLC0415  takes longer to import than most builds have to wait

    try:
        installed = f"{SOURCE} {metadata.version(SOURCE)}"
    except metadata.PackageNotFoundError:
        installed = f"no {SOURCE}"
    if " ".join(stated.split()) == installed:
        return True
    wanted = stated.split()[-1]
    path = shipped_dialect_path(os.path.splitext(os.path.basename(project.dialect))[0], files)
    name = "common" if path is None else os.path.splitext(os.path.basename(path))[0]
    hint = (
        f"what differs: pip download --no-deps {SOURCE}=={wanted}, then codegen diff {SOURCE}-{wanted}-....whl:{name} "
        f"{name}; then state it: dialect_version: {installed}. codegen diff reads what states "
        f"{wanted} with that file at --base-pymavlink or --head-pymavlink"
    )
    report.add(OTHER_DIALECT_VERSION, project.at("dialect_version"), f"{installed} is installed, not {stated}", hint)
    return False
