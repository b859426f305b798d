"""Views of families of parameters: where generated code depends on the instance, it finds the name in a tuple."""

from collections.abc import Iterable

from codegen.frozen import dataclass
from codegen.model.vehicle import Parameter
from codegen.targets.naming import family_constant, parameter_attribute, quoted


@dataclass(frozen=True, slots=True)
class FamilyView:
    """A constant of a module, with the attributes of a family by instance."""

    constant: str
    attributes: tuple[str, ...]


def family_view(parameter: Parameter) -> FamilyView:
    """The view of the family that a parameter belongs to."""
    return FamilyView(family_constant(parameter), tuple(map(parameter_attribute, parameter.siblings)))


def family_lines(parameters: Iterable[Parameter]) -> tuple[str, ...]:
    """The constants of families as lines of a module, below what they are; nothing where there is no family."""
    families = [family_view(parameter) for parameter in parameters]
    constants = [f"{family.constant} = ({', '.join(map(quoted, family.attributes))})" for family in families]
    return ("# Names of the parameters that each has of its own.", *constants) if families else ()
