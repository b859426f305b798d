"""Resolves the access to commands: ``access`` of vehicle.yaml."""

from collections.abc import Iterator, Mapping

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.access import Access
from codegen.model.dialect.dialect import Dialect
from codegen.model.spec.access import SETUP_SIGNING, AccessSpec, Admission
from codegen.model.spec.program import VehicleSpec
from codegen.model.spec.spec import Requirement, Spec
from codegen.resolve.citation import cite_aspects, cite_optional

BAD_ACCESS = Rule(
    "bad-access",
    "access of vehicle.yaml says for each link of the board, and for no other, whether it is open, signed or listed. "
    "Signatures need MAVLink 2, listed links the stations that count, and a new key comes over an open cable only: "
    "who hears it on a radio or a network has it.",
    remedy="write open, signed or listed for each link of board.yaml, and for no other",
)

_Problem = tuple[str, str, str | None]


def resolve_access(
    spec: Spec, vehicle: VehicleSpec, dialect: Dialect, index: Mapping[str, Requirement], report: Report
) -> Access | None:
    """The access; None, where it is not stated, or with findings where it cannot be."""
    access = vehicle.access
    if access is None:
        return None
    problems = [*_link_problems(access, spec), *_key_problems(access, spec, dialect)]
    for key, message, hint in problems:
        report.add(BAD_ACCESS, access.at(key), message, hint)
    if problems:
        return None
    names = list(spec.board.links)
    return Access(
        citation=cite_optional(access.requirement, access.at("requirement"), index, report),
        aspects=cite_aspects(access, index, report),
        signed={name: number for number, name in enumerate(names) if access.links[name] is Admission.SIGNED},
        listed=tuple(name for name in names if access.links[name] is Admission.LISTED),
        spec=access,
    )


def _link_problems(access: AccessSpec, spec: Spec) -> Iterator[_Problem]:
    links = spec.board.links
    for name, admission in access.links.items():
        if name not in links:
            yield f"links.{name}", f"the board has no link {name}", did_you_mean(name, links)
        elif admission is Admission.SIGNED and spec.project.protocol == 1:
            yield (
                f"links.{name}",
                f"{name} cannot be signed: MAVLink 1 has no signatures",
                "protocol: 2",
            )
    for name in links:
        if name not in access.links:
            hint = f"{name}: open, signed or listed"
            yield "links", f"nothing says who may command the vehicle over {name}", hint
    is_listed = Admission.LISTED in access.links.values()
    if is_listed and not access.stations:
        yield "links", "a link is listed, and no station is", "stations: [255], with the system ids of those that count"
    if access.stations and not is_listed:
        yield "stations", "stations are listed, and no link asks for them", "links: {wifi: listed}"
    yield from _station_problems(access)


def _station_problems(access: AccessSpec) -> Iterator[_Problem]:
    for index, number in enumerate(access.stations):
        if number in access.stations[:index]:
            yield f"stations[{index}]", f"{number} is listed twice", "leave out the second one"
        elif not 1 <= number <= 255:
            yield "stations", f"{number} is not a system id from 1 to 255", "stations: [255]"


def _key_problems(access: AccessSpec, spec: Spec, dialect: Dialect) -> Iterator[_Problem]:
    if access.setup and Admission.SIGNED not in access.links.values():
        yield "setup", "no link is signed, so there is no use for a key", "leave setup out, or write signed for a link"
    for index, name in enumerate(access.setup):
        if name in access.setup[:index]:
            yield f"setup[{index}]", f"{name} is listed twice", "leave out the second one"
            continue
        link = spec.board.links.get(name)
        if link is None:
            yield "setup", f"the board has no link {name}", did_you_mean(name, spec.board.links)
        elif link.is_wireless:
            yield (
                "setup",
                f"a key that comes over {name} is known to all that hear its network",
                "name a link over a cable: usb, or a UART",
            )
        elif access.links.get(name) is not Admission.OPEN:
            yield "setup", f"{name} is not open: whoever has no key yet could not bring one", f"links: {{{name}: open}}"
    if access.setup and SETUP_SIGNING not in dialect.messages:
        yield (
            "setup",
            f"{dialect.name} has no message {SETUP_SIGNING}",
            "leave setup out, or take a dialect that includes common.xml",
        )
