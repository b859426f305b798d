"""The board, the parameters and the streams of the specification, resolved."""

import re
from collections.abc import Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.spec import BoardSpec, ParameterSpec, ParametersSpec, Requirement, Spec, StreamSpec
from codegen.model.system import SMALL_INT_MAX, AdcChannel, Citation, Parameter, Stream
from codegen.model.unit import UNITS
from codegen.resolve.citation import cite_aspects, cite_optional
from codegen.resolve.measure import DAY_S, find_unit, read_amount, read_rate, read_time

BAD_ADC = Rule(
    "bad-adc",
    "An ADC channel cannot be built: the RP2040 and RP2350 have ADC inputs on GPIO 26 to 29, "
    "a count has 8 to 12 bits, and a mean needs 1 to 64 samples.",
)
BAD_PARAMETER = Rule(
    "bad-parameter",
    "A parameter contradicts itself: names have at most 16 characters of A-Z, 0-9 and _; min <= default <= max; "
    "all three are whole multiples of step and, in steps, fit a small integer of MicroPython.",
)
BAD_STREAM = Rule(
    "bad-stream",
    "A stream has exactly one of rate and parameter; the parameter is in Hz, from 0 (off) to at most 1000.",
)
UNKNOWN_PARAMETER = Rule("unknown-parameter", "A table names a parameter that parameters.yaml does not have.")


def resolve_channels(board: BoardSpec, index: Mapping[str, Requirement], report: Report) -> dict[str, AdcChannel]:
    """The ADC channels by name."""
    channels = {}
    for name, spec in board.adc.items():
        citation = cite_optional(spec.requirement, spec.at("requirement"), index, report)
        reference = read_amount(spec.reference, UNITS["V"], spec.at("reference"), report)
        limit = None
        if spec.read_limit is not None:
            limit = read_time(spec.read_limit, UNITS["us"], spec.at("read_limit"), report)
        sane = True
        for key, value, low, high in (
            ("gpio", spec.gpio, 26, 29),
            ("bits", spec.bits, 8, 12),
            ("samples", spec.samples, 1, 64),
        ):
            if not low <= value <= high:
                report.add(BAD_ADC, spec.at(key), f"{key} of {name} is {value}, not {low} to {high}")
                sane = False
        if reference is not None and reference <= 0:
            report.add(BAD_ADC, spec.at("reference"), f"the reference of {name} is not above 0 V")
            sane = False
        if reference is None or not sane:
            continue
        channels[name] = AdcChannel(
            name=name,
            gpio=spec.gpio,
            bits=spec.bits,
            full_scale=(1 << spec.bits) - 1,
            reference=reference,
            samples=spec.samples,
            read_limit_us=limit,
            spec=spec,
            citation=citation,
            aspects=cite_aspects(spec, index, report),
        )
    return channels


def resolve_parameters(spec: ParametersSpec, index: Mapping[str, Requirement], report: Report) -> dict[str, Parameter]:
    """The parameters by name."""
    parameters = {}
    for name, written in spec.parameters.items():
        citation = cite_optional(written.requirement, written.at("requirement"), index, report)
        parameter = _resolve_parameter(name, written, citation, report)
        if parameter is not None:
            parameters[name] = parameter
    return parameters


def _resolve_parameter(name: str, spec: ParameterSpec, citation: Citation | None, report: Report) -> Parameter | None:
    problems: list[tuple[str, str]] = []
    if not re.fullmatch(r"[A-Z][A-Z0-9_]{0,15}", name):
        problems.append(("", f"{name} is not a parameter name"))
    if spec.step <= 0:
        problems.append(("step", f"the step of {name} is not above 0"))
    else:
        for key in ("default", "min", "max"):
            steps = getattr(spec, key) / spec.step
            if steps.denominator != 1:
                problems.append((key, f"{key} of {name} is not a whole number of steps"))
            elif abs(steps) > SMALL_INT_MAX:
                problems.append((key, f"{key} of {name} is {steps} steps, more than a small integer holds"))
    if spec.min > spec.max:
        problems.append(("max", f"max of {name} is below its min"))
    elif not spec.min <= spec.default <= spec.max:
        problems.append(("default", f"default of {name} is not between its min and max"))
    for key, message in problems:
        report.add(BAD_PARAMETER, spec.at(key), message)
    unit = find_unit(spec.unit, spec.at("unit"), report)
    if problems or unit is None:
        return None
    return Parameter(
        name=name,
        unit=unit,
        step=spec.step,
        default=_in_steps(spec.default, spec.step),
        minimum=_in_steps(spec.min, spec.step),
        maximum=_in_steps(spec.max, spec.step),
        spec=spec,
        citation=citation,
    )


def _in_steps(value: Fraction, step: Fraction) -> int:
    return int(value / step)


def resolve_streams(
    spec: Spec, parameters: Mapping[str, Parameter], index: Mapping[str, Requirement], report: Report
) -> dict[str, Stream]:
    """The streams by name."""
    streams = {}
    for name, written in spec.streams.streams.items():
        stream = _resolve_stream(name, written, spec.parameters, parameters, index, report)
        if stream is not None:
            streams[name] = stream
    return streams


def _resolve_stream(
    name: str,
    spec: StreamSpec,
    written: ParametersSpec,
    parameters: Mapping[str, Parameter],
    index: Mapping[str, Requirement],
    report: Report,
) -> Stream | None:
    citation = cite_optional(spec.requirement, spec.at("requirement"), index, report)
    if not re.fullmatch(r"[A-Za-z]\w*", name, re.ASCII):
        report.add(BAD_STREAM, spec.place, f"{name} cannot be the name of a stream", "use letters, digits and _")
    if (spec.rate is None) == (spec.parameter is None):
        report.add(BAD_STREAM, spec.place, f"stream {name} needs exactly one of rate and parameter")
        return None
    if spec.rate is not None:
        rate = read_rate(spec.rate, spec.at("rate"), report)
        return None if rate is None else Stream(name, rate, None, spec, citation)
    assert spec.parameter is not None
    parameter = parameters.get(spec.parameter)
    if parameter is None:
        if spec.parameter not in written.parameters:
            hint = did_you_mean(spec.parameter, parameters)
            report.add(UNKNOWN_PARAMETER, spec.at("parameter"), f"there is no parameter {spec.parameter}", hint)
        return None
    largest = parameter.maximum * parameter.step
    if parameter.unit.name != "Hz" or parameter.minimum < 0 or largest > 1000 or parameter.step * DAY_S < 1:
        report.add(
            BAD_STREAM,
            spec.at("parameter"),
            f"{parameter.name} is not a rate from 0 to 1000 Hz",
            related=[(parameter.spec.at("unit"), f"{parameter.name} is declared here")],
        )
        return None
    return Stream(name, None, parameter, spec, citation)
