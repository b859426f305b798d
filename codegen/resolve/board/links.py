"""The links of the board to ground stations."""

import keyword
import re
from collections.abc import Iterator, Mapping

from codegen.diagnostics import Report, Rule
from codegen.measure import read_time
from codegen.model.board_model import BoardModel, shown_pins
from codegen.model.program import BoardLink, LinkKind
from codegen.model.spec.board import BoardSpec, LinkSpec
from codegen.model.spec.spec import Requirement
from codegen.model.units.unit import unit_named
from codegen.resolve.citation import cite_optional
from codegen.source import Place

BAD_LINK = Rule(
    "bad-link",
    "A link cannot be built: its name is a lower-case identifier, a UART is one of the board's with tx, rx and baud, "
    "UDP has a port, an address to start with, credentials and a retry time, keys of one kind do not stand with "
    "another, and the board has what it needs.",
)
_OF_KIND = {
    LinkKind.UART: ("tx", "rx", "baud"),
    LinkKind.USB: (),
    LinkKind.UDP: ("to", "credentials", "retry"),
}


def resolve_links(
    board: BoardSpec, model: BoardModel | None, index: Mapping[str, Requirement], report: Report
) -> tuple[BoardLink, ...]:
    """The links in the order of board.yaml; ``model`` is what is known about the board."""
    links = []
    taken: dict[str, tuple[str, Place]] = {}
    for name, spec in board.links.items():
        citation = cite_optional(spec.requirement, spec.at("requirement"), index, report)
        _check_shared(name, spec, taken, report)
        kind = LinkKind.UART if spec.uart is not None else LinkKind.USB if spec.usb else LinkKind.UDP
        problems = list(_link_problems(name, kind, spec))
        if model is not None:
            problems += _board_problems(kind, spec, model)
        elif kind is LinkKind.UART and board.board is None:
            problems.append(("uart", f"the UART of {name} is on no known board: say which, such as board: pico_2_w"))
        for key, message in problems:
            report.add(BAD_LINK, spec.at(key), message)
        retry = 0
        if spec.retry is not None:
            retry = read_time(spec.retry, unit_named("ms"), spec.at("retry"), report) or 0
        if not problems:
            links.append(BoardLink(name, kind, retry, spec, citation))
    return tuple(links)


def _check_shared(name: str, spec: LinkSpec, taken: dict[str, tuple[str, Place]], report: Report) -> None:
    """Whether a link takes a port that an earlier one takes already."""
    for key, what in (("uart", "UART {}"), ("usb", "the USB port")):
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
    if spec.to is not None and not re.fullmatch(r"\d{1,3}(\.\d{1,3}){3}", spec.to):
        yield "to", f"{spec.to} is not an address such as 255.255.255.255: to look up a name would block the vehicle"
    limits = {"udp": (1, 65535), "local_port": (0, 65535), "baud": (300, 3000000), "buffer": (280, 65536)}
    for key, (low, high) in limits.items():
        value = getattr(spec, key)
        if value is not None and not low <= value <= high:
            yield key, f"{key} of {name} is {value}, not {low} to {high}"


def _board_problems(kind: LinkKind, spec: LinkSpec, model: BoardModel) -> Iterator[tuple[str, str]]:
    """Yield what a link needs that the board lacks."""
    if kind is LinkKind.USB and not model.spec.usb:
        yield "usb", f"the {model.name} has no USB port of its own: its prompt is on a UART"
    if kind is LinkKind.UDP and not model.spec.wifi:
        yield "udp", f"the {model.name} has no Wi-Fi"
    if spec.uart is None:
        return
    uart = model.uarts.get(spec.uart)
    if uart is None:
        yield "uart", f"the {model.name} has {_numbers(model)} for links, and no UART {spec.uart}"
        return
    for key, pin, pins in (("tx", spec.tx, uart.tx & model.free), ("rx", spec.rx, uart.rx & model.free)):
        if pin is not None and pin not in pins:
            yield key, f"{key} of UART {spec.uart} is GPIO {shown_pins(pins)} on the {model.name}, not {pin}"


def _numbers(model: BoardModel) -> str:
    """``UART 0 and 1``."""
    return f"UART {shown_pins(frozenset(model.uarts))}" if model.uarts else "no UART"
