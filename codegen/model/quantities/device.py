"""The model of a sensor's device in the generated suite: what it shows, and the amounts that it shows so."""

from collections.abc import Mapping
from fractions import Fraction
from typing import NamedTuple

from codegen.model.units.unit import Unit


class Exact(NamedTuple):
    """An exact amount in a unit."""

    value: Fraction
    unit: Unit


class Shown(NamedTuple):
    """One state of a device: ``settings`` as its model takes them, and by the names of outputs what that stands for."""

    settings: Mapping[str, object]
    amounts: Mapping[str, Exact]


class Device(NamedTuple):
    """A device as the tables connect it: the ``module`` of the suite has a class Device that is made with ``settings``.

    Its show(settings, turn) lets it show one state after another; it calls ``turn`` where the sensor has to be asked
    meanwhile. ``check()`` says what is wrong with what the driver has set, or nothing.
    """

    module: str
    settings: Mapping[str, object]
    shows: tuple[Shown, ...]
