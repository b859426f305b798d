"""Cases of messages that are about one of several instances: which of them is chosen, and that its values go out."""

from collections.abc import Iterator, Mapping, Sequence

from codegen.model.answers.known import Known, Stored
from codegen.model.system import Policy, PopulatedMessage, Representation
from codegen.model.vehicle import Quantity, QuantityKind
from codegen.targets.naming import parameter_attribute
from codegen.targets.suite.cases.case import MessageCase, Setting, set_to
from codegen.targets.suite.expected import chosen_instance, expected_fields, nominal, nominal_values


def representation_cases(message: PopulatedMessage, used: Mapping[str, Quantity]) -> Iterator[MessageCase]:
    """Yield the states in which another instance is chosen, for each choice; ``used`` are the quantities it reads."""
    for choice in message.represents.values():
        if choice.component.instances == 1:
            continue
        others: dict[str, Stored] = {
            path: nominal_values(quantity, 0)
            for path, quantity in used.items()
            if quantity.component != choice.component.name
        }
        for name, instances in _states(choice, used):
            number = chosen_instance(choice, instances)
            settings: list[Setting] = [set_to(used[path], value, 0) for path, value in others.items()]
            if choice.parameter is not None and choice.parameter.name in instances[0]:
                steps = instances[0][choice.parameter.name]
                assert isinstance(steps, int)
                settings.append(("parameters", parameter_attribute(choice.parameter.name), steps, 0))
            known_quantities = _quantities(choice, used)
            settings += [
                set_to(known_quantities[path], value, instance)
                for instance, known in enumerate(instances)
                for path, value in known.items()
                if path in known_quantities
            ]
            yield MessageCase(
                name=f"{message.name}.represents-{choice.component.name}-{name}",
                requirement=str(message.citation),
                message=message.wire.name,
                table=message.name,
                instance=0,
                settings=tuple(settings),
                expect=expected_fields(message, {**others, **instances[number]}, number),
            )


def _quantities(choice: Representation, used: Mapping[str, Quantity]) -> dict[str, Quantity]:
    """Return what is set in each instance, by path."""
    known = {path: quantity for path, quantity in used.items() if quantity.component == choice.component.name}
    for extra in (choice.component.enabled, choice.quantity):
        if extra is not None:
            known[extra.path] = extra
    return known


def _states(choice: Representation, used: Mapping[str, Quantity]) -> Iterator[tuple[str, Sequence[Known]]]:
    """Name, and what is known of each instance: all enabled and each of them disabled, as they are chosen from."""
    count = choice.component.instances
    base = [
        {path: _plain(quantity, number) for path, quantity in _quantities(choice, used).items()}
        for number in range(count)
    ]
    enabled = choice.component.enabled
    disabled = [None, *range(count)] if enabled is not None else [None]
    for off in disabled:
        states: list[dict[str, Stored]] = [dict(known) for known in base]
        name = "all-enabled" if off is None else f"{off}-disabled"
        if off is not None and enabled is not None:
            states[off][enabled.path] = 0
        for suffix, changed in _choices(choice, states):
            yield f"{name}{suffix}", changed
    if enabled is not None:
        off_all: Sequence[Known] = [{**known, enabled.path: 0} for known in base]
        yield "none-enabled", off_all


def _choices(choice: Representation, states: list[dict[str, Stored]]) -> Iterator[tuple[str, Sequence[Known]]]:
    if choice.policy is Policy.PARAMETER and choice.parameter is not None:
        parameter = choice.parameter
        for number in range(parameter.minimum, min(parameter.maximum, len(states) + 1) + 1):
            yield f"-number-{number}", [{**known, parameter.name: number} for known in states]
    elif choice.policy is Policy.LOWEST and choice.quantity is not None:
        path, middle = choice.quantity.path, nominal(choice.quantity)
        for lowest in range(len(states)):
            yield f"-lowest-{lowest}", [{**known, path: middle - (n == lowest)} for n, known in enumerate(states)]
            only = [{**known, path: middle if n == lowest else None} for n, known in enumerate(states)]
            yield f"-only-{lowest}-known", only
        yield "-all-the-same", [{**known, path: middle} for known in states]
        yield "-none-known", [{**known, path: None} for known in states]
    else:
        yield "", list(states)


def _plain(quantity: Quantity, number: int) -> Stored:
    """A value by which the instances differ."""
    if quantity.derivation.switch is not None:
        return 1
    if quantity.kind in (QuantityKind.BOOLEAN, QuantityKind.ENUM):
        return quantity.initial or 0
    value = nominal_values(quantity, number)
    return value if isinstance(value, tuple | str) or value is None else min(value + 11 * number, quantity.maximum)
