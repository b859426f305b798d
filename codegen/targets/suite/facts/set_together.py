"""Facts about quantities that code sets, and that readings forget together."""

from codegen.frozen import dataclass
from codegen.model.quantities.set_together import set_together
from codegen.model.vehicle import Component, Reading
from codegen.targets.suite.cases.messages import first_attribute
from codegen.targets.suite.facts.readings import Settings, switched


@dataclass(frozen=True, slots=True)
class SetTogetherFacts:
    """The attributes that are unknown after so many ``readings`` without one of them set, with the parameters ``off``.

    With ``on`` those that are ``counted`` of readings are not forgotten.
    """

    readings: int
    attributes: tuple[str, ...]
    alone: tuple[str, ...]
    counted: tuple[str, ...]
    on: Settings
    off: Settings
    citation: str


def set_together_facts(component: Component) -> SetTogetherFacts | None:
    """Return what code sets together of a component; None where nothing is."""
    together = set_together(component)
    if together is None:
        return None
    on: dict[str, int] = {}
    off: dict[str, int] = {}
    for reading, _ in together.counted:
        on.update(switched(reading)[0])
        off.update(_off(reading))
    counted = (quantity for _, given in together.counted for quantity in given if quantity.derivation.sums)
    return SetTogetherFacts(
        readings=together.readings,
        attributes=tuple(quantity.attribute for quantity in together.quantities),
        alone=tuple(quantity.attribute for quantity in together.alone),
        counted=tuple(quantity.attribute for quantity in counted),
        on=on,
        off=off,
        citation=component.returns.count.cited("restarting_stale_after") if component.returns else "",
    )


def _off(reading: Reading) -> Settings:
    """Settings with which it is not read, though the component is, and that by its converter."""
    represented = reading.component.readings[0].quantity.derivation.represented
    others = {first_attribute(represented.parameter): represented.steps} if represented else {}
    switch = reading.component.switch
    for settings in switched(reading)[1]:
        is_off = switch is not None and settings.get(first_attribute(switch)) == 0
        if not is_off and not any(settings.get(name) == steps for name, steps in others.items()):
            return settings
    return {}
