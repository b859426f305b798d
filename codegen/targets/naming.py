"""Names of the generated Python: one place decides how a dialect's or a table's name is spelt in code."""

import json
import keyword
from collections.abc import Iterable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from codegen.model.system import PopulatedMessage
    from codegen.model.vehicle import Parameter


def class_name(message: str) -> str:
    """BATTERY_STATUS -> BatteryStatus."""
    return "".join(part.capitalize() for part in message.split("_"))


def class_names(messages: Iterable[str]) -> dict[str, str]:
    """The class of each message in messages.py: an underscore keeps a name apart that is taken already."""
    names: dict[str, str] = {}
    taken = {"Message"}  # their base class
    for message in messages:
        name = class_name(message)
        if not name.isidentifier():  # "_" leaves nothing, "_3D" a digit at the front
            name = f"_{name}"
        while name in taken or keyword.iskeyword(name):
            name += "_"
        taken.add(name)
        names[message] = name
    return names


def state_class(component: str) -> str:
    """battery -> BatteryState."""
    return f"{class_name(component)}State"


def builder_name(message: "PopulatedMessage") -> str:
    """BATTERY_STATUS -> build_battery_status."""
    return f"build_{message.name.lower()}"


def encoder_name(message: "PopulatedMessage") -> str:
    """BATTERY_STATUS -> encode_battery_status."""
    return f"encode_{message.name.lower()}"


def frame_name(message: "PopulatedMessage") -> str:
    """BATTERY_STATUS -> battery_status_frame, the encoder that has to be told all; of one without instances the same.

    Machine code has no default arguments: a call that may leave some out goes through one more function.
    """
    return f"{message.name.lower()}_frame" if message_about(message) else encoder_name(message)


def writer_name(message: "PopulatedMessage") -> str:
    """BATTERY_STATUS -> write_battery_status, the function from the words of the state to the payload."""
    return f"write_{message.name.lower()}"


def message_about(message: "PopulatedMessage") -> tuple[str, ...]:
    """Return what those functions are told that a message is about: the instance
    and the page, as far as it has them.
    """
    each = ("instance",) if message.component else ()
    return (*each, "page") if message.population.pages else each


def failsafe_function(name: str) -> str:
    """depth -> depth_failsafes, what makes a failsafe, and the vehicle's list of it."""
    return f"{name}_failsafes"


PARAMETERS_NAMES = frozenset(
    ("get", "set", "names", "value", "limits", "type_of", "is_after_reboot", "dump", "restore", "changes")
)
"""The attributes and methods of the firmware's Parameters, beside those that are parameters."""


def parameter_attribute(parameter: str) -> str:
    """BATT_VOLT_MULT -> batt_volt_mult; LIMITS -> limits_, since limits() is a method of all of them."""
    name = parameter.lower()
    return f"{name}_" if keyword.iskeyword(name) or name in PARAMETERS_NAMES else name


def family_constant(parameter: "Parameter") -> str:
    """The constant with the attributes of a family by instance: BATT_LOW_VOLT -> _BATT_LOW_VOLT."""
    return f"_{parameter.siblings[0]}"


def parameter_expression(parameter: "Parameter", parameters: str, instance: str = "instance") -> str:
    """The steps of a parameter; of a family those of the instance."""
    if parameter.siblings:
        return f"getattr({parameters}, {family_constant(parameter)}[{instance}])"
    return f"{parameters}.{parameter_attribute(parameter.name)}"


def quoted(text: str) -> str:
    """A text literal of the generated Python, in double quotes."""
    return json.dumps(text, ensure_ascii=False)


def prose(text: str) -> str:
    """Text of a table for a comment or a docstring: one line, without what would end or change it there."""
    return " ".join(text.split()).replace("\\", "/").replace('"', "'")
