"""The sensors of the board."""

from collections.abc import Mapping

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.measure import read_rate, read_time
from codegen.model.board_model import BoardModel
from codegen.model.quantities.source_kind import Polling, Source
from codegen.model.spec.source import OwnSourceSpec, SourceSpec
from codegen.model.spec.spec import Requirement, Spec
from codegen.model.units.unit import unit_named
from codegen.resolve.citation import cite_aspects, cite_optional
from codegen.resolve.quantities.quantity import is_name
from codegen.sources import KINDS
from codegen.sources.kind import BAD_SOURCE, Around
from codegen.sources.own.kind import resolve_own

UNKNOWN_DRIVER = Rule(
    "unknown-driver",
    "A sensor names a driver that there is none of: neither one that comes with codegen, nor a file NAME.yaml in the "
    "folder drivers of the specification.",
    remedy="write drivers/NAME.yaml and NAME.py, or take driver: user with a class of your own",
)
_RETRY_MS = 1000
_RESERVED = {"every", "turn", "watch"}
"""Names that the class of all sensors uses itself."""


def resolve_sources(
    spec: Spec,
    board: BoardModel | None,
    index: Mapping[str, Requirement],
    report: Report,
) -> dict[str, Source]:
    """The sensors by name, in the order of board.yaml."""
    sources = {}
    for name, written in spec.board.sources.items():
        if not is_name(name) or name in _RESERVED:
            report.add(BAD_SOURCE, written.place, f"{name} cannot be the name of a sensor", "choose another name")
            continue
        kind, own = KINDS.get(written.driver), spec.drivers.get(written.driver)
        if kind is None and own is None:
            if written.driver not in spec.broken_drivers:
                hint = did_you_mean(written.driver, (*KINDS, *spec.own_drivers))
                report.add(UNKNOWN_DRIVER, written.at("driver"), f"there is no driver {written.driver}", hint)
            continue
        around = Around(written, board, spec, report)
        usual = kind.rate if kind else (own.spec.rate if own else None) or "10 Hz"
        polling = _polling(name, written, usual, index, report)
        if polling is None:
            continue
        source = None
        if kind is not None:
            source = kind.resolve(written, polling, around)
        elif own is not None and isinstance(written, OwnSourceSpec):
            source = resolve_own(written, polling, around, own)
        if source is not None and not around.failed:
            sources[name] = source
    return sources


def _polling(
    name: str, spec: SourceSpec, usual: str, index: Mapping[str, Requirement], report: Report
) -> Polling | None:
    """Return what all sensors have in common; None after a finding."""
    rate = read_rate(spec.rate or usual, spec.at("rate"), report)
    limit = None if spec.limit is None else read_time(spec.limit, unit_named("us"), spec.at("limit"), report)
    retry = _RETRY_MS if spec.retry is None else read_time(spec.retry, unit_named("ms"), spec.at("retry"), report)
    citation = cite_optional(spec.requirement, spec.at("requirement"), index, report)
    aspects = cite_aspects(spec, index, report)
    if rate is None or retry is None or (limit is None and spec.limit is not None):
        return None
    period_us = round(1000000 / rate)
    if period_us >= 1 << 29:
        report.add(BAD_SOURCE, spec.at("rate"), f"{name} is asked less than once in nine minutes", hint="rate: 1 Hz")
        return None
    if limit is not None and limit > period_us:
        longest = f"{period_us} us" if period_us % 1000 else f"{period_us // 1000} ms"
        message = f"{name} may take {spec.limit} each time, and is asked every {longest}"
        report.add(BAD_SOURCE, spec.at("limit"), message, f"limit: {longest} at most, such as 2 ms")
        return None
    return Polling(citation, aspects, name, period_us, limit, retry, spec)
