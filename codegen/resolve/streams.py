"""Streams: at which rate their messages go out, and what ground stations can ask for."""

import re
from collections.abc import Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.measure import DAY_S, read_rate
from codegen.model.dialect.dialect import Dialect
from codegen.model.spec.spec import ParametersSpec, Requirement, Spec, StreamSpec
from codegen.model.units.unit import decimal
from codegen.model.vehicle import SLOWEST_ASKED, Parameter, Stream
from codegen.resolve.citation import cite_optional
from codegen.resolve.in_force import check_at_once
from codegen.resolve.vehicle import find_parameter

BAD_STREAM = Rule(
    "bad-stream",
    "A stream has exactly one of rate and parameter; the parameter is in Hz, from 0 (off) to at most 1000, and "
    "without reboot: the stream follows it at once. Its data_stream is an entry of MAV_DATA_STREAM, and fastest is at "
    "most 1000 Hz. Nothing goes faster than that: it is neither below the rate nor below the maximum of the "
    "parameter. What goes less often than once in 1073 s, the longest interval that a ground station can ask for, has "
    "a fixed rate.",
    remedy="write an entry of MAV_DATA_STREAM, such as MAV_DATA_STREAM_EXTRA1, or leave data_stream out",
)


def resolve_streams(
    spec: Spec,
    dialect: Dialect,
    parameters: Mapping[str, Parameter],
    index: Mapping[str, Requirement],
    report: Report,
) -> dict[str, Stream]:
    """The streams by name."""
    streams = {}
    for name, written in spec.streams.streams.items():
        number = _data_stream(written, dialect, report)
        stream = _resolve_stream(name, written, number, spec.parameters, parameters, index, report)
        if stream is not None:
            streams[name] = stream
    return streams


def _data_stream(spec: StreamSpec, dialect: Dialect, report: Report) -> int | None:
    name, enum = spec.data_stream, dialect.enums.get("MAV_DATA_STREAM")
    if name is None:
        return None
    entry = enum.entry(name) if enum else None
    if entry is None or entry.value == 0:  # 0 stands for all of them
        names = [entry.name for entry in enum.entries if entry.value] if enum else []
        message = f"{name} is no single stream of MAV_DATA_STREAM"
        report.add(BAD_STREAM, spec.at("data_stream"), message, did_you_mean(name, names))
        return None
    return entry.value


def _resolve_stream(
    name: str,
    spec: StreamSpec,
    number: int | None,
    written: ParametersSpec,
    parameters: Mapping[str, Parameter],
    index: Mapping[str, Requirement],
    report: Report,
) -> Stream | None:
    citation = cite_optional(spec.requirement, spec.at("requirement"), index, report)
    if not re.fullmatch(r"[A-Za-z]\w*", name, re.ASCII):
        report.add(BAD_STREAM, spec.place, f"{name} cannot be the name of a stream", "use letters, digits and _")
    if spec.has_unread("rate", "parameter"):
        return None
    if (spec.rate is None) == (spec.parameter is None):
        report.add(
            BAD_STREAM,
            spec.place,
            f"stream {name} needs exactly one of rate and parameter",
            hint="rate: 1 Hz, or parameter: and the name of one in Hz",
        )
        return None
    fastest = None if spec.fastest is None else read_rate(spec.fastest, spec.at("fastest"), report)
    if spec.rate is not None:
        rate = read_rate(spec.rate, spec.at("rate"), report)
        if rate is None or not _is_fast_enough(name, spec, rate, fastest, report):
            return None
        return Stream(name, rate, None, number, fastest or rate, spec, citation)
    assert spec.parameter is not None
    parameter = find_parameter(spec.parameter, spec.at("parameter"), written, parameters, report)
    if parameter is None:
        return None
    largest = parameter.maximum * parameter.step
    if parameter.unit.name != "Hz" or parameter.minimum < 0 or largest > 1000 or parameter.step * DAY_S < 1:
        report.add(
            BAD_STREAM,
            spec.at("parameter"),
            f"{parameter.name} is not a rate from 0 to 1000 Hz",
            related=[(parameter.spec.at("unit"), f"{parameter.name} is declared here")],
            hint=f"declare {parameter.name} with unit: Hz, min: 0, max: 50 and step: 0.1",
        )
        return None
    check_at_once(parameter, "a stream", BAD_STREAM, spec.at("parameter"), report)
    if not _is_fast_enough(name, spec, largest, fastest, report):
        return None
    return Stream(name, None, parameter, number, fastest or largest, spec, citation)


def _is_fast_enough(name: str, spec: StreamSpec, own: Fraction, fastest: Fraction | None, report: Report) -> bool:
    """Return whether ``fastest`` is not below the stream's ``own`` highest rate, and can be asked for if it is above.

    All in Hz. What is slower than the longest interval that can be asked for has to have a fixed rate, and no other.
    """
    if fastest is not None and fastest < own:
        whose = f"{spec.parameter} goes up to" if spec.parameter else "its rate is"
        report.add(
            BAD_STREAM,
            spec.at("fastest"),
            f"stream {name}: {whose} {decimal(own)} Hz, above fastest",
            f"fastest: {decimal(own)} Hz" + (f", or a lower max of {spec.parameter}" if spec.parameter else ""),
            [(spec.at("parameter" if spec.parameter else "rate"), "the rate is stated here")],
        )
        return False
    highest = fastest or own
    if highest < SLOWEST_ASKED and (spec.parameter or highest != own):
        report.add(
            BAD_STREAM,
            spec.at("fastest" if fastest else "parameter"),
            f"stream {name}: {decimal(highest)} Hz is less often than once in 1073 s, the longest interval to ask for",
            "a fixed rate, without fastest",
        )
        return False
    return True
