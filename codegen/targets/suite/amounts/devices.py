"""Cases of the way from a sensor's device to the state: what it shows, by its data sheet, is what the state keeps."""

from collections.abc import Iterator
from typing import NamedTuple

from codegen.model.quantities.device import Device
from codegen.model.quantities.source_kind import Source
from codegen.model.system import System
from codegen.targets.suite.amounts.case import ARRIVES, AmountCase, criterion_of, name_of, owner_of, stored_of


class DeviceOf(NamedTuple):
    """A sensor with its device."""

    source: Source
    device: Device


def devices_of(system: System) -> tuple[DeviceOf, ...]:
    """The sensors of whose devices there is a model; all of them show something else."""
    found = ((source, source.device(number)) for number, source in enumerate(system.polled))
    return tuple(DeviceOf(source, device) for source, device in found if device is not None)


def arriving_cases(system: System) -> Iterator[AmountCase]:
    """A case for each quantity that such a sensor gives to an instance, with what is kept of each thing shown."""
    devices = {each.source.name: each for each in devices_of(system)}
    for component in system.components.values():
        for quantity in component.quantities.values():
            for instance, (sensor, output, _) in enumerate(quantity.derivation.gives):
                if sensor not in devices:
                    continue
                source, device = devices[sensor]
                kept = [stored_of(shown.amounts[output.name], quantity) for shown in device.shows]
                name = f"{name_of(quantity, component, instance)}-arrives"
                criterion = str(quantity.citation or "") or source.polling.cited("range")
                facts = {**owner_of(quantity, instance), "sensor": sensor, "kept": kept}
                yield AmountCase(name, criterion or criterion_of(quantity, component), ARRIVES, facts)
