"""Every unit that a shipped dialect uses is known to the generator."""

from pathlib import Path

import pymavlink
import pytest
from lxml import etree

from codegen.model.unit import UNITS

FOLDER = Path(pymavlink.__file__).parent / "dialects" / "v20"


@pytest.mark.parametrize("path", sorted(FOLDER.glob("*.xml")), ids=lambda path: path.stem)
def test_units_are_known(path):
    """A field in an unknown unit could not be populated."""
    used = {field.get("units") for field in etree.parse(path).iter("field")} - {None}
    assert used - set(UNITS) == set()
