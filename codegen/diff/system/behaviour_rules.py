"""The kinds of change that a specification can go through: what the vehicle sends, keeps, is told and answers."""

from codegen.diagnostics import Severity
from codegen.diff.change import BOTH, Area, ChangeRule, Notice, Victim


def _silent(name: str, explanation: str, *breaks: Victim) -> ChangeRule:
    """The bytes of a message mean something else, or say it otherwise, and nothing tells."""
    severity = Severity.ERROR if breaks else Severity.WARNING
    return ChangeRule(name, explanation, severity, area=Area.BEHAVIOUR, notice=Notice.SILENT, breaks=breaks)


def _inside(name: str, explanation: str, *breaks: Victim) -> ChangeRule:
    """The vehicle behaves otherwise."""
    severity = Severity.ERROR if breaks else Severity.WARNING
    return ChangeRule(name, explanation, severity, area=Area.BEHAVIOUR, breaks=breaks)


MESSAGE_SENT = _inside("message-sent", "The vehicle sends a message that it did not send before.")
MESSAGE_NOT_SENT = _inside(
    "message-no-longer-sent",
    "The vehicle sends a message no more: who shows or records it gets nothing.",
    Victim.OLD_STATION,
)
MESSAGE_STREAM = _inside(
    "message-schedule-changed",
    "A message belongs to another stream, or is sent on other occasions: on request, on connection, on a change.",
)
TABLE_RENAMED = _inside(
    "table-renamed",
    "A population table has another name, and with it the functions that build and encode its message: code that calls "
    "them by the old one fails. What is sent does not change.",
)
MESSAGE_INSTANCES = _silent(
    "message-instances-changed",
    "A message is sent for other instances of a component, or a single message reports another one of them.",
)
SOURCE = _silent(
    "population-source-changed",
    "A field takes its value from somewhere else: another quantity, a parameter, a fact of the board, a constant.",
)
CONSTANT = _silent("population-constant-changed", "A field that always has the same value has another one.")
CONVERSION = _silent(
    "population-conversion-changed",
    "The factor or the rounding between the value that is kept and the number on the wire has changed.",
)
LIMITS = _silent(
    "population-limits-changed",
    "A field is limited to another range, or steps aside from another value so that no measurement reads as unknown.",
)
UNKNOWN = _silent(
    "population-unknown-changed",
    "What goes out while the value is unknown has changed. Receivers that know the other number take it for a "
    "measurement.",
    *BOTH,
)
FLAGS = _silent("population-flags-changed", "Other bits of a field are set, or under other conditions.")

TAKEN = _inside("message-taken", "The vehicle takes a message that it did not take before: it sets quantities.")
NOT_TAKEN = _inside(
    "message-no-longer-taken",
    "The vehicle takes a message no more: who steers by it, or tells it something, is not heard, and gets no answer.",
    Victim.OLD_STATION,
)
TAKEN_FROM = _inside(
    "message-taken-otherwise",
    "A message is taken from other senders, under other conditions, or calls something else of the vehicle.",
)
FIELD_TAKEN = _inside("field-taken", "A field of a message that arrives sets a quantity; before it was ignored.")
FIELD_NOT_TAKEN = _inside(
    "field-no-longer-taken",
    "A field of a message that arrives is ignored, which set a quantity before: nothing tells who sends it.",
    Victim.OLD_STATION,
)
TAKEN_INTO = _silent(
    "field-taken-into-another",
    "A field of a message that arrives sets another quantity: the vehicle takes what is sent for something else.",
    Victim.OLD_STATION,
)
TAKEN_AS = _inside(
    "field-taken-otherwise",
    "The factor, the rounding or the unit has changed in which a quantity keeps what a field of a message sets.",
)
TAKEN_RANGE = _inside(
    "field-taken-range-changed",
    "Other numbers of a field count as plausible. What is not plausible is ignored.",
)
TAKEN_VALUE = _silent(
    "field-taken-value-changed",
    "A number of a field means something else to the vehicle: that there is no value, that nothing is to change, or a "
    "value like any other. Who sends it is taken at another word, and nothing tells.",
    Victim.OLD_STATION,
)

PARAMETER_ADDED = _inside(
    "parameter-added", "A parameter is new: ground stations list it, and stored parameters of before do not have it."
)
PARAMETER_REMOVED = _inside(
    "parameter-removed",
    "A parameter is gone: files of parameters and scripts that set it get no answer, and stored values are dropped.",
    Victim.OLD_STATION,
)
PARAMETER_DEFAULT = _inside(
    "parameter-default-changed", "The value of a parameter on a new board, and after damaged storage, has changed."
)
PARAMETER_RANGE = _inside(
    "parameter-range-changed", "Other values of a parameter are accepted; stored ones outside become the default."
)
PARAMETER_UNIT = _silent(
    "parameter-unit-changed",
    "A parameter is in another unit. Ground stations and files of parameters go on with the old numbers.",
    *BOTH,
)
PARAMETER_TYPE = _inside(
    "parameter-type-changed",
    "PARAM_VALUE announces another type of a parameter: who took the old one reads other numbers.",
    *BOTH,
)
PARAMETER_ENCODING = _silent(
    "parameter-encoding-changed",
    "PARAM_VALUE and PARAM_SET carry whole parameters in another way: as floats, or as the bytes of their types. Who "
    "takes them in the other way reads 7e-45 for 5, and sets 0.",
    *BOTH,
)
PARAMETER = _inside(
    "parameter-changed", "A parameter has other steps, other meanings of its values, or is used at another time."
)

QUANTITY_ADDED = _inside("quantity-added", "The vehicle state has a quantity more, which code can set or read.")
QUANTITY_REMOVED = _inside(
    "quantity-removed", "The vehicle state has a quantity less: code that sets or reads it fails."
)
QUANTITY_UNIT = _inside(
    "quantity-unit-changed",
    "A quantity is kept or told in another unit: code that sets or reads it goes on with the old.",
)
QUANTITY_RANGE = _inside(
    "quantity-range-changed", "A quantity is limited to another range, or has another number of values."
)
QUANTITY_SOURCE = _inside("quantity-source-changed", "A quantity is measured, computed or initialised otherwise.")
QUANTITY_AGE = _inside(
    "quantity-trust-changed", "A quantity becomes unknown, or is warned about, under other conditions."
)

COMPONENT_ADDED = _inside("component-added", "The vehicle state has a component more, such as a second kind of sensor.")
COMPONENT_REMOVED = _inside(
    "component-removed", "The vehicle state has a component less: code that sets or reads it fails."
)
FACT = _inside(
    "component-fact-changed", "A fact about the connected hardware is another one, such as a weight or a name."
)
INSTANCES = _inside(
    "component-instances-changed", "There are other instances of a component, or their parameters are called otherwise."
)
UPDATE_RATE = _inside("component-rate-changed", "A component is measured at another rate than before.")

STREAM_ADDED = _inside("stream-added", "There is a stream more, at a rate of its own.")
STREAM_REMOVED = _inside("stream-removed", "There is a stream less: who asks for it gets no answer.")
STREAM_RATE = _inside(
    "stream-rate-changed", "A stream is sent at another rate, can be asked for at another, or by other means."
)
STREAM_ORDER = _inside(
    "stream-order-changed",
    "Streams stand in another order in streams.yaml, which is the one in which their messages go out: of what is due "
    "at once, the first ones take the turns of a pass and the room that a link has left, the last ones wait or are "
    "left out.",
)
BANDWIDTH = _inside(
    "bandwidth-changed",
    "The telemetry takes more or less of the links at the default rates than the threshold allows "
    "(codegen diff --bandwidth PERCENT, 5 by default).",
)
OVERLOADED = _inside(
    "link-overloaded",
    "The telemetry takes more of a link at the default rates than the link carries: frames come late, or not at all.",
    Victim.OLD_STATION,
)
GENERATIONS = _inside("generations-changed", "Another generation of messages is sent, or is chosen otherwise.")

CHANNEL = _inside(
    "adc-channel-changed", "An ADC channel has another pin, reference, resolution or number of samples, is new or gone."
)
SENSOR = _inside(
    "sensor-changed", "A sensor is read otherwise, is connected elsewhere, gives other numbers, is new or gone."
)
DRIVER_CODE = _inside(
    "driver-code-changed",
    "The code of a driver of the project's own has changed. It is copied into the firmware, and nothing but a person "
    "sees whether what it gives still means the same.",
)
LINK = _inside("link-changed", "A link to ground stations is configured otherwise, is new or gone.")
IDENTITY = _inside(
    "identity-changed",
    "The vehicle sends as another system or component, or in another version of MAVLink: ground stations take it for "
    "another vehicle, or cannot read it.",
    *BOTH,
)
COMMAND_ADDED = _inside("command-added", "The vehicle answers a command that it did not know before.")
COMMAND_REMOVED = _inside(
    "command-removed", "The vehicle knows a command no more: who asks for it is told so.", Victim.OLD_STATION
)
COMMAND_RANGE = _inside(
    "command-range-changed", "Other values of a parameter of a command are accepted, or NaN stands for another one."
)
COMMAND_UNIT = _silent(
    "command-unit-changed",
    "The number that a command carries is taken in another unit. Who sends it goes on with the old numbers.",
    *BOTH,
)
COMMAND = _inside(
    "command-changed", "A command is done at other times, for others, in another way, or by another method of the code."
)
MODE_ADDED = _inside("mode-added", "The vehicle has a mode more, to which a ground station can change it.")
MODE_REMOVED = _inside("mode-removed", "The vehicle has a mode less: who asks for it is refused.", Victim.OLD_STATION)
MODE = _inside("mode-changed", "A mode has another name, or other flags of HEARTBEAT are set in it.")
ACCESS = _inside(
    "access-changed",
    "A link obeys others than before: who has no key or is not listed is not heard any more, or everybody is.",
    Victim.OLD_STATION,
)
FAILSAFE = _inside("failsafe-changed", "A failsafe watches, waits or acts otherwise, is new or gone.")
PROGRAM = _inside("program-changed", "The program on the board runs at other rates, stores or answers otherwise.")
PROGRAM_ADDED = _inside("program-added", "The project has a further program more.")
PROGRAM_REMOVED = _inside(
    "program-removed",
    "A further program is gone: the component that it was is silent, and hears nobody.",
    Victim.OLD_STATION,
)
PROGRAM_RENAMED = _inside(
    "program-renamed",
    "A further program has another name, and with it the folder of its output: commands that name it (--program), "
    "paths and scenarios use the new one. What it sends does not change.",
)
RECEIVER = _inside("receiver-changed", "The generated receiver reads other messages, or trusts them otherwise.")

TOLD = frozenset(
    {MESSAGE_STREAM, MESSAGE_INSTANCES, SOURCE, CONSTANT, CONVERSION, LIMITS, FLAGS, STREAM_RATE, GENERATIONS, CHANNEL}
)
"""The kinds of change by which ground stations are told something else, or at other times, though nobody may break."""
