"""Modules of the program get the numbers of the dialect as constants of their own."""

import pytest

from codegen.targets.firmware.numbers import with_numbers

MODULE = '''"""What it is about."""

import time

import dialect
from micropython import const
from other import (
    one,
    two,
)

_OWN = const(3)


def answer():
    """Return dialect.MAV_B, or else dialect.MAV_A."""
    return dialect.MAV_B or dialect.MAV_A or one
'''


def test_constants_stand_below_the_imports() -> None:
    """Each once, sorted; nothing is imported for them any more."""
    text = with_numbers(MODULE, {"MAV_A": 7, "MAV_B": 8, "MAV_C": 9})
    start, _, end = text.partition(")\n\n# Numbers of the dialect.\n_MAV_A = const(7)\n_MAV_B = const(8)\n\n_OWN")
    assert start.endswith("import time\n\nfrom micropython import const\nfrom other import (\n    one,\n    two,\n")
    assert end.endswith("    return _MAV_B or _MAV_A or one\n")


def test_other_modules_stay_as_they_are() -> None:
    """Without a number nothing is changed."""
    assert with_numbers("import time\n", {"MAV_A": 7}) == "import time\n"


def test_a_number_that_is_not_listed_is_no_number() -> None:
    """A template that uses a number has to list it."""
    with pytest.raises(KeyError, match="MAV_B"):
        with_numbers(MODULE, {"MAV_A": 7})
