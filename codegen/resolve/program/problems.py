"""Findings about a program as a whole: vehicle.yaml against the state, and against names that are taken."""

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import NamedTuple

from codegen.model.code.storage import Storage
from codegen.model.program import VEHICLE_QUANTITIES, can_be_set_as, is_set_by_program
from codegen.model.spec.program import CodeSpec, VehicleSpec
from codegen.model.spec.state import StateSpec
from codegen.model.vehicle import Component
from codegen.resolve.named import is_name
from codegen.resolve.program.modes import has_unread_mode
from codegen.resolve.program.vehicle_names import is_vehicle_name
from codegen.source import Place
from codegen.sources.module_names import taken_by

_WRITTEN = {
    "armed": "armed: {doc: Whether it is armed., boolean: true, initial: false}",
    "ready": "ready: {doc: Whether nothing speaks against arming., boolean: true, initial: false}",
    "status": "status: {doc: What it is doing., enum: MAV_STATE, initial: MAV_STATE_STANDBY}",
    "mode": "mode: {doc: Number of the mode., min: 0, max: 30, initial: 0}",
    "load": 'load: {doc: Of the main loop., unit: "%", stored: d%, min: 0, max: 100, initial: 0}',
}
"""The quantities that arming needs, as state.yaml has them."""
_USUAL_FORCE = "force: 21196, as ground stations send it"


class Problem(NamedTuple):
    """A finding about the program: its place, the message, and a hint."""

    place: Place
    message: str
    hint: str | None = None


def program_problems(spec: VehicleSpec, components: Mapping[str, Component], state: StateSpec) -> Iterator[Problem]:
    """Yield what keeps the program from being built, but for what other modules find in their parts of it."""
    vehicle = components.get("vehicle")
    if spec.arming is None:
        yield from _without_arming(spec, vehicle, state)
    elif vehicle.instances != 1 if vehicle else not state.has_written("vehicle"):
        hint = "arming needs components: {vehicle: {...}} in state.yaml, with armed, ready, status, mode and load"
        yield Problem(spec.place, "the state has no single component vehicle", hint)
    for name, kind in VEHICLE_QUANTITIES.items() if vehicle and spec.arming else ():
        quantity = vehicle.quantities.get(name) if vehicle else None
        if quantity is None and vehicle and vehicle.spec.is_written(name):
            continue  # what is wrong with it has been reported
        if quantity is None or not can_be_set_as(quantity, name):
            message = f"arming needs a {kind} {name} that can be set in the component vehicle of the state"
            yield Problem(spec.at("arming"), message, f"write below its quantities: {_WRITTEN[name]}")
    files = spec.storage.files
    if len(files) != 2:
        message = f"parameters are saved in turns in two files, not {len(files)}"
        yield Problem(spec.storage.at("files"), message, "files: [parameters.0, parameters.1]")
    if not 16 <= spec.storage.chunk <= 256:
        message = f"a step writes 16 to 256 bytes, not {spec.storage.chunk}"
        yield Problem(spec.storage.at("chunk"), message, "chunk: 64")
    yield from _force(spec)
    yield from _actions(spec, vehicle)
    yield from _code(spec.code)


def _without_arming(spec: VehicleSpec, vehicle: Component | None, state: StateSpec) -> Iterator[Problem]:
    is_broken = has_unread_mode(vehicle, state)
    for action in spec.actions:
        if action.disarm:
            message = f"{action.call} cannot disarm what cannot be armed"
            yield Problem(action.at("disarm"), message, "leave disarm out, or write arming: {force: 21196}")
        if action.mode is not None and not is_broken and not is_set_by_program(vehicle, "mode"):
            message = "the state has no number mode in a single component vehicle"
            yield Problem(action.at("mode"), message, f"leave mode out, or write in state.yaml: {_WRITTEN['mode']}")


def _code(code: CodeSpec | None) -> Iterator[Problem]:
    if code is None:
        return
    owner = taken_by(code.module)
    if not is_name(code.module):
        message = f"{code.module} cannot be the name of a module"
        yield Problem(code.at("module"), message, "take a lower-case identifier that is no word of Python")
    elif owner is not None:
        message = f"{code.module} cannot be the name of a module of yours: {owner} has one"
        yield Problem(code.at("module"), message, f"rename yours: module: my_{code.module}")
    if not is_name(code.class_name.lower()) or code.class_name == "Vehicle":
        message = f"{code.class_name} cannot be the name of a class of its own"
        yield Problem(code.at("class"), message, "class: Boat")


def _force(spec: VehicleSpec) -> Iterator[Problem]:
    """Yield that everybody sends the number by which a command to arm passes over the checks, or that nobody can."""
    if spec.arming is None:
        return
    force, place = spec.arming.force, spec.arming.at("force")
    if force == 0:
        message = "0 is what every command to arm has there: each of them would pass over the checks"
        yield Problem(place, message, _USUAL_FORCE)
    elif Storage.BINARY32.nearest(Fraction(force)) != force:
        message = f"nobody can send {force}: parameters of commands are floats of 32 bits, which do not carry it"
        yield Problem(place, message, _USUAL_FORCE)


def _actions(spec: VehicleSpec, vehicle: Component | None) -> Iterator[Problem]:
    taken: set[str] = set()
    values = {0}
    for action in spec.actions if not spec.failsafes else ():
        message = f"{action.call} is what a failsafe does, and there is none"
        yield Problem(action.place, message, "write failsafes: with a level that has it, or leave it out")
    for action in spec.actions:
        if not is_name(action.call) or is_vehicle_name(action.call) or action.call in taken:
            message = f"{action.call} cannot be the name of a call of its own"
            yield Problem(action.at("call"), message, "take a lower-case identifier that no other call has")
        if action.value in values:
            message = f"{action.value} stands for another action already, or for none"
            free = 1 + max(values | {each.value for each in spec.actions})
            yield Problem(action.at("value"), message, f"{free} is free")
        mode = vehicle.quantities.get("mode") if vehicle else None
        if mode is not None and action.mode is not None and not mode.minimum <= action.mode <= mode.maximum:
            message = f"{action.mode} is not a mode that vehicle.mode can have"
            yield Problem(action.at("mode"), message, f"it goes from {mode.minimum} to {mode.maximum} in state.yaml")
        taken.add(action.call)
        values.add(action.value)
