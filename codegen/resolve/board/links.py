"""The links of the board to ground stations."""

import keyword
import re
from collections.abc import Iterator, Mapping

from codegen.diagnostics import Report, Rule
from codegen.measure import read_time
from codegen.model.board_model import BoardModel, no_such_pin, shown_pins
from codegen.model.program import BoardLink, LinkKind
from codegen.model.spec.board import BoardSpec, LinkSpec
from codegen.model.spec.spec import Requirement
from codegen.model.units.unit import unit_named
from codegen.pattern import pattern
from codegen.resolve.citation import cite_optional
from codegen.source import Place

BAD_LINK = Rule(
    "bad-link",
    "A link cannot be built: its name is a lower-case identifier, a UART is one of the board's with tx, rx and baud, "
    "UDP has a port, an address to start with, credentials and a retry time, a TCP client these and a timeout, a TCP "
    "server a port that is its own, credentials, a retry time and a timeout, keys of one kind do not stand with "
    "another, and the board has what it needs. No two links have one port of the vehicle, and all over Wi-Fi have the "
    "same credentials: there is one radio. An address has four numbers from 0 to 255, and is one that something can "
    "be sent to.",
    remedy="write a link such as usb: true, or {uart: 0, tx: 0, rx: 1, baud: 57600}",
)
_OF_KIND = {
    LinkKind.UART: ("tx", "rx", "baud"),
    LinkKind.USB: (),
    LinkKind.UDP: ("to", "credentials", "retry"),
    LinkKind.TCP_SERVER: ("credentials", "retry", "timeout"),
    LinkKind.TCP_CLIENT: ("to", "credentials", "retry", "timeout"),
}
_ONLY_OF = {"backlog": LinkKind.TCP_SERVER}
_EXAMPLES = {
    "tx": "0",
    "rx": "1",
    "baud": "57600",
    "to": "192.168.4.2",
    "credentials": "wifi.json",
    "retry": "5 s",
    "timeout": "30 s",
}
_FIRST_MULTICAST, _LAST_MULTICAST = 224, 239
"""First numbers of addresses that are those of groups; what lies above is kept for nobody, but for everybody's."""
_EVERYBODY = "255.255.255.255"
_SHORTEST_TIMEOUT_MS = 2000
_LONGEST_RETRY_MS = 3_600_000

_Problem = tuple[str, str, str | None]
"""The key that is wrong, what is wrong with it, and a hint."""


def resolve_links(
    board: BoardSpec, model: BoardModel | None, index: Mapping[str, Requirement], report: Report
) -> tuple[BoardLink, ...]:
    """The links in the order of board.yaml; ``model`` is what is known about the board."""
    links = []
    taken: dict[str, tuple[str, Place]] = {}
    for name, spec in board.links.items():
        citation = cite_optional(spec.requirement, spec.at("requirement"), index, report)
        _check_shared(name, spec, taken, report)
        kind = _kind(spec)
        problems = list(_link_problems(name, kind, spec))
        if model is not None:
            problems += _board_problems(kind, spec, model)
        elif kind is LinkKind.UART and board.board is None:
            message = f"the UART of {name} is on no known board: say which, such as board: pico_2_w"
            problems.append(("uart", message, "board: pico_2_w"))
        retry, timeout = (_milliseconds(spec, key, report) for key in ("retry", "timeout"))
        problems += _time_problems(name, kind, retry, timeout)
        for key, message, hint in problems:
            report.add(BAD_LINK, spec.at(key), message, hint)
        if not problems and not any(_is_unread(key, spec) for key in _OF_KIND[kind]):
            links.append(BoardLink(name, kind, retry or 0, spec, citation, timeout or 0))
    return tuple(links)


def _kind(spec: LinkSpec) -> LinkKind:
    return next((kind for kind in LinkKind if kind.value in spec.places), LinkKind.UDP)


def _is_unread(key: str, spec: LinkSpec) -> bool:
    """Return whether a key is written with a value that could not be read, which has a finding of its own."""
    return getattr(spec, key) is None and key in spec.places


def _milliseconds(spec: LinkSpec, key: str, report: Report) -> int | None:
    written = getattr(spec, key)
    return None if written is None else read_time(written, unit_named("ms"), spec.at(key), report)


def _time_problems(name: str, kind: LinkKind, retry: int | None, timeout: int | None) -> Iterator[_Problem]:
    if timeout is not None and timeout < _SHORTEST_TIMEOUT_MS:
        message = f"timeout of {name} is {timeout} ms, not 2 s or more: ground stations send a HEARTBEAT once a second"
        yield "timeout", message, "timeout: 30 s"
    if kind is LinkKind.TCP_CLIENT and retry is not None and retry > _LONGEST_RETRY_MS:
        yield "retry", f"retry of {name} is more than an hour, and pauses get 16 times as long", "retry: 5 s"


def _check_shared(name: str, spec: LinkSpec, taken: dict[str, tuple[str, Place]], report: Report) -> None:
    """Report a link that takes a port which an earlier one takes already."""
    for key, what in (
        ("uart", "UART {}"),
        ("usb", "the USB port"),
        ("tcp_server", "TCP port {}"),
        ("local_port", "UDP port {} of the vehicle"),
    ):
        value = getattr(spec, key)
        if value is None or (key == "local_port" and value == 0):
            continue
        place = spec.at(key)
        owner, first = taken.setdefault(what.format(value), (name, place))
        if first != place:
            message = f"{key} of {name} is {what.format(value)}, which {owner} takes already"
            report.add(
                BAD_LINK,
                place,
                message,
                related=[(first, f"{owner} takes it here")],
                hint="take another one, or leave out one of the links",
            )
    if spec.credentials is not None:
        place = spec.at("credentials")
        owner, first = taken.setdefault("the Wi-Fi", (spec.credentials, place))
        if owner != spec.credentials:
            message = f"credentials of {name} are {spec.credentials}, and {owner} has those of the one Wi-Fi there is"
            hint = f"credentials: {owner}; under the name of a link it has what stands for that link alone"
            report.add(BAD_LINK, place, message, hint, [(first, "it is named here")])


def _link_problems(name: str, kind: LinkKind, spec: LinkSpec) -> Iterator[_Problem]:
    if not pattern(r"[a-z][a-z0-9_]*").fullmatch(name) or keyword.iskeyword(name):
        yield "", f"{name} cannot be the name of a link", "use lower-case letters, digits and _, and no word of Python"
    needed = _OF_KIND[kind]
    for key in needed:
        if getattr(spec, key) is None and not _is_unread(key, spec):
            example = f"{key}: {_EXAMPLES[key]}"
            yield "", f"{name} is a link over {kind.words} and needs {key}", example
    for key in dict.fromkeys((*(key for keys in _OF_KIND.values() for key in keys), *_ONLY_OF)):
        if getattr(spec, key) is not None and key not in needed and _ONLY_OF.get(key) is not kind:
            yield key, f"{key} says nothing about a link over {kind.words}", f"leave {key} out"
    if spec.to is not None:
        yield from _address_problems(kind, spec.to)
    limits = {
        **dict.fromkeys(("udp", "tcp_server", "tcp_client"), (1, 65535)),
        "local_port": (0, 65535),
        "backlog": (1, 16),
        "baud": (300, 3000000),
        "buffer": (280, 65536),
    }
    for key, (low, high) in limits.items():
        value = getattr(spec, key)
        if value is not None and not low <= value <= high:
            yield key, f"{key} of {name} is {value}, not {low} to {high}", f"{key}: {min(max(value, low), high)}"


def _address_problems(kind: LinkKind, written: str) -> Iterator[_Problem]:
    """Yield why nothing can be sent to an address."""
    usual = "to: 192.168.4.2, or 255.255.255.255 for whoever listens"
    if not pattern(r"\d{1,3}(\.\d{1,3}){3}", re.ASCII).fullmatch(written):
        message = f"{written} is not an address such as 255.255.255.255: to look up a name would block the vehicle"
        yield "to", message, usual
        return
    parts = written.split(".")
    plain = ".".join(str(int(part)) for part in parts)
    if any(int(part) > 255 for part in parts):
        large = next(part for part in parts if int(part) > 255)
        yield "to", f"{written} is no address: {large} is more than 255", usual
    elif plain != written:
        message = f"{written} is read as another address where a number with 0 in front is octal"
        yield "to", message, f"to: {plain}"
    elif int(parts[0]) == 0 or (int(parts[0]) > _LAST_MULTICAST and written != _EVERYBODY):
        yield "to", f"{written} is the address of no station: nothing that is sent there arrives", usual
    elif kind is LinkKind.TCP_CLIENT and (int(parts[0]) >= _FIRST_MULTICAST or written.endswith(".255")):
        what = "broadcast" if written.endswith(".255") else "group"
        yield "to", f"{written} is a {what}, and a TCP connection goes to one station", "to: 192.168.4.2"


def _board_problems(kind: LinkKind, spec: LinkSpec, model: BoardModel) -> Iterator[_Problem]:
    """Yield what a link needs that the board lacks."""
    if kind is LinkKind.USB and not model.spec.usb:
        yield (
            "usb",
            f"the {model.name} has no USB port of its own: its prompt is on a UART",
            "take a UART, or a board with USB, such as board: pico_2_w",
        )
    if kind.is_wireless and not model.spec.wifi:
        hint = "a board with Wi-Fi, such as board: pico_2_w, or a link with uart or usb"
        yield kind.value, f"the {model.name} has no Wi-Fi", hint
    if spec.uart is None:
        return
    uart = model.uarts.get(spec.uart)
    if uart is None:
        yield (
            "uart",
            f"the {model.name} has {_numbers(model)} for links, and no UART {spec.uart}",
            f"uart: {min(model.uarts)}" if model.uarts else "take a board with a UART, or another kind of link",
        )
        return
    for key, pin, pins in (("tx", spec.tx, uart.tx), ("rx", spec.rx, uart.rx)):
        if pin is not None and pin not in pins & model.free:
            yield key, *no_such_pin(f"{key} of UART {spec.uart}", pin, pins, model, key)


def _numbers(model: BoardModel) -> str:
    """``UART 0 and 1``."""
    return f"UART {shown_pins(frozenset(model.uarts))}" if model.uarts else "no UART"
