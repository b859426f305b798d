"""Compiled modules import names from where they are made."""

import pytest

from codegen.emit.direct_imports import direct

PASSING = '"""What is passed on."""\n# ruff: noqa\n\nfrom plain import (\n    first,\n    second,\n)\n'
MADE = "first = 1\nsecond = 2\n"
ASKS = """\
import passing
import passing as it
from passing import first

def later():
    from passing import (
        second,
    )
"""
DIRECT = """\
import plain as passing
import plain as it
from plain import first

def later():
    from plain import (
        second,
    )
"""


def test_a_module_that_only_passes_names_on_is_passed_by() -> None:
    """However it is imported, and wherever; itself it stays."""
    made = direct({"passing": PASSING, "plain": MADE, "asks": ASKS})
    assert made == {"passing": PASSING, "plain": MADE, "asks": DIRECT}


def test_several_in_a_row_are_passed_by() -> None:
    texts = {"passing": PASSING, "plain": MADE, "further": "from passing import first\n"}
    assert direct({**texts, "asks": "from further import first\n"})["asks"] == "from plain import first\n"


@pytest.mark.parametrize(
    "passing",
    [
        f"{PASSING}third = 3\n",
        "from plain import first as second\n",
        "from plain import *\n",
        "import plain\n",
        "from elsewhere import first\n",
        "",
    ],
)
def test_everything_else_stays(passing: str) -> None:
    """A module that does more, that gives other names, or that passes on what is not among these."""
    texts = {"passing": passing, "plain": MADE, "asks": ASKS}
    assert direct(texts) == texts
