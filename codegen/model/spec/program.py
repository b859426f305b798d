"""``vehicle.yaml``: the program that the board runs, around the telemetry."""

from collections.abc import Mapping

from codegen.frozen import dataclass
from codegen.model.spec.access import AccessSpec
from codegen.model.spec.described import Amount, described
from codegen.model.spec.failsafe import FailsafeSpec
from codegen.model.spec.watchdog import WatchdogSpec
from codegen.source import Written


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlSpec(Written):
    """The main loop."""

    rate: Amount = described("How often the control slot runs, such as 400 Hz.")
    links: Amount = described("How often links are served: what arrives is answered, what is due is sent.")
    checks: Amount = described(
        "How often failsafes look, and the checks before arming are made, where no reading of the ADC comes as often.",
        default="10 Hz",
    )
    report_every: Amount = described(
        "Shortest time between two reports about missed slots, such as 10 s; 100 ms at least."
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: grid, order, missed, memory.",
        default_factory=dict,
    )

    ASPECTS = ("grid", "order", "missed", "memory")


@dataclass(frozen=True, slots=True, kw_only=True)
class StorageSpec(Written):
    """The storage of parameters on the board."""

    files: tuple[str, ...] = described(
        "Names of two files in the board's flash; saves take turns between them. A name has letters, digits, _, . and "
        "-, and is neither that of a module nor of another file on the board."
    )
    chunk: int = described("Bytes that one step of a save writes, 16 to 256.")
    step_limit: Amount = described(
        "Longest time that one step of a save may take, up to 1 s; longer ones are warned about."
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: kept, defaults, power_cut, steps, wear, set, read, reboot, over_link, lost, "
        "leaving (what is set last before a restart).",
        default_factory=dict,
    )

    ASPECTS = (
        *("kept", "defaults", "power_cut", "steps", "wear", "set", "read", "reboot", "over_link", "lost", "leaving"),
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class ArmingSpec(Written):
    """The arming of the vehicle."""

    force: int = described(
        "Second parameter of MAV_CMD_COMPONENT_ARM_DISARM that passes over the checks: 21196, or another number that a "
        "float of 32 bits carries, but 0, which every command to arm has."
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: command, reasons, stop (when stop_motors() is called).", default_factory=dict
    )

    ASPECTS = ("command", "reasons", "stop")


@dataclass(frozen=True, slots=True, kw_only=True)
class ActionSpec(Written):
    """The action of a failsafe: a call of the vehicle that the user's code overrides."""

    value: int = described("Value of the parameter that chooses this action.")
    call: str = described("Name of the call.")
    doc: str = described("What it is for, for people.")
    mode: int | None = described("Drive mode that the vehicle then reports.", default=None)
    disarm: bool = described("True: the action disarms the vehicle.", default=False)


@dataclass(frozen=True, slots=True, kw_only=True)
class ModeSpec(Written):
    """A mode of the vehicle, by the number that HEARTBEAT has as custom_mode."""

    name: str = described("Name of the mode, for people: MANUAL.")
    doc: str = described("What the vehicle does in it, for people.")
    base: tuple[str, ...] = described(
        "Booleans of the component vehicle that are true in this mode and false in those that do not list them: "
        "conditions of flags of base_mode.",
        default=(),
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)


@dataclass(frozen=True, slots=True, kw_only=True)
class ServicesSpec(Written):
    """The services of the vehicle to ground stations."""

    fastest: Amount = described("Highest rate at which messages without a stream can be asked for, such as 10 Hz.")
    silence: Amount = described(
        "Time without a HEARTBEAT, which come once a second, after which a ground station is gone; once back, it is "
        "told what is sent on connection.",
        default="10 s",
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: commands, request, intervals, data_streams, restart, ping, texts, garbage, "
        "links, stations, standing (what is told again), absent (missions, logs and modes), checks, defaults (of all "
        "parameters), twins (who uses the same ids is told).",
        default_factory=dict,
    )

    ASPECTS = (
        *("commands", "request", "intervals", "data_streams", "restart", "ping", "texts", "garbage", "links"),
        *("stations", "standing", "absent", "checks", "defaults", "twins"),
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class CodeSpec(Written):
    """The user's code: a module on the board with a class that is derived from Vehicle."""

    module: str = described("Name of the module.", default="app")
    class_name: str = described("Name of the class in it.", key="class", default="App")
    measure: Amount | None = described(
        "How often its call measure() reads sensors of its own, such as 10 Hz: before the readings of that time.",
        default=None,
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)


@dataclass(frozen=True, slots=True, kw_only=True)
class VehicleSpec(Written):
    """``vehicle.yaml``: the program that the board runs. Without this file only the telemetry is generated."""

    control: ControlSpec = described("The main loop.")
    storage: StorageSpec = described("Where the board keeps the parameters.")
    arming: ArmingSpec | None = described(
        "How the vehicle is armed. Without it there is nothing to arm, and parameters are saved at any time.",
        default=None,
    )
    services: ServicesSpec = described("What the vehicle answers to ground stations.")
    access: AccessSpec | None = described(
        "Who may command the vehicle over which link. Without it every link is open.", default=None
    )
    watchdog: WatchdogSpec | None = described(
        "The watchdog of the board, which resets it when the main loop stands still. Without it nothing does.",
        default=None,
    )
    system_id: str | None = described("Parameter that sets the MAVLink system id of the vehicle.", default=None)
    component_id: str | None = described(
        "Parameter that sets the MAVLink component id; its default is the id of the project's component_id.",
        default=None,
    )
    code: CodeSpec | None = described("The user's code: by default a class App in a module app.", default=None)
    failsafes: Mapping[str, FailsafeSpec] = described(
        "Failsafes by a name of their own: they may watch the same component.", default_factory=dict
    )
    actions: tuple[ActionSpec, ...] = described("What failsafes can do.", default=())
    priority: tuple[str, ...] = described(
        "The calls of all actions, the most severe first: where several failsafes are up, the first one there that any "
        "of them asks for holds, whichever came first. Without it each does what it asks for when it is reached.",
        default=(),
    )
    modes: Mapping[str, ModeSpec] = described(
        "The modes by their numbers: what SET_MODE and MAV_CMD_DO_SET_MODE change to. Without it the mode is what code "
        "makes it.",
        default_factory=dict,
    )
