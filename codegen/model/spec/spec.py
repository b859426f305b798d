"""The specification as its YAML and Markdown files state it, every record with its places.

These dataclasses are the only description of the file formats: the decoder and the JSON Schemas both read them; see
``described``. The board, the program that it runs, the state, the receiver and the tables of messages have modules of
their own.
"""

import os
from collections.abc import Mapping
from dataclasses import field
from enum import StrEnum
from fractions import Fraction
from typing import ClassVar

from codegen.frozen import dataclass
from codegen.model.board_model import BoardModelSpec
from codegen.model.spec.board import BoardSpec
from codegen.model.spec.command import CommandsSpec
from codegen.model.spec.described import Amount, Verbatim, described
from codegen.model.spec.driver import DriverModule, OwnDriver, StateStore
from codegen.model.spec.population import PopulationSpec
from codegen.model.spec.program import VehicleSpec
from codegen.model.spec.receive import ReceiveSpec
from codegen.model.spec.receiver import ReceiverSpec
from codegen.model.spec.state import StateSpec
from codegen.source import Written


@dataclass(frozen=True, slots=True, kw_only=True)
class Project(Written):
    """``codegen.yaml``: what is built from what. Paths are relative to this file."""

    project: str = described("Name of the vehicle's firmware, printed in the generated headers.")
    dialect: str = described("A dialect that pymavlink ships (common, ardupilotmega, ...) or the path of an XML file.")
    dialect_version: str | None = described(
        "Release of pymavlink that this was reviewed with, such as pymavlink 2.4.50: another one that is installed is "
        "an error. Without it any is taken.",
        default=None,
    )
    overlays: tuple[str, ...] = described("XML files whose messages and enums are added to the dialect.", default=())
    known: tuple[str, ...] = described(
        "XML files of other dialects that receivers know, beside those that pymavlink ships: their names and ids are "
        "taken.",
        default=(),
    )
    corrections: tuple[str, ...] = described("YAML files that correct attributes of the dialect.", default=())
    output: str = described("Folder that the generated files go to.", default="../generated")
    outside: tuple[str, ...] = described(
        "Folders outside of the project, which is the folder above this one, that files may be read from, and that the "
        "output may lie in.",
        default=(),
    )
    tests: tuple[str, ...] = described(
        "Folders with tests written by hand, in which codegen trace looks for what they show.", default=("../tests",)
    )
    programs: Mapping[str, str] = described(
        "Further programs from the same specification by name, each with the path of its own project file; what is "
        "generated for one goes to the folder of that name below the output, and what all of them have alike to the "
        "folder common.",
        default_factory=dict,
    )
    system_id: int = described("MAVLink system id of the vehicle, 1 to 255.", default=1)
    component_id: str = described("Entry of MAV_COMPONENT that is sent as.", default="MAV_COMP_ID_AUTOPILOT1")
    protocol: int = described("MAVLink version that is sent, 1 or 2.", default=2)
    machine_code: bool = described(
        "Let MicroPython make machine code of the functions that encode, decode and build messages. false leaves them "
        "bytecode, for ports without native code: slower by ten times and more.",
        default=True,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class ProgramProject(Written):
    """``codegen.yaml`` of a further program. What it does not state is as in the project that lists it.

    Files that lie beside it are used in place of those of the same name in the base.
    """

    base: str = described("Folder of the project that lists this program under programs.")
    project: str = described("Name of this program's firmware, printed in the generated headers.")
    component_id: str | None = described("Entry of MAV_COMPONENT that is sent as.", default=None)
    protocol: int | None = described("MAVLink version that is sent, 1 or 2.", default=None)
    machine_code: bool | None = described("See the project that lists this program.", default=None)
    messages: tuple[str, ...] | None = described(
        "The messages of this program, one at least; their tables lie here or in the base. Without it: all tables.",
        default=None,
    )


class ParameterType(StrEnum):
    """The type that PARAM_VALUE announces: an entry of MAV_PARAM_TYPE, in lower case and without that prefix."""

    INT8 = "int8"
    UINT8 = "uint8"
    INT16 = "int16"
    UINT16 = "uint16"
    INT32 = "int32"
    UINT32 = "uint32"
    REAL32 = "real32"


@dataclass(frozen=True, slots=True, kw_only=True)
class ParameterSpec(Written):
    """One parameter that a ground station can read and set."""

    doc: str = described("What it does, for people.")
    default: Fraction = described("Value on a new board, in unit.")
    min: Fraction = described("Smallest value that is accepted, in unit.")
    max: Fraction = described("Largest value that is accepted, in unit.")
    step: Fraction = described("Resolution: the firmware keeps the value as a whole number of steps.")
    unit: str | None = described("Unit, absent for pure numbers.", default=None)
    type: ParameterType = described("Type that PARAM_VALUE announces.", default=ParameterType.REAL32)
    values: Mapping[str, str] = described(
        "What single values mean, by the value; no others are accepted then.", default_factory=dict
    )
    reboot: bool = described(
        "True: a new value is used only after a restart, which is said where it is set. It is an error where the value "
        "is followed at once (streams, failsafes, represents), and missing where it is not (pins, ids, enabled_by).",
        default=False,
    )
    was: Mapping[str, Fraction] = described(
        "Names that it had in earlier firmware, with what values of then are multiplied by (a factor between units): "
        "what is stored under them is taken over.",
        default_factory=dict,
    )
    for_each: str | None = described(
        "Component of which each instance has this parameter, with its own prefix in place of the first one's.",
        default=None,
    )
    per: str | None = described(
        "A fact of the component that counts something, such as cells: the default is for one of them, and the number "
        "of each instance multiplies it.",
        default=None,
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)


class ParameterEncoding(StrEnum):
    """The way in which PARAM_VALUE and PARAM_SET carry integers in their float of 32 bits."""

    C_CAST = "c_cast"
    BYTEWISE = "bytewise"


@dataclass(frozen=True, slots=True, kw_only=True)
class ParametersSpec(Written):
    """``parameters.yaml``: the parameters by name (at most 16 characters)."""

    encoding: ParameterEncoding = described(
        "How PARAM_VALUE and PARAM_SET carry parameters of whole types. c_cast: as floats, as stations take them of a "
        "vehicle whose HEARTBEAT says MAV_AUTOPILOT_ARDUPILOTMEGA. bytewise: as the bytes of the type, as they take "
        "them of others.",
        default=ParameterEncoding.C_CAST,
    )
    parameters: Mapping[str, ParameterSpec] = described("The parameters by name.", default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class StreamSpec(Written):
    """A group of messages that are sent at one rate: a fixed one, or one that a parameter sets.

    Of what is due at once streams that are written first go first, and messages with smaller numbers.
    """

    doc: str = described("What the stream is for, for people.")
    rate: Amount | None = described("Fixed rate, such as 1 Hz.", default=None)
    parameter: str | None = described("Parameter that sets the rate in Hz; 0 switches the stream off.", default=None)
    data_stream: str | None = described(
        "Entry of MAV_DATA_STREAM by which REQUEST_DATA_STREAM asks for it; MAV_DATA_STREAM_ALL asks for all that have "
        "one.",
        default=None,
    )
    fastest: Amount | None = described(
        "Highest rate that a ground station can ask for, and no lower than the default: the parameter's maximum, or "
        "the fixed rate.",
        default=None,
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)


class Generation(StrEnum):
    """The generation of messages that is streamed and announced."""

    OLD = "old"
    NEW = "new"
    BOTH = "both"


@dataclass(frozen=True, slots=True, kw_only=True)
class GenerationsSpec(Written):
    """Two generations of messages about one component, only the chosen one of which is streamed and announced."""

    doc: str = described("What the choice is for, for people.")
    old: tuple[str, ...] = described("Messages that one generation of receivers understands.")
    new: tuple[str, ...] = described("Messages that take their place.")
    parameter: str | None = described(
        "Parameter that chooses while the vehicle runs: 0 old, 1 new, 2 both.", default=None
    )
    send: Generation | None = described("The choice, where it is fixed: old, new or both.", default=None)
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)
    criteria: Mapping[str, str] = described("Criteria for single aspects: choice, other, price.", default_factory=dict)

    ASPECTS = ("choice", "other", "price")
    ONE_OF: ClassVar[tuple[str, ...]] = ("parameter", "send")


@dataclass(frozen=True, slots=True, kw_only=True)
class StreamsSpec(Written):
    """``streams.yaml``: the streams by name, and the generations of messages."""

    streams: Mapping[str, StreamSpec] = described("The streams by name.")
    generations: Mapping[str, GenerationsSpec] = described(
        "Messages of which there is an old and a new generation, by the component that they are about.",
        default_factory=dict,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class Correction(Written):
    """One correction of a message, of a message's field, or of an enum's entry."""

    overlay: str | None = described(
        "Overlay that needs the correction, as codegen.yaml names it; without that overlay it is not applied.",
        default=None,
    )
    message: str | None = described("Message to correct, or that holds the field.", default=None)
    field: str | None = described("Field to correct.", default=None)
    fields: str | None = described(
        "Several fields to correct alike, as a pattern: * stands for any text, ? for one character, [ab] for a or b; "
        "chan*_raw. At least one field is of it.",
        default=None,
    )
    enum: str | None = described("Enum that holds the entry.", default=None)
    entry: str | None = described("Entry to correct.", default=None)
    param: Verbatim | None = described(
        "Parameter of the entry, a command of MAV_CMD: its number, 1 to 7.", default=None
    )
    set: Mapping[str, Verbatim] = described(
        "Attributes and their new text: id, description, wip of a message; invalid, units, enum, display, instance, "
        "multiplier, minValue, maxValue, increment, default, unchanged, unknown, print_format, description, type of a "
        "field; value of an entry; label, units, minValue, maxValue, increment, enum, default, description of a "
        "parameter of one. unchanged and unknown are numbers with commas between them: to who receives the field these "
        "leave things as they were, or say that there is no value. id and type only of a message that an overlay adds."
    )
    reason: str = described("Why the dialect is wrong or silent.")
    source: str = described("Where the right value is stated.")


@dataclass(frozen=True, slots=True, kw_only=True)
class Refusal(Written):
    """Corrections that come with codegen and are not to be applied."""

    message: str = described("Message whose corrections are refused.")
    fields: str = described("The fields, one by its name or several by a pattern: chan*_raw.", default="*")
    reason: str = described("Why they do not hold here.")


@dataclass(frozen=True, slots=True, kw_only=True)
class CorrectionsSpec(Written):
    """``dialects/*.yaml``: corrections that are applied to the dialect after its includes and overlays."""

    corrections: tuple[Correction, ...] = described("The corrections, applied in this order.", default=())
    refuse: tuple[Refusal, ...] = described(
        "Which of the corrections that come with codegen are not to be applied; codegen explain MESSAGE.field shows "
        "them.",
        default=(),
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class ShippedCorrection(Written):
    """A statement about fields that a dialect of pymavlink makes in words and not in an attribute."""

    message: str = described("Message that holds the fields.")
    fields: str = described("The field, or several as a pattern.")
    set: Mapping[str, Verbatim] = described(
        "invalid, units, multiplier, unchanged or unknown, and the text that the attribute lacks."
    )
    words: str = described("The words of the description, of the field or of the message, that state it.")
    replaces: str | None = described(
        "Text of the attribute that the words contradict; without it, an attribute that is there is left alone.",
        default=None,
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class ShippedCorrectionsSpec(Written):
    """``codegen/corrections/*.yaml``: the corrections for the dialect of pymavlink that has the name of the file."""

    corrections: tuple[ShippedCorrection, ...] = described("The corrections, at most one of an attribute of a field.")


@dataclass(frozen=True, slots=True, kw_only=True)
class Criterion(Written):
    """One numbered acceptance criterion; ``number`` is the number in the list, ``text`` its plain text.

    ``depends_on`` names the criteria that have to be met for it, as ``ID.number``; the id may be an alias.
    """

    number: int
    text: str
    depends_on: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class HostLimit(Written):
    """The limit of tests on a host for the criteria with these ``numbers``, and the proof on the bench."""

    numbers: tuple[int, ...]
    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Requirement(Written):
    """A requirement or decision document: ``# ID | Title``, a metadata list, numbered acceptance criteria.

    ``said`` is a fingerprint of all that the document says, its layout left out.
    """

    id: str
    title: str
    aliases: tuple[str, ...]
    status: str
    links: tuple[str, ...]
    criteria: tuple[Criterion, ...]
    host_limits: tuple[HostLimit, ...] = ()
    said: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Spec:
    """Everything below the folder of ``codegen.yaml``.

    ``folder`` is its absolute path; ``files`` maps the absolute path of every file that was read to the sha256 of
    its content with line ends of LF, in the order of the paths. A further program has its name in ``program``;
    ``folder`` is then that of its base, and ``own_folder`` its own, of which the files come first. ``other_overlays``
    are those that something is written for and that are not listed, ``other_corrections`` the corrections among that.
    """

    folder: str
    own_folder: str
    program: str
    project: Project
    state: StateSpec
    board: BoardSpec
    board_model: BoardModelSpec | None
    parameters: ParametersSpec
    streams: StreamsSpec
    vehicle: VehicleSpec | None
    populations: tuple[PopulationSpec, ...]
    corrections: tuple[Correction, ...]
    requirements: tuple[Requirement, ...]
    files: Mapping[str, str]
    receiver: ReceiverSpec | None = None
    refusals: tuple[Refusal, ...] = ()
    receives: tuple[ReceiveSpec, ...] = ()
    commands: CommandsSpec | None = None
    drivers: Mapping[str, OwnDriver] = field(default_factory=dict)
    broken_drivers: frozenset[str] = frozenset()
    own_drivers: tuple[str, ...] = ()
    user_modules: Mapping[str, DriverModule] = field(default_factory=dict)
    state_stores: tuple[StateStore, ...] = ()
    other_overlays: tuple[str, ...] = ()
    other_corrections: tuple[Correction, ...] = ()

    def path(self, name: str) -> str:
        """The absolute path of the file that is used under this name."""
        own = os.path.join(self.own_folder, name)
        return own if own in self.files else os.path.join(self.folder, name)

    def is_own(self, path: str) -> bool:
        """Return whether a file lies in the folder of this program, and not in that of its base."""
        return os.path.commonpath([self.own_folder, path]) == self.own_folder
