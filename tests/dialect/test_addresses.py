"""Where a message says whom it is for, and where a field of that name is a value."""

from collections.abc import Callable

import pytest

XML = (
    '<mavlink><messages><message id="70000" name="{}"><field type="{}" name="{}"{}>Where to.</field>'
    '<field type="uint8_t" name="target_component">Which.</field></message></messages></mavlink>'
)


@pytest.mark.parametrize(
    ("message", "kind", "name", "more", "targets"),
    [
        ("SETPOINT", "uint8_t", "target_system", "", (0, 1)),
        ("MANUAL_CONTROL", "uint8_t", "target", "", (0, 1)),
        ("SETPOINT", "uint8_t", "target", "", ()),
        ("SETPOINT", "float", "target", ' units="m/s"', ()),
        ("MANUAL_CONTROL", "float", "target", "", ()),
        ("SETPOINT", "int8_t", "target_system", "", ()),
        ("SETPOINT", "uint8_t[2]", "target_system", "", ()),
        ("SETPOINT", "uint8_t", "target_system", ' units="m"', ()),
    ],
)
def test_an_address(message: str, kind: str, name: str, more: str, targets: tuple[int, ...], read: Callable) -> None:
    """A speed called target was compared with the number of the system, and most of them were left alone."""
    assert read(XML.format(message, kind, name, more)).dialect.messages[message].targets == targets
