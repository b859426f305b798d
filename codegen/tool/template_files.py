"""The files of the templates: copied as they stand, or with ``$name`` filled in. Jinja's are rendered by render.py.

Files that end in ``.in`` are for output that is made without a project: they need not wait for Jinja.
"""

import os
from collections.abc import Mapping
from functools import cache
from string import Template


@cache
def templates_folder() -> str:
    """The folder of the templates: inside the package when it was installed, beside it in a checkout."""
    package = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    installed = os.path.join(package, "templates")
    return installed if os.path.isdir(installed) else os.path.join(os.path.dirname(package), "templates")


def plain_files(folder: str) -> tuple[str, ...]:
    """The names of the Python files of a template folder that go to the output as they stand."""
    return tuple(sorted(name for name in os.listdir(os.path.join(templates_folder(), folder)) if name.endswith(".py")))


def copied(name: str) -> str:
    """The text of a file below the templates that goes to the output as it stands."""
    with open(os.path.join(templates_folder(), name), "rb") as file:
        return file.read().decode("utf-8")


def driver_text(path: str) -> str:
    """The text of a file of a kind of sensor that goes to the output, by its path below codegen/sources."""
    with open(os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "sources", path), "rb") as file:
        return file.read().decode("utf-8")


def filled(name: str, values: Mapping[str, object]) -> str:
    """The text of the file ``name`` with each ``$key`` replaced; KeyError for one that has no value."""
    return _template(name).substitute(values)


@cache
def _template(name: str) -> Template:
    return Template(copied(name))
