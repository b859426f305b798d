"""Facts for tests about messages that are withheld while something is unknown."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from codegen.model.failsafe import Failsafe, Sense
from codegen.model.price import on_by_default
from codegen.model.system import PopulatedMessage, System
from codegen.model.vehicle import Quantity
from codegen.targets.firmware.words import age_word, word_layout
from codegen.targets.naming import builder_name, encoder_name, message_about
from codegen.targets.suite.cases.case import literal_of
from codegen.targets.suite.expected import nominal_values


class KnownWord(NamedTuple):
    """A quantity of an instance, from 0, and a plain value of it, as a literal.

    ``expires`` is the place in the whole array where it is kept how long that is believed, if it ages.
    """

    component: str
    instance: int
    attribute: str
    value: str
    expires: int | None


class WithheldMessage(NamedTuple):
    """A message with the quantities that withhold it; ``about`` are arguments of the first.

    These are ``causes``, (component, attribute). ``quantities`` has for each the instances whose values may go out,
    such as ``battery[0]``, and the attribute: of a message that reports one of several instances these are all of them.
    ``is_on``: the first instance is reported by default. ``is_alone``: no other table is of the same message.
    """

    identifier: str
    criterion: str
    id: int
    builder: str
    encoder: str
    about: str
    causes: tuple[tuple[str, str], ...]
    quantities: tuple[tuple[tuple[str, ...], str], ...]
    instances: int
    is_on: bool
    is_alone: bool


def withheld_messages(system: System) -> tuple[WithheldMessage, ...]:
    """The messages that may be withheld, in their order."""
    return tuple(_withheld(message, system) for message in system.messages if message.withheld_for)


def _withheld(message: PopulatedMessage, system: System) -> WithheldMessage:
    causes = dict.fromkeys((quantity.component, quantity.attribute) for _, quantity in message.withheld_for)
    counts = {name: each.component.instances for name, each in message.represents.items()}
    return WithheldMessage(
        identifier=message.name.lower(),
        criterion=str(message.citation),
        id=message.wire.id,
        builder=builder_name(message),
        encoder=encoder_name(message),
        about=", 0" * len(message_about(message)),
        causes=tuple(causes),
        quantities=tuple(
            (tuple(f"{name}[{instance}]" for instance in range(counts.get(name, 1))), attribute)
            for name, attribute in causes
        ),
        instances=message.instances,
        is_on=on_by_default(message.component, system)[0],
        is_alone=len(system.tables(message.wire.name)) == 1,
    )


def known_words(system: System) -> tuple[KnownWord, ...]:
    """A value for everything that a message is withheld for, with which each goes out, or that keeps from arming.

    Of what failsafes watch it is one that is beyond no threshold of any of them.
    """
    return tuple(word for quantity in _to_know(system) for word in _words(quantity, system))


def _to_know(system: System) -> Iterable[Quantity]:
    """The quantities without which a message is withheld, and those without which a failsafe keeps from arming."""
    withholding = [quantity for message in system.messages for _, quantity in message.withheld_for]
    arming = [each for each in _failsafes(system) if each.spec.arming]
    unknown = [one.quantity for each in arming for one in each.conditions if one.sense is Sense.UNKNOWN]
    watched = [
        quantity
        for quantity in (*(each.quantity for each in arming), *unknown)
        if quantity is not None and not _is_read(quantity, system)
    ]
    return {quantity.path: quantity for quantity in (*withholding, *watched)}.values()


def _words(quantity: Quantity, system: System) -> Iterator[KnownWord]:
    layout = word_layout(system)
    calm = _calm(quantity, system)
    places = layout.places(quantity.component, age_word(quantity)) if quantity.ages else ()
    for instance in range(system.components[quantity.component].instances):
        value = literal_of(nominal_values(quantity, instance)) if calm is None else str(calm)
        yield KnownWord(quantity.component, instance, quantity.attribute, value, places[instance] if places else None)


def _is_read(quantity: Quantity, system: System) -> bool:
    """Return whether it comes with the readings of an ADC."""
    return bool(system.components[quantity.component].readings) and not quantity.derivation.ages_alone


def _failsafes(system: System) -> tuple[Failsafe, ...]:
    return system.program.failsafes if system.program else ()


def _calm(quantity: Quantity, system: System) -> int | None:
    """Return stored steps at which no condition of any failsafe holds, with the defaults; None where none compares.

    What is read is left alone. Those at an end are taken first, and then those that are just beyond no threshold.
    """
    looked_at = [each for one in _failsafes(system) for each in (*one.conditions, *one.to_arm)]
    own = [each for each in looked_at if each.quantity is not None and each.quantity.path == quantity.path]
    if not own or _is_read(quantity, system):
        return None
    low, high = int(quantity.minimum), int(quantity.maximum)
    ends = [high, low] if any(each.sense is Sense.BELOW for each in own) else [low, high]
    edges = [each.edge for each in own if each.edge is not None]
    middle = [(one + other) // 2 for one in edges for other in edges if one < other]
    tried = [value for value in (*ends, *middle, *edges) if low <= value <= high]
    return next((value for value in tried if all(each.rests_at(value) for each in own)), ends[0])
