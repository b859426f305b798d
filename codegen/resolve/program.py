"""The program that the board runs: links, main loop, failsafes with their actions, and the messages of the services."""

import keyword
import re
from collections.abc import Iterator, Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean, shortened_list
from codegen.model.board_spec import BoardSpec, LinkSpec
from codegen.model.dialect import Dialect, WireMessage
from codegen.model.program import BoardLink, Failsafe, FailsafeLevel, LinkKind, Program
from codegen.model.program_spec import ActionSpec, FailsafeLevelSpec, FailsafeSpec, VehicleSpec
from codegen.model.spec import ParametersSpec, Requirement
from codegen.model.unit import UNITS
from codegen.model.vehicle import Citation, Component, Parameter, Quantity, QuantityKind
from codegen.resolve.citation import cite, cite_optional
from codegen.resolve.measure import read_rate, read_time
from codegen.resolve.state import UNKNOWN_QUANTITY
from codegen.resolve.vehicle import find_parameter
from codegen.source import Place

BAD_LINK = Rule(
    "bad-link",
    "A link cannot be built: its name is a lower-case identifier, a UART is 0 or 1 with tx, rx and baud, UDP has a "
    "port, an address to start with, credentials and a retry time, and keys of one kind do not stand with another.",
)
BAD_PROGRAM = Rule(
    "bad-program",
    "vehicle.yaml contradicts itself or the rest of the specification: the state needs the component vehicle with "
    "armed, ready, status, mode and load, parameters are saved in two files, and each action has a name of its own.",
)
BAD_FAILSAFE = Rule(
    "bad-failsafe",
    "A failsafe watches a measured quantity, its thresholds are in the same dimension and never negative, its time is "
    "in whole seconds, and every value of an action's parameter but 0 is one of the actions.",
)
NO_SERVICE_MESSAGE = Rule(
    "no-service-message",
    "The services to ground stations need a message, or an entry of an enum, that the dialect does not have. Choose a "
    "dialect that includes common.xml, or add it with an overlay.",
)

RECEIVED = (
    "HEARTBEAT",
    "PING",
    "PARAM_REQUEST_READ",
    "PARAM_REQUEST_LIST",
    "PARAM_SET",
    "REQUEST_DATA_STREAM",
    "COMMAND_INT",
    "COMMAND_LONG",
    "FILE_TRANSFER_PROTOCOL",
)
SENT = ("PING", "PARAM_VALUE", "COMMAND_ACK", "MESSAGE_INTERVAL", "STATUSTEXT", "PARAM_ERROR")
"""The messages that the services receive and send; of FILE_TRANSFER_PROTOCOL they send a short beginning only."""

SERVICE_ENTRIES = {
    "MAV_CMD": (
        "GET_MESSAGE_INTERVAL SET_MESSAGE_INTERVAL REQUEST_MESSAGE REQUEST_PROTOCOL_VERSION "
        "REQUEST_AUTOPILOT_CAPABILITIES COMPONENT_ARM_DISARM PREFLIGHT_REBOOT_SHUTDOWN"
    ),
    "MAV_RESULT": "ACCEPTED TEMPORARILY_REJECTED DENIED UNSUPPORTED FAILED",
    "MAV_SEVERITY": "ERROR WARNING NOTICE INFO",
    "MAV_STATE": "STANDBY ACTIVE CRITICAL",
    "MAV_DATA_STREAM": "ALL",
    "MAV_TYPE": "GCS",
    "MAV_FTP_OPCODE": "ACK NAK",
    "MAV_FTP_ERR": "UNKNOWNCOMMAND",
    "REBOOT_SHUTDOWN_ACTION": "NONE REBOOT",
    "REBOOT_SHUTDOWN_CONDITIONS": "FORCE",
    "MAV_PARAM_ERROR": "DOES_NOT_EXIST VALUE_OUT_OF_RANGE",
    "MAV_PARAM_TYPE": "INT8 UINT8 INT16 UINT16 INT32 UINT32 REAL32",
}
"""The entries of enums that the program uses, without the name of the enum at their front."""

VEHICLE_QUANTITIES = {"armed": "boolean", "ready": "boolean", "status": "enum", "mode": "number", "load": "number"}
"""What the program writes into the component ``vehicle`` of the state, with the kind that it has to be."""

_OF_KIND = {
    LinkKind.UART: ("tx", "rx", "baud"),
    LinkKind.USB: (),
    LinkKind.UDP: ("to", "credentials", "retry"),
}
_CALLS = {"control", "check_arming", "on_arm", "on_disarm", "arm", "disarm", "reboot", "run", "run_pass", "act"}


def resolve_links(board: BoardSpec, index: Mapping[str, Requirement], report: Report) -> tuple[BoardLink, ...]:
    """The links in the order of board.yaml."""
    links = []
    taken: dict[str, tuple[str, Place]] = {}
    for name, spec in board.links.items():
        citation = cite_optional(spec.requirement, spec.at("requirement"), index, report)
        _check_shared(name, spec, taken, report)
        kind = LinkKind.UART if spec.uart is not None else LinkKind.USB if spec.usb else LinkKind.UDP
        problems = list(_link_problems(name, kind, spec))
        for key, message in problems:
            report.add(BAD_LINK, spec.at(key), message)
        retry = 0
        if spec.retry is not None:
            retry = read_time(spec.retry, UNITS["ms"], spec.at("retry"), report) or 0
        if not problems:
            links.append(BoardLink(name, kind, retry, spec, citation))
    return tuple(links)


def _check_shared(name: str, spec: LinkSpec, taken: dict[str, tuple[str, Place]], report: Report) -> None:
    """Whether a link takes a port or a pin that an earlier one, or its own other end, takes already."""
    for key, what in (("uart", "UART {}"), ("usb", "the USB port"), ("tx", "GPIO {}"), ("rx", "GPIO {}")):
        value = getattr(spec, key)
        if value is None:
            continue
        place = spec.at(key)
        owner, first = taken.setdefault(what.format(value), (name, place))
        if first != place:
            message = f"{key} of {name} is {what.format(value)}, which {owner} takes already"
            report.add(BAD_LINK, place, message, related=[(first, f"{owner} takes it here")])


def _link_problems(name: str, kind: LinkKind, spec: LinkSpec) -> Iterator[tuple[str, str]]:
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name) or keyword.iskeyword(name):
        yield "", f"{name} cannot be the name of a link"
    for other, keys in _OF_KIND.items():
        for key in keys:
            given = getattr(spec, key) is not None
            if other is kind and not given:
                yield "", f"{name} is a link over {kind.value} and needs {key}"
            if other is not kind and given:
                yield key, f"{key} says nothing about a link over {kind.value}"
    limits = {"uart": (0, 1), "udp": (1, 65535), "local_port": (0, 65535), "tx": (0, 29), "rx": (0, 29)}
    limits |= {"baud": (300, 3000000), "buffer": (280, 65536)}
    for key, (low, high) in limits.items():
        value = getattr(spec, key)
        if value is not None and not low <= value <= high:
            yield key, f"{key} of {name} is {value}, not {low} to {high}"


def resolve_program(
    spec: VehicleSpec,
    written: ParametersSpec,
    parameters: Mapping[str, Parameter],
    components: Mapping[str, Component],
    dialect: Dialect,
    index: Mapping[str, Requirement],
    report: Report,
) -> Program | None:
    """The program of vehicle.yaml; None, with findings, where it cannot be built."""
    control = read_rate(spec.control.rate, spec.control.at("rate"), report)
    links = read_rate(spec.control.links, spec.control.at("links"), report)
    report_ms = read_time(spec.control.report_every, UNITS["ms"], spec.control.at("report_every"), report)
    for place, message in _program_problems(spec, components):
        report.add(BAD_PROGRAM, place, message)
    resolver = _FailsafeResolver(written, parameters, components, spec.actions, index, report)
    failsafes = [resolver.resolve(name, failsafe) for name, failsafe in spec.failsafes.items()]
    services = _service_messages(spec, dialect, report)
    cited = {}
    for name, text, place in (
        ("control", spec.control.requirement, spec.control.at("requirement")),
        ("storage", spec.storage.requirement, spec.storage.at("requirement")),
        ("arming", spec.arming.requirement, spec.arming.at("requirement")),
        ("services", spec.services.requirement, spec.services.at("requirement")),
    ):
        citation = cite_optional(text, place, index, report)
        if citation is not None:
            cited[name] = citation
    step_limit = read_time(spec.storage.step_limit, UNITS["us"], spec.storage.at("step_limit"), report)
    fastest = read_rate(spec.services.fastest, spec.services.at("fastest"), report)
    if control is None or links is None or report_ms is None or step_limit is None or fastest is None:
        return None
    if links > control:
        message = f"links are served in a pass of the main loop, and that runs at {spec.control.rate} only"
        report.add(BAD_PROGRAM, spec.control.at("links"), message)
    return Program(
        control_us=round(Fraction(1000000) / control),
        links_us=round(Fraction(1000000) / links),
        report_ms=report_ms,
        step_limit_us=step_limit,
        failsafes=tuple(failsafe for failsafe in failsafes if failsafe is not None),
        actions=spec.actions,
        services=services,
        sent=SENT,
        constants=_constants(spec, dialect, report),
        fastest=fastest,
        cited=cited,
        spec=spec,
    )


def _program_problems(spec: VehicleSpec, components: Mapping[str, Component]) -> Iterator[tuple[Place, str]]:
    vehicle = components.get("vehicle")
    if vehicle is None or vehicle.instances != 1:
        yield spec.place, "the state has no single component vehicle"
    for name, kind in VEHICLE_QUANTITIES.items() if vehicle else ():
        quantity = vehicle.quantities.get(name) if vehicle else None
        if quantity is None and vehicle and name in vehicle.spec.quantities:
            continue  # what is wrong with it has been reported
        if quantity is None or quantity.kind.value != kind or quantity.while_known or quantity.enabled_by:
            yield spec.place, f"the component vehicle of the state has no {kind} {name} that can be set"
    files = spec.storage.files
    if len(files) != 2 or files[0] == files[-1]:
        yield spec.storage.at("files"), "parameters are saved in turns in two files with different names"
    if not 16 <= spec.storage.chunk <= 256:
        yield spec.storage.at("chunk"), f"a step writes 16 to 256 bytes, not {spec.storage.chunk}"
    taken = set(_CALLS)
    values = {0}
    for action in spec.actions:
        if not re.fullmatch(r"[a-z][a-z0-9_]*", action.call) or keyword.iskeyword(action.call) or action.call in taken:
            yield action.at("call"), f"{action.call} cannot be the name of a call of its own"
        if action.value in values:
            yield action.at("value"), f"{action.value} stands for another action already, or for none"
        taken.add(action.call)
        values.add(action.value)


def _service_messages(spec: VehicleSpec, dialect: Dialect, report: Report) -> tuple[WireMessage, ...]:
    names = dict.fromkeys((*RECEIVED, *SENT))
    missing = [name for name in names if name not in dialect.messages]
    if missing:
        report.add(NO_SERVICE_MESSAGE, spec.place, f"{dialect.name} has no message {shortened_list(missing)}")
    return tuple(dialect.messages[name] for name in names if name in dialect.messages)


def _constants(spec: VehicleSpec, dialect: Dialect, report: Report) -> dict[str, int]:
    found, missing = {}, []
    for name, entries in SERVICE_ENTRIES.items():
        enum = dialect.enums.get(name)
        for suffix in entries.split():
            entry = enum.entry(f"{name}_{suffix}") or enum.entry(f"MAV_{suffix}") if enum else None
            if entry is None:
                missing.append(f"{name}_{suffix}")
            else:
                found[entry.name] = entry.value
    if missing:
        report.add(NO_SERVICE_MESSAGE, spec.place, f"{dialect.name} has no enum entry {shortened_list(missing)}")
    return found


class _FailsafeResolver:
    """Resolves failsafes; every problem of one is reported before it is given up."""

    def __init__(
        self,
        written: ParametersSpec,
        parameters: Mapping[str, Parameter],
        components: Mapping[str, Component],
        actions: tuple[ActionSpec, ...],
        index: Mapping[str, Requirement],
        report: Report,
    ) -> None:
        self.written = written
        self.parameters = parameters
        self.components = components
        self.actions = actions
        self.index = index
        self.report = report

    def resolve(self, name: str, spec: FailsafeSpec) -> Failsafe | None:
        """The failsafe of a component, or None after a finding."""
        component = self.components.get(name)
        citation = cite(spec.requirement, spec.at("requirement"), self.index, self.report)
        if component is None:
            hint = did_you_mean(name, self.components)
            self.report.add(BAD_FAILSAFE, spec.place, f"the state has no component {name}", hint)
            return None
        quantity = self._quantity(component, spec, "quantity", spec.quantity)
        if quantity is None:
            return None
        if quantity.conversion is None:
            self.report.add(BAD_FAILSAFE, spec.at("quantity"), f"{quantity.path} is not measured by an ADC")
            return None
        low = self._level(spec.low, quantity)
        critical = self._level(spec.critical, quantity)
        after = self._parameter(spec, "after", spec.after)
        if after is not None and (after.unit is not UNITS["s"] or after.step != 1 or after.minimum < 0):
            self.report.add(BAD_FAILSAFE, spec.at("after"), f"{after.name} is not a time in whole seconds")
        minimum = self._threshold(spec, "minimum_to_arm", spec.minimum_to_arm, quantity)
        health = self._quantity(component, spec, "health", spec.health)
        if health is not None and (health.kind is not QuantityKind.NUMBER or health.initial is None):
            self.report.add(BAD_FAILSAFE, spec.at("health"), f"{health.path} is not a number with an initial value")
        used = self._quantity(component, spec, "used", spec.used)
        if used is not None and used.stored is not UNITS["mAh"]:
            self.report.add(BAD_FAILSAFE, spec.at("used"), f"{used.path} is not kept in mAh")
        if low is None or critical is None or after is None or citation is None:
            return None
        return Failsafe(component, quantity, low, critical, after, minimum, health, used, spec, citation)

    def _level(self, spec: FailsafeLevelSpec, quantity: Quantity) -> FailsafeLevel | None:
        citation: Citation | None = cite_optional(spec.requirement, spec.at("requirement"), self.index, self.report)
        below = self._threshold(spec, "below", spec.below, quantity)
        action = self._parameter(spec, "action", spec.action)
        if action is not None:
            known = {0, *(entry.value for entry in self.actions)}
            possible = set(action.choices) or set(range(action.minimum, action.maximum + 1))
            lacking = sorted(possible - known)
            if lacking and len(known) > len(self.actions):  # else one of them has the value of another
                are = "is" if len(lacking) == 1 else "are"
                message = f"{shortened_list(map(str, lacking))} of {action.name} {are} none of the actions"
                self.report.add(BAD_FAILSAFE, spec.at("action"), message)
        return None if below is None or action is None else FailsafeLevel(below, action, citation)

    def _threshold(
        self, spec: FailsafeSpec | FailsafeLevelSpec, key: str, name: str | None, quantity: Quantity
    ) -> Parameter | None:
        parameter = None if name is None else self._parameter(spec, key, name)
        if parameter is None:
            return None
        steps = parameter.unit.to(quantity.stored)
        if steps is None or (steps * parameter.step).denominator != 1 or parameter.minimum != 0:
            message = (
                f"{parameter.name} is no threshold for {quantity.path}: from 0 on, in whole {quantity.stored.name}"
            )
            self.report.add(BAD_FAILSAFE, spec.at(key), message)
            return None
        return parameter

    def _parameter(self, spec: FailsafeSpec | FailsafeLevelSpec, key: str, name: str) -> Parameter | None:
        return find_parameter(name, spec.at(key), self.written, self.parameters, self.report)

    def _quantity(self, component: Component, spec: FailsafeSpec, key: str, name: str | None) -> Quantity | None:
        quantity = component.quantities.get(name) if name else None
        if quantity is None and name and name not in component.spec.quantities:
            hint = did_you_mean(name, component.quantities)
            self.report.add(UNKNOWN_QUANTITY, spec.at(key), f"{component.name} has no quantity {name}", hint)
        return quantity
