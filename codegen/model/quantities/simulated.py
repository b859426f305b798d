"""The mock through which true values of a quantity reach the firmware on a host."""

from collections.abc import Mapping
from dataclasses import field
from typing import Any

from codegen.frozen import dataclass


@dataclass(frozen=True, slots=True)
class SimulatedInput:
    """The mock that true values of one quantity go through, as numbers in the unit of the quantity.

    ``kind`` names its module among the mocks, ``sim_<kind>.py``, whose ``connect()`` gets all inputs of that kind;
    ``settings`` is plain data that it has to know. ``faults`` are those that it can have, with what each means.
    """

    kind: str
    settings: Mapping[str, Any] = field(default_factory=dict)
    faults: Mapping[str, str] = field(default_factory=dict)
