"""Views of families of parameters: where generated code depends on the instance, it finds the name in a tuple."""

from codegen.frozen import dataclass
from codegen.model.vehicle import Parameter
from codegen.targets.naming import family_constant, parameter_attribute


@dataclass(frozen=True, slots=True)
class FamilyView:
    """A constant of a module, with the attributes of a family by instance."""

    constant: str
    attributes: tuple[str, ...]


def family_view(parameter: Parameter) -> FamilyView:
    """The view of the family that a parameter belongs to."""
    return FamilyView(family_constant(parameter), tuple(map(parameter_attribute, parameter.siblings)))
