"""Sensors with ``driver: adc``: the same as a channel under ``adc`` and a quantity that names it, written in one place.

What comes behind this knows channels alone.
"""

from collections.abc import Mapping
from dataclasses import replace

from codegen.diagnostics import Report
from codegen.model.spec.board import AdcSpec
from codegen.model.spec.derivation import MeasuredSpec, SourcedSpec, WrittenDerivation
from codegen.model.spec.described import Amount
from codegen.model.spec.spec import Spec
from codegen.model.spec.state import ComponentSpec, QuantitySpec
from codegen.source import Place
from codegen.sources.adc.spec import AdcSourceSpec
from codegen.sources.kind import BAD_SOURCE

_RATE = Amount("10 Hz")


def with_adc_channels(spec: Spec, report: Report) -> Spec:
    """The specification with a channel in place of each sensor whose driver is the board's converter."""
    inputs = {name: each for name, each in spec.board.sources.items() if isinstance(each, AdcSourceSpec)}
    if not inputs:
        return spec
    for name, written in inputs.items():
        if name in spec.board.adc:
            report.add(BAD_SOURCE, written.place, f"{name} stands under adc, too", "leave out one of them")
        if written.retry is not None:
            message = "an input that could not be set up is tried again with each text about it"
            report.add(BAD_SOURCE, written.at("retry"), message, "leave it out")
    channels = {name: _channel(written) for name, written in inputs.items()}
    rest = {name: each for name, each in spec.board.sources.items() if name not in inputs}
    places = {**spec.board.places, **{f"adc.{name}": each.place for name, each in inputs.items()}}
    components = {name: _component(component, inputs, report) for name, component in spec.state.components.items()}
    return replace(
        spec,
        board=replace(spec.board, adc={**spec.board.adc, **channels}, sources=rest, places=places),
        state=replace(spec.state, components=components),
    )


def _channel(written: AdcSourceSpec) -> AdcSpec:
    criteria = {"read_limit" if aspect == "limit" else aspect: each for aspect, each in written.criteria.items()}
    return AdcSpec(
        place=written.place,
        places={
            **written.places,
            "read_limit": written.at("limit"),
            "criteria.read_limit": written.at("criteria.limit"),
        },
        gpio=written.gpio,
        pin=written.pin,
        when=written.when,
        bits=written.bits,
        reference=written.reference,
        samples=written.samples,
        read_limit=written.limit,
        requirement=written.requirement,
        criteria=criteria,
    )


def _component(component: ComponentSpec, inputs: Mapping[str, AdcSourceSpec], report: Report) -> ComponentSpec:
    """A component whose quantities name channels, and are read at the rate of these."""
    quantities = {name: _quantity(quantity, inputs, report) for name, quantity in component.quantities.items()}
    read = [inputs[name] for each in component.quantities.values() if (name := _input(each, inputs)) is not None]
    if not read:
        return replace(component, quantities=quantities)
    rates = [(each.rate, each.at("rate")) for each in read if each.rate is not None]
    if component.update_rate is not None:
        rates.insert(0, (component.update_rate, component.at("update_rate")))
    (rate, place), *others = rates or [(_RATE, component.place)]
    for other, there in others:
        if other != rate:
            related = ((place, f"{rate} stands here"),)
            message = "inputs of one component are read together, at one rate"
            report.add(BAD_SOURCE, there, message, f"rate: {rate}", related)
    places = {**component.places, "update_rate": place}
    return replace(component, quantities=quantities, update_rate=rate, places=places)


def _input(quantity: QuantitySpec, inputs: Mapping[str, AdcSourceSpec]) -> str | None:
    """The input that gives a quantity, None where none does."""
    sourced = quantity.written(SourcedSpec)
    named = sourced.source if sourced else None
    return named if isinstance(named, str) and named in inputs else None


def _quantity(quantity: QuantitySpec, inputs: Mapping[str, AdcSourceSpec], report: Report) -> QuantitySpec:
    """A quantity that names a channel where it named a sensor that is one."""
    sourced = quantity.written(SourcedSpec)
    if sourced is None:
        return quantity
    name = _input(quantity, inputs)
    if name is None:
        _check_names(sourced, inputs, report)
        return quantity
    measured = quantity.written(MeasuredSpec)
    rest = tuple(each for each in quantity.derivations if each not in (sourced, measured))
    read: WrittenDerivation = _measured(name, inputs[name], sourced, measured, report)
    places = {**quantity.places, **{key: read.at(key) for key in ("adc", "multiplier", "offset") if key in read.places}}
    return replace(quantity, derivations=(*rest, read), places=places)


def _check_names(sourced: SourcedSpec, inputs: Mapping[str, AdcSourceSpec], report: Report) -> None:
    names = (sourced.source,) if isinstance(sourced.source, str) else sourced.source
    for name in names:
        known = name.partition(".")[0]
        if known in inputs:
            message = f"{known} gives one number, and reads it of each instance"
            report.add(BAD_SOURCE, sourced.at("source"), message, f"source: {known}")


def _measured(
    name: str, given: AdcSourceSpec, sourced: SourcedSpec, measured: MeasuredSpec | None, report: Report
) -> MeasuredSpec:
    """Return what a quantity says of its readings, with what the input says of them."""
    own: MeasuredSpec = measured or MeasuredSpec(place=sourced.place, places=sourced.places)
    places: dict[str, Place] = {**own.places, "adc": sourced.at("source")}
    for key in ("multiplier", "offset"):
        if getattr(given, key) is None:
            continue
        if getattr(own, key) is not None:
            related = ((given.at(key), "it stands here, too"),)
            report.add(BAD_SOURCE, own.at(key), f"the {key} of {name} stands at the sensor", "leave out one", related)
        places[key] = given.at(key)
    return replace(
        own,
        adc=name,
        multiplier=given.multiplier if given.multiplier is not None else own.multiplier,
        offset=given.offset if given.offset is not None else own.offset,
        places=places,
    )
