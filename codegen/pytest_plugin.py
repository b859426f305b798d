"""For pytest: ``@pytest.mark.requirement("FR-00068.3")`` says what a test shows, and JUnit's results say so, too.

To be switched on in a project's pytest settings: ``addopts = "-p codegen.pytest_plugin"``. The generated suites do the
same by themselves.
"""

from collections.abc import Iterable
from typing import Any


def pytest_configure(config: Any) -> None:
    """Make the marker known (pytest's ``Config``)."""
    config.addinivalue_line("markers", "requirement(*criteria): the criteria that a test shows, such as FR-00068.3")


def pytest_collection_modifyitems(items: Iterable[Any]) -> None:
    """Note for the results what each test (pytest's ``Item``) shows, once each."""
    for item in items:
        for mark in item.iter_markers("requirement"):
            for name in mark.args:
                if ("requirement", name) not in item.user_properties:
                    item.user_properties.append(("requirement", name))
