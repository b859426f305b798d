"""Checks the specification, and the claims that documents make about it."""

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING

from codegen.diagnostics import Rule
from codegen.source import Place

if TYPE_CHECKING:
    from codegen.claims.own.worked.listing import Number
    from codegen.claims.reading import Reference
    from codegen.diagnostics import Report

SPECIFICATION_AS_DOCUMENT = Rule(
    "specification-as-document",
    "A table or a dialect of the project is named as a document: codegen check looks at the claims of the documents "
    "that it is given, and at nothing else, so that whatever is wrong in the table would not be found. What the "
    "specification says is checked as a whole, by codegen check without names.",
    remedy="codegen check without names checks the specification",
)


def check_project(project: str, report: "Report", listed: "list[Number] | None") -> list[str]:
    """Report on the specification and on its own documents, which are returned; their examples go to ``listed``."""
    from codegen.commands.document_findings import check_project_documents, project_documents
    from codegen.commands.trace import read_trace_lock
    from codegen.decode.reach import within
    from codegen.load.files import DISK
    from codegen.project.systems import check_scenarios, read_systems

    files = within(project, DISK)
    systems = read_systems(project, report)
    check_scenarios(project, systems, report)
    read_trace_lock(project, report)
    if report.has_errors or not systems:
        return []  # what documents say could not be compared with what is meant
    if listed is not None:
        from codegen.commands import documents

        own, reference = project_documents(systems), documents.project_reference(systems, files)
        listed.extend(documents.example_numbers(own, reference, files))
    return check_project_documents(systems, files, report)


def reference_for(dialect: str | None, project: str | None, report: "Report") -> "Reference | None":
    """Return what documents are compared with. What is wrong with a project is told only where it cannot be used."""
    from codegen.commands import documents
    from codegen.diagnostics import Report
    from codegen.project.systems import read_systems

    if dialect is not None or project is None:
        return documents.dialect_reference(dialect or "common", report)
    found = Report()
    systems = read_systems(project, found)
    if not systems:
        report.extend(found)
        return None
    return documents.project_reference(systems)


def documents_of(paths: Iterable[str], reference: "Reference", report: "Report") -> list[str]:
    """Return the paths that are documents; files of the specification that is compared with are reported."""
    of_specification = {
        os.path.realpath(path)
        for system in reference.systems
        for path in (*system.spec.files, *system.dialect.files)
        if not path.lower().endswith((".md", ".markdown"))
    }
    found = []
    for path in paths:
        if os.path.realpath(path) in of_specification:
            message = "it is a file of the specification and no document: nothing in it was checked"
            report.add(SPECIFICATION_AS_DOCUMENT, Place(path), message)
        else:
            found.append(path)
    return found


def claim_rules() -> list[str]:
    """The ids of the rules about claims."""
    from codegen.findings.catalogue import rule_ids

    return [rule for rule in rule_ids("codegen.claims") if rule.startswith("claim-")]
