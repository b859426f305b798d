"""States that pages show a message in: what is measured is known, nothing is, or everything is."""

from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.answers.known import Known, Stored
from codegen.model.quantities.conversion import Conversion
from codegen.model.system import PopulatedMessage, System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import Quantity
from codegen.targets.suite.cases.messages import used_quantities
from codegen.targets.suite.expected import converted, is_withheld, nominal_values


@dataclass(frozen=True, slots=True)
class ExampleState:
    """A state of the vehicle with words for it; ``known`` has every quantity that the message reads."""

    label: str
    known: Known


def example_states(message: PopulatedMessage, system: System) -> tuple[ExampleState, ...]:
    """The states that a message is sent in, the most telling one first; one for a message that reads nothing."""
    used = used_quantities(message, system)
    start = {path: _at_start(quantity) for path, quantity in used.items()}
    if not used:
        return (ExampleState("whatever the state is", {}),)
    states = []
    readings = {quantity.path: (quantity, conversion) for _, quantity, conversion in system.measured()}
    measured = {path: _measured(*readings[path]) for path in used if path in readings}
    if measured:
        shown = ", ".join(f"{path} {_in_unit(value, used[path])}" for path, value in measured.items())
        rest = ", all else as at the start" if len(used) > len(measured) else ""
        states.append(ExampleState(f"{shown}{rest}", {**start, **measured}))
    states.append(ExampleState("at the start: nothing measured yet", start))
    every = {path: nominal_values(quantity, 0) for path, quantity in used.items()}
    switched = {path: value for path, value in start.items() if used[path].derivation.switch is not None}
    states.append(ExampleState("a value in every quantity", {**every, **switched, **measured}))
    return _different([state for state in states if not is_withheld(message, state.known)])


def _different(states: list[ExampleState]) -> tuple[ExampleState, ...]:
    found: dict[tuple[tuple[str, Stored], ...], ExampleState] = {}
    for state in states:
        found.setdefault(tuple(state.known.items()), state)
    return tuple(found.values())


def _at_start(quantity: Quantity) -> Stored:
    """Return what a quantity is when the vehicle starts: that of the first instance, with the parameters' defaults."""
    switch = quantity.derivation.switch
    if switch is not None:
        return int(switch.default != 0)
    return (None,) * quantity.elements[0] if quantity.elements else quantity.initial


def _measured(quantity: Quantity, conversion: Conversion) -> int:
    """A round value that the ADC can measure: the largest whole unit up to 95 % of full scale, or half of it."""
    offset = conversion.offset.default if conversion.offset else 0
    full = converted(quantity, conversion, conversion.channel.full_scale, conversion.multiplier.default, offset)
    whole = int(Fraction(full * 95, 100) / quantity.steps)
    return int(whole * quantity.steps) if whole else full // 2


def _in_unit(stored: int, quantity: Quantity) -> str:
    return f"{decimal(Fraction(stored) / quantity.steps)} {quantity.unit.name}".strip()
