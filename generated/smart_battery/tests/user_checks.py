# Generated from templates/tests/program/user_checks.py: do not edit.
# Inputs: 8b8764774b3744c2
"""The user's module: its class is what the board starts, if it is a vehicle."""

import sys

from program_bench import main, needs
from program_facts import USER


class Module:
    """Stands in for the user's module."""


def _started():
    """Return what main.py takes for the class of the vehicle."""
    import main as program  # noqa: PLC0415

    return program.vehicle_class()


def its_class_is_taken():
    """One that is derived from Vehicle is; another one is a fault that names both; without the module it is Vehicle."""
    import vehicle  # noqa: PLC0415

    name, class_name = USER
    before = sys.modules.get(name)

    class Own(vehicle.Vehicle):
        """A vehicle of the user's."""

    try:
        module = sys.modules[name] = Module()
        setattr(module, class_name, Own)
        assert _started() is Own
        setattr(module, class_name, Module)
        told = ""
        try:
            _started()
        except TypeError as error:
            told = str(error)
        assert f"{name}.{class_name}" in told, told
    finally:
        del sys.modules[name]
        if before is not None:
            sys.modules[name] = before


def without_it_there_is_a_vehicle():
    """A board that has only the firmware runs it."""
    import vehicle  # noqa: PLC0415

    try:
        __import__(USER[0])
    except ImportError:
        assert _started() is vehicle.Vehicle
        return
    needs(False, "a board without the user's module")


CHECKS = (
    (its_class_is_taken,),
    (without_it_there_is_a_vehicle,),
)

if __name__ == "__main__":
    main(CHECKS)
