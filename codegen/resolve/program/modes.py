"""The modes that vehicle.yaml declares."""

from collections.abc import Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.code.storage import Storage
from codegen.model.command import Mode
from codegen.model.spec.program import ModeSpec, VehicleSpec
from codegen.model.spec.spec import Requirement
from codegen.model.spec.state import StateSpec
from codegen.model.vehicle import Component, Quantity, QuantityKind
from codegen.resolve.citation import cite_optional

BAD_MODE = Rule(
    "bad-mode",
    "A mode has a whole number that vehicle.mode of the state and the float of a command can have, and a name of its "
    "own; what its base lists are booleans of the component vehicle that can be set. Where modes are declared, the one "
    "at the start and those of actions are among them.",
    remedy="name a boolean of the component vehicle that code sets",
)


def resolve_modes(
    spec: VehicleSpec,
    components: Mapping[str, Component],
    state: StateSpec,
    index: Mapping[str, Requirement],
    report: Report,
) -> tuple[Mode, ...]:
    """The modes in the order of the file; what has a finding is left out."""
    if not spec.modes:
        return ()
    vehicle = components.get("vehicle")
    quantity = vehicle.quantities.get("mode") if vehicle and vehicle.instances == 1 else None
    if vehicle is None or quantity is None or quantity.kind is not QuantityKind.NUMBER:
        if not has_unread_mode(vehicle, state):
            report.add(
                BAD_MODE,
                spec.at("modes"),
                "the component vehicle of the state has no number mode to be set",
                hint="mode: {doc: Number of the mode., min: 0, max: 30, initial: 0}",
            )
        return ()
    found: dict[int, Mode] = {}
    for key, mode in spec.modes.items():
        citation = cite_optional(mode.requirement, mode.at("requirement"), index, report)
        if not key.isascii() or not key.isdigit() or not quantity.minimum <= int(key) <= quantity.maximum:
            report.add(
                BAD_MODE,
                mode.place,
                f"{key} is not a mode that vehicle.mode can have",
                hint=f"take a whole number from {quantity.minimum} to {quantity.maximum}",
            )
            continue
        near = Storage.BINARY32.nearest(Fraction(int(key)))
        if near != int(key):
            message = f"MAV_CMD_DO_SET_MODE cannot change to {key}: its float of 32 bits makes {near} of it"
            report.add(BAD_MODE, mode.place, message, f"take {near}, or a number up to {2**24}")
        if any(mode.name == other.name for other in found.values()):
            report.add(
                BAD_MODE,
                mode.at("name"),
                f"{mode.name} is the name of another mode already",
                hint="choose another name",
            )
        found[int(key)] = Mode(int(key), mode.name, _base(mode, vehicle, report), citation, mode)
    _check_uses(spec, quantity, found, report)
    return tuple(found.values())


def has_unread_mode(vehicle: Component | None, state: StateSpec) -> bool:
    """Return whether ``vehicle.mode`` is written in a way that could not be read, which has been reported."""
    return (vehicle is None or "mode" not in vehicle.quantities) and state.is_written("vehicle", "mode")


def _base(mode: ModeSpec, vehicle: Component, report: Report) -> tuple[Quantity, ...]:
    found = []
    for index, name in enumerate(mode.base):
        quantity = vehicle.quantities.get(name)
        place = mode.at(f"base[{index}]")
        if name in mode.base[:index]:
            report.add(BAD_MODE, place, f"{name} is listed twice", "leave out the second one")
        elif quantity is None:
            if not vehicle.spec.is_written(name):
                hint = did_you_mean(name, vehicle.quantities)
                report.add(BAD_MODE, place, f"the component vehicle has no quantity {name}", hint)
        elif quantity.kind is not QuantityKind.BOOLEAN or not quantity.derivation.is_set_by_code or name in _OWN:
            report.add(
                BAD_MODE,
                place,
                f"{quantity.path} is no boolean that a mode can set",
                hint="name a boolean of the component vehicle that code sets",
            )
        else:
            found.append(quantity)
    return tuple(found)


_OWN = ("armed", "ready")
"""Booleans of the vehicle that tell something else."""


def _check_uses(spec: VehicleSpec, quantity: Quantity, modes: Mapping[int, Mode], report: Report) -> None:
    """Report what names a mode elsewhere that is not declared."""
    if len(modes) < len(spec.modes):
        return  # a mode that is wrong may be the one that is meant
    known = ", ".join(f"{mode.number} {mode.name}" for mode in modes.values())
    for action in spec.actions:
        if action.mode is not None and action.mode not in modes:
            message = f"{action.call} changes to mode {action.mode}, which is not declared"
            report.add(BAD_MODE, action.at("mode"), message, f"the modes are {known}")
    if quantity.initial is not None and quantity.initial not in modes:
        message = f"vehicle.mode begins as {quantity.initial}, which is no declared mode"
        report.add(BAD_MODE, quantity.spec.at("initial"), message, f"the modes are {known}")
