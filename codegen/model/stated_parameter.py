"""A parameter of a project as documents may state it."""

from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.units.unit import Unit


@dataclass(frozen=True, slots=True)
class StatedParameter:
    """Values in ``unit``; ``index`` is its place in the list of ``count`` parameters, ``type`` its MAV_PARAM_TYPE."""

    name: str
    unit: Unit
    default: Fraction
    minimum: Fraction
    maximum: Fraction
    step: Fraction
    type: str
    index: int
    count: int
