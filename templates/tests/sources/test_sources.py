"""The checks of sources_behaviour.py, in one run of each interpreter; a test is named by its sensor and check."""

import pytest
from interpreters import checks_of
from source_facts import CRITERIA, SOURCES


def _checks():
    """Return aspect and name of each check."""
    for aspect, check in (entry.elts for entry in checks_of("sources_behaviour.py")):
        yield aspect.value, check.id


def _cases():
    for interpreter in ("cpython", "micropython"):
        for source in SOURCES:
            for aspect, check in _checks():
                criterion = CRITERIA[source["name"]].get(aspect)
                shows = [pytest.mark.requirement(criterion)] if criterion else []
                name = f"{source['name']}-{check}"
                yield pytest.param((interpreter, name), id=f"{interpreter}-{name}", marks=shows)


@pytest.mark.parametrize("case", list(_cases()))
def test_source(case, printed):
    """The sensor is asked, kept and told of as the specification says."""
    interpreter, name = case
    found = printed(interpreter, "sources_behaviour.py")
    assert "" not in found, found[""]
    assert found[name] is None, found[name]
