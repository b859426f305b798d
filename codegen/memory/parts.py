"""The parts of a program that take heap once it is imported and started: so many of each, counted in a system."""

from collections import Counter
from enum import StrEnum

from codegen.model.code.storage import Storage
from codegen.model.program import Program
from codegen.model.system import System


class Part(StrEnum):
    """One part. Its value is what ``costs.json`` calls it."""

    PROGRAM = "program"
    """A program that sends nothing but a HEARTBEAT, receives nothing of the project's own and has no parameters."""
    MESSAGE = "message"
    """More for each message that the firmware knows, of tables and of the services."""
    TABLE = "table"
    """More for each table of a message that is sent."""
    CONSTANT = "constant"
    """More for each answer of these tables that is always the same."""
    VALUE = "value"
    """More for each answer of these tables that is not."""
    RECEPTION = "reception"
    """More for each table of a message that is received."""
    TAKEN = "taken"
    """More for each element that is taken from one."""
    COMPONENT = "component"
    """More for each component of the state."""
    QUANTITY = "quantity"
    """More for each quantity of it."""
    LARGE = "large"
    """More for each of these that is no small integer: a float, or one of more bits."""
    LIST = "list"
    """More for each of these that has elements."""
    STORAGE = "storage"
    """More for each way in which some of these are kept: what does it is there only then."""
    PARAMETER = "parameter"
    """More for each parameter."""
    READING = "reading"
    """More for each quantity that the converter of the board measures."""
    SENSOR = "sensor"
    """More for each sensor with a driver, or with a class of the user's."""
    FAILSAFE = "failsafe"
    """More for each failsafe."""
    COMMAND = "command"
    """More for each command of the project."""
    LINK = "link"
    """More for each link."""
    NETWORK = "network"
    """More where a link needs Wi-Fi."""


Counts = Counter[Part]
"""The number of each part."""


def counted(system: System, program: Program) -> Counts:
    """Return how many there are of each part."""
    components = system.components.values()
    quantities = [quantity for component in components for quantity in component.quantities.values()]
    is_constant = [answer.always is not None for table in system.messages for answer in table.answers]
    return Counts(
        {
            Part.PROGRAM: 1,
            Part.MESSAGE: len(system.wires),
            Part.TABLE: len(system.messages),
            Part.CONSTANT: is_constant.count(True),
            Part.VALUE: is_constant.count(False),
            Part.RECEPTION: len(system.receptions),
            Part.TAKEN: sum(len(table.fields) for table in system.receptions),
            Part.COMPONENT: len(components),
            Part.QUANTITY: len(quantities),
            Part.LARGE: sum(1 for each in quantities if each.storage is not Storage.SMALL),
            Part.LIST: sum(1 for each in quantities if each.elements is not None),
            Part.STORAGE: len({(each.storage, each.elements is not None) for each in quantities}),
            Part.PARAMETER: len(system.parameters),
            Part.READING: len(system.readings()),
            Part.SENSOR: len(system.polled),
            Part.FAILSAFE: len(program.failsafes),
            Part.COMMAND: len(program.commands),
            Part.LINK: len(system.links),
            Part.NETWORK: int(any(link.kind.is_wireless for link in system.links)),
        }
    )
