"""A plugin of pytest: ``@pytest.mark.requirement("FR-00068.3")`` says what a test shows, also in JUnit's results.

To be switched on in a project's pytest settings: ``addopts = "-p codegen.pytest_plugin"``. The generated suites do the
same by themselves. Results also say with which specification they were made.
"""

from collections.abc import Iterable
from typing import Any

import pytest

_HANDED_ON = "codegen_specification"


def pytest_configure(config: Any) -> None:
    """Make the marker known (pytest's ``Config``)."""
    config.addinivalue_line("markers", "requirement(*criteria): the criteria that a test shows, such as FR-00068.3")


@pytest.hookimpl(optionalhook=True)
def pytest_configure_node(node: Any) -> None:
    """Tell a process of pytest-xdist (its ``WorkerController``) the hash: all of a run have the same."""
    node.workerinput[_HANDED_ON] = _specification(node.config)


def pytest_collection_modifyitems(config: Any, items: Iterable[Any]) -> None:
    """Note for the results what each test (pytest's ``Item``) shows, once each, and with which specification."""
    marked = [item for item in items if item.get_closest_marker("requirement")]
    specification = _specification(config) if marked else None
    if specification is not None:
        from codegen.model.test_record import SPECIFICATION_PROPERTY  # noqa: PLC0415

        for item in marked:
            item.user_properties.append((SPECIFICATION_PROPERTY, specification))
    for item in marked:
        for mark in item.iter_markers("requirement"):
            for name in mark.args:
                if ("requirement", name) not in item.user_properties:
                    item.user_properties.append(("requirement", name))


def _specification(config: Any) -> str | None:
    """The hash of the specification that tests run with; None where nobody writes results, or nothing was generated."""
    handed_on = getattr(config, "workerinput", None)
    if handed_on is not None:
        found: str | None = handed_on.get(_HANDED_ON)
        return found
    if not getattr(config.option, "xmlpath", None):
        return None
    from codegen.project import nearest_project  # noqa: PLC0415  a run without results has no use for them
    from codegen.project.built_specification import built_specification  # noqa: PLC0415

    project = nearest_project(str(config.rootpath))
    return None if project is None else built_specification(project)
