"""Facts for tests about messages that are withheld while something is unknown."""

from collections.abc import Iterator
from typing import NamedTuple

from codegen.model.failsafe import Sense
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
    """A message with the quantities, (component, attribute), that withhold it; ``about`` are arguments of the first.

    ``is_on``: the first instance is reported by default. ``is_alone``: no other table is of the same message.
    """

    identifier: str
    criterion: str
    id: int
    builder: str
    encoder: str
    about: str
    quantities: tuple[tuple[str, str], ...]
    instances: int
    is_on: bool
    is_alone: bool


def withheld_messages(system: System) -> tuple[WithheldMessage, ...]:
    """The messages that may be withheld, in their order."""
    return tuple(_withheld(message, system) for message in system.messages if message.withheld_for)


def _withheld(message: PopulatedMessage, system: System) -> WithheldMessage:
    causes = dict.fromkeys((quantity.component, quantity.attribute) for _, quantity in message.withheld_for)
    return WithheldMessage(
        identifier=message.name.lower(),
        criterion=str(message.citation),
        id=message.wire.id,
        builder=builder_name(message),
        encoder=encoder_name(message),
        about=", 0" * len(message_about(message)),
        quantities=tuple(causes),
        instances=message.instances,
        is_on=on_by_default(message.component, system)[0],
        is_alone=len(system.tables(message.wire.name)) == 1,
    )


def known_words(system: System) -> tuple[KnownWord, ...]:
    """A value for everything that a message is withheld for, with which each goes out, or that keeps from arming."""
    return tuple(dict.fromkeys((*_known(system), *_calm(system))))


def _calm(system: System) -> Iterator[KnownWord]:
    """Yield what failsafes watch and no reading gives, with values that are beyond no threshold."""
    read = {component for component, _, _ in system.measured()}
    layout = word_layout(system)
    for failsafe in system.program.failsafes if system.program else ():
        quantity = failsafe.quantity
        if quantity is None or not failsafe.spec.arming:
            continue
        if quantity.component in read and not quantity.derivation.ages_alone:
            continue
        is_below = any(condition.sense is Sense.BELOW for condition in failsafe.conditions)
        value = str(quantity.maximum if is_below else quantity.minimum)
        places = layout.places(quantity.component, age_word(quantity)) if quantity.ages else ()
        for instance in range(system.components[quantity.component].instances):
            expires = places[instance] if places else None
            yield KnownWord(quantity.component, instance, quantity.attribute, value, expires)


def _known(system: System) -> Iterator[KnownWord]:
    quantities: dict[str, Quantity] = {
        quantity.path: quantity for message in system.messages for _, quantity in message.withheld_for
    }
    layout = word_layout(system)
    for quantity in quantities.values():
        places = layout.places(quantity.component, age_word(quantity)) if quantity.ages else ()
        for instance in range(system.components[quantity.component].instances):
            yield KnownWord(
                quantity.component,
                instance,
                quantity.attribute,
                literal_of(nominal_values(quantity, instance)),
                places[instance] if places else None,
            )
