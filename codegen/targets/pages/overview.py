"""The first page: what the vehicle sends, over which links, what can be set, and which criteria the pages name."""

from collections.abc import Iterable, Iterator

from codegen.frozen import dataclass
from codegen.model.price import frame_size, message_price, sent_messages
from codegen.model.system import PopulatedMessage, System
from codegen.summaries.generations import sent_at_once
from codegen.targets.documents.files import ParameterRow, parameter_row
from codegen.targets.documents.program import LinkRow, StreamRow, link_rows, stream_rows
from codegen.targets.origin import Origin, source_name
from codegen.targets.pages.budget import whole_at_default
from codegen.targets.pages.message import rate_text
from codegen.targets.pages.navigation import TRACE_PAGE, Link, Navigation, message_path, navigation, shared_docs


@dataclass(frozen=True, slots=True)
class MessageRow:
    """A message: where its page is, how often it is sent and what it costs by default."""

    name: str
    href: str
    id: int
    rate: str
    at_once: str
    frame: str
    bytes_per_s: str
    instances: str
    criterion: str
    is_sent: bool


@dataclass(frozen=True, slots=True)
class CriterionRow:
    """A criterion, or a requirement as a whole: its text, where it stands, and the rows of tables that cite it.

    ``traced`` leads to where the page of requirements has a criterion.
    """

    id: str
    traced: str
    text: str
    place: str
    answers: tuple[Link, ...]


@dataclass(frozen=True, slots=True)
class OverviewPage:
    """The page, ready to print. ``programs`` leads to the same page of other programs."""

    project: str
    origin: Origin
    navigation: Navigation
    board: str
    facts: tuple[tuple[str, str], ...]
    programs: tuple[Link, ...]
    messages: tuple[MessageRow, ...]
    has_idle: bool
    services: tuple[str, ...]
    streams: tuple[StreamRow, ...]
    links: tuple[LinkRow, ...]
    parameters: tuple[ParameterRow, ...]
    criteria: tuple[CriterionRow, ...]


def overview_page(system: System, origin: Origin, cited: Iterable[str]) -> OverviewPage:
    """The page of a program; ``cited`` are the criteria that the pages of its messages name."""
    sent = {message.name for message in sent_messages(system)}
    parameters = tuple(parameter_row(parameter, system) for parameter in system.parameters.values())
    streams, links = stream_rows(system), link_rows(system)
    asked = [row.criterion for rows in (parameters, streams, links) for row in rows]
    named = {*cited, *asked, *(str(message.citation) for message in system.messages)} - {""}
    return OverviewPage(
        project=system.spec.project.project,
        origin=origin,
        navigation=navigation(system, "index.html"),
        board=system.board_name,
        facts=(
            ("Dialect", system.dialect.name),
            ("Protocol", f"MAVLink {system.spec.project.protocol}"),
            ("System and component", f"{system.system_id} / {system.component_id}"),
            ("Messages", str(len(system.messages))),
            ("By default", f"{whole_at_default(system)} bytes/s"),
            ("Links", ", ".join(link.name for link in system.links) or "none"),
        ),
        programs=_programs(system),
        messages=tuple(_message(message, system, is_sent=message.name in sent) for message in system.messages),
        has_idle=len(sent) < len(system.messages),
        services=tuple(wire.name for wire in system.sent if not system.tables(wire.name)),
        streams=streams,
        links=links,
        parameters=parameters,
        criteria=tuple(_criterion(name, system) for name in sorted(named, key=_order)),
    )


def _programs(system: System) -> tuple[Link, ...]:
    if system.spec.program:
        return (Link(f"{shared_docs(system)}index.html", "the project that this program belongs to"),)
    return tuple(Link(f"../{name}/docs/index.html", name) for name in system.spec.project.programs)


def _message(message: PopulatedMessage, system: System, *, is_sent: bool) -> MessageRow:
    price = message_price(message, system)
    sizes = (frame_size(message, instance, system.spec.project.protocol) for instance in range(message.instances))
    on = f", {sum(price.is_on)} of {message.instances} on" if message.instances > 1 else ""
    return MessageRow(
        name=message.name,
        href=message_path(message.name),
        id=message.wire.id,
        rate=rate_text(message),
        at_once=sent_at_once(message),
        frame=" / ".join(dict.fromkeys(map(str, sizes))),
        bytes_per_s=str(price.whole) if message.stream else "",
        instances=f"{message.component.name}{on}" if message.component else "",
        criterion=str(message.citation),
        is_sent=is_sent,
    )


def _criterion(name: str, system: System) -> CriterionRow:
    identity, _, number = name.partition(".")
    requirement = system.requirements[identity]
    criterion = next((each for each in requirement.criteria if str(each.number) == number), None)
    place = (criterion or requirement).place
    return CriterionRow(
        id=name,
        traced=f"{shared_docs(system)}{TRACE_PAGE}#{name}" if criterion else "",
        text=criterion.text if criterion else requirement.title,
        place=f"{source_name(system, place.file)}:{place.line}",
        answers=tuple(_answers(name, system)),
    )


def _answers(name: str, system: System) -> Iterator[Link]:
    """The fields, parameters, streams and links that cite a criterion."""
    for message in system.messages:
        for index, answer in enumerate(message.answers, 1):
            if str(answer.covers.citation) == name:
                label = f"{message.name}.{answer.covers.label}"
                yield Link(f"{message_path(message.name)}#field-{index}", label)
    for parameter in system.parameters.values():
        if str(parameter.citation) == name:
            yield Link(f"#{parameter.name}", parameter.name)
    for stream in system.streams.values():
        if str(stream.citation) == name:
            yield Link("#streams", f"stream {stream.name}")
    for link in system.links:
        if str(link.citation) == name:
            yield Link("#links", f"link {link.name}")


def _order(name: str) -> tuple[str, int]:
    identity, _, number = name.partition(".")
    return identity, int(number or 0)
