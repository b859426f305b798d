"""View of parameters.py: each parameter in whole steps."""

from codegen.frozen import dataclass
from codegen.model.system import System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import Parameter
from codegen.targets.imports import text_literals
from codegen.targets.naming import parameter_attribute, prose


@dataclass(frozen=True, slots=True)
class ParameterView:
    """One parameter; the value is ``steps * numerator / denominator`` in ``unit``.

    ``type`` is the number of its MAV_PARAM_TYPE; ``choices`` are the only steps that are accepted, or nothing,
    and ``has_gaps`` says that not all from ``minimum`` to ``maximum`` are among them. ``is_renamed`` says
    that the attribute is not the name in small letters. ``was`` are names of earlier firmware, each with the numerator
    and the denominator of what its values are multiplied by. ``literals`` are the line of text that has its numbers.
    """

    name: str
    attribute: str
    is_renamed: bool
    default: int
    minimum: int
    maximum: int
    numerator: int
    denominator: int
    type: int
    type_name: str
    after_restart: bool
    choices: tuple[int, ...]
    has_gaps: bool
    comment: str
    doc: str
    was: tuple[tuple[str, int, int], ...]

    @property
    def literals(self) -> tuple[str, ...]:
        """The line in which the firmware has all that it knows of the parameter but its default."""
        limits = (self.minimum, self.maximum, self.numerator, self.denominator)
        accepted = self.choices if self.has_gaps else ()
        words = (f"\\n{self.name}", *limits, self.type, int(self.after_restart), *accepted)
        return text_literals(words, indent=4)


def parameter_views(system: System) -> tuple[ParameterView, ...]:
    """The parameters in the order of their names."""
    enum = system.dialect.enums.get("MAV_PARAM_TYPE")
    types = {entry.name.removeprefix("MAV_PARAM_TYPE_").lower(): entry.value for entry in enum.entries} if enum else {}
    return tuple(_parameter(system.parameters[name], types) for name in sorted(system.parameters))


def _parameter(parameter: Parameter, types: dict[str, int]) -> ParameterView:
    unit = f" {parameter.unit.name}" if parameter.unit.name else ""
    step = "" if parameter.step == 1 else f", in steps of {decimal(parameter.step)}{unit}"
    attribute = parameter_attribute(parameter.name)
    choices = tuple(sorted(parameter.choices))
    meaning = parameter.choices.get(parameter.default)
    return ParameterView(
        name=parameter.name,
        attribute=attribute,
        is_renamed=attribute != parameter.name.lower(),
        default=parameter.default,
        minimum=parameter.minimum,
        maximum=parameter.maximum,
        numerator=parameter.step.numerator,
        denominator=parameter.step.denominator,
        type=types.get(parameter.spec.type.value, 0),
        type_name=parameter.spec.type.value,
        after_restart=parameter.spec.reboot,
        choices=choices,
        has_gaps=bool(choices) and choices != tuple(range(parameter.minimum, parameter.maximum + 1)),
        comment=f"{decimal(parameter.default * parameter.step)}{unit}{step}{f': {prose(meaning)}' if meaning else ''}",
        doc=prose(parameter.spec.doc),
        was=tuple((old, factor.numerator, factor.denominator) for old, factor in sorted(parameter.spec.was.items())),
    )
