"""Views of how a message is sent: about which instances and pages, and what is asked of the state before."""

import math
from collections.abc import Iterable

from codegen.frozen import dataclass
from codegen.model.price import HEAD_V1, HEAD_V2, frame_size
from codegen.model.system import PopulatedMessage, System
from codegen.model.vehicle import SLOWEST_ASKED, Component, Quantity
from codegen.targets.firmware.words import Layout, word_layout
from codegen.targets.naming import builder_name, frame_name, message_about


@dataclass(frozen=True, slots=True)
class SentView:
    """A message; each of its instances is sent, where ``enabled`` (an expression of the state) is true.

    ``way`` is what sends all instances and pages of what ``encoder`` makes, or one. ``never`` is for the generation
    that was not chosen for good. ``is_alone``: no other table is of the same message, so that frames with its id are
    its own. ``tells`` is called to know whether it is not withheld, None where it never is: what builds it, or a
    function that has to be made, whose statements are ``telling``. ``number_at`` is where its payload has its instance.
    """

    id: int
    name: str
    encoder: str
    way: "WayView"
    instances: int
    pages: int
    shortest_us: int
    component: str | None
    never: bool
    is_alone: bool
    tells: str | None
    telling: str
    enabled: str | None
    number_at: int | None


@dataclass(frozen=True, slots=True)
class WayView:
    """A way of sending that messages share: ``sending`` are the statements that send all instances and pages.

    ``announcing`` are those for one, which return whether it is withheld where it may be. ``suffix`` is what the names
    of both functions end in, ``instances`` and ``pages`` say whether the second one takes them.
    """

    suffix: str
    sending: str
    announcing: str
    instances: bool
    pages: bool


def sent_view(message: PopulatedMessage, system: System, *, never: bool) -> SentView:
    """The view of a message; ``never`` as it has it."""
    component = message.component
    enabled, is_measured = None, []
    if component is not None and component.enabled is not None:
        of_each = "[instance]" if component.instances > 1 else ""
        enabled = f"state.{component.name}{of_each}.{component.enabled.name}"
        is_measured = [f"if {word(component, component.enabled, word_layout(system))}:"]
    counts = {"instance": message.instances, "page": message.pages}
    arguments = ["state", *(name if counts[name] > 1 else "0" for name in message_about(message))]
    return SentView(
        id=message.wire.id,
        name=message.name,
        encoder=frame_name(message),
        way=_way(message, arguments, is_measured),
        instances=message.instances,
        pages=message.pages,
        shortest_us=shortest_us(message, system),
        component=component.name if component else None,
        never=never,
        is_alone=len(system.tables(message.wire.name)) == 1,
        tells=_tells(message),
        telling=_telling(message) if message.withheld_for and message_about(message) else "",
        enabled=enabled,
        number_at=number_at(message),
    )


def number_at(message: PopulatedMessage) -> int | None:
    """Return where the payload has the number of the instance that it is about, in
    its lowest byte; None where it has none.
    """
    places = (each.covers.offset for each in message.answers if each.is_instance_number)
    return next(places, None)


def _way(message: PopulatedMessage, arguments: list[str], is_measured: list[str]) -> WayView:
    """Return how a message is sent; what it is called follows from all that it depends on."""
    component = message.component
    made = f"encode({', '.join(['link', *arguments])})"
    send = [f"link.send_frame({made})"]
    if message.withheld_for:
        send = [f"frame = {made}", "if frame is not None:  # it may be withheld", "    link.send_frame(frame)"]
    each = [
        *([f"for instance in range({message.instances}):"] if message.instances > 1 else []),
        *(f"{condition}  # what is not measured is not reported" for condition in is_measured),
        *([f"for page in range({message.pages}):"] if message.pages > 1 else []),
    ]
    about = f"_{component.name}" if component else ""
    page = f"_{message.pages}_pages" if message.pages > 1 else "_page" if message.population.pages else ""
    return WayView(
        suffix=f"{about}{page}{'_while_known' if message.withheld_for else ''}",
        sending=_nested(each, send),
        announcing=_nested(is_measured, [*send, "return frame is None"] if message.withheld_for else send),
        instances=message.instances > 1,
        pages=message.pages > 1,
    )


def ways(messages: Iterable[SentView]) -> tuple[WayView, ...]:
    """The ways of messages, each once, in their order."""
    return tuple(dict.fromkeys(message.way for message in messages))


def _place(component: Component, quantity: Quantity, layout: Layout) -> str:
    """The constant with the places of a quantity's words: a tuple by instance, or the only one's number."""
    return layout.blocks[component.name].constant(quantity.attribute)


def word(component: Component, quantity: Quantity, layout: Layout) -> str:
    """Return what the state keeps of a quantity, of several instances that of ``instance``."""
    place = _place(component, quantity, layout)
    return f"state.words[{place}[instance]]" if component.instances > 1 else f"state.words[{place}]"


def read_places(messages: Iterable[PopulatedMessage], layout: Layout) -> tuple[str, ...]:
    """The constants with the places of the words that are read: whether an instance is measured, what is watched."""
    lines: dict[str, str] = {}
    for message in messages:
        owner = layout.blocks[message.component.name].component if message.component else None
        watched = message.on_change
        read = [(owner, owner.enabled)] if owner and owner.enabled else []
        if watched is not None:
            read.append((layout.blocks[watched.component].component, watched))
        for component, quantity in read:
            found = layout.places(component.name, quantity.attribute)
            name = _place(component, quantity, layout)
            lines[name] = f"{name} = {found if len(found) > 1 else found[0]}"
    return tuple(lines.values())


def shortest_us(message: PopulatedMessage, system: System) -> int:
    """The shortest interval that a ground station can ask for, in microseconds: never faster than ``fastest``.

    -1 stands for the rate of its stream, which is the fastest and slower than each interval that can be asked for; 0
    for no limit.
    """
    fastest = message.stream.fastest if message.stream else system.program.fastest if system.program else None
    if fastest is None:
        return 0
    return math.ceil(1000000 / fastest) if fastest >= SLOWEST_ASKED else -1


def _tells(message: PopulatedMessage) -> str | None:
    """Return what is called with the state to know whether anything of a message
    would go out, None where it always does.
    """
    if not message.withheld_for:
        return None
    return f"_tells_{message.name.lower()}" if message_about(message) else f"telemetry.{builder_name(message)}"


def _telling(message: PopulatedMessage) -> str:
    """The body of a function that returns whether anything of a message would go out."""
    about = "".join(", instance" if name == "instance" else ", 0" for name in message_about(message))
    built = f"telemetry.{builder_name(message)}(state{about}) is not None"
    if message.instances == 1:
        return _nested([], [f"return {built}".replace("instance", "0")])
    looked = _nested([f"for instance in range({message.instances}):", f"if {built}:"], ["return True"])
    return f"{looked}\n    return False"


def _nested(heads: list[str], body: list[str]) -> str:
    """The body of a function in which each head is the body of the one before it."""
    lines = [f"{'    ' * depth}{head}" for depth, head in enumerate(heads, 1)]
    return "\n".join([*lines, *(f"{'    ' * (len(heads) + 1)}{line}" for line in body)])


def payload_lengths(system: System) -> tuple[tuple[int, int], ...]:
    """The lengths of the payloads that go out, as ranges: those of tables as far as zeros at their ends tell.

    Services fill messages as they are asked: all that is as long as one of these, or shorter.
    """
    head = HEAD_V1 if system.spec.project.protocol == 1 else HEAD_V2
    tables = {message.wire.name for message in system.messages}
    longest = max((wire.length for wire in system.sent if wire.name not in tables), default=0)
    lengths = set(range(longest + 1))
    for message in system.messages:
        for instance in range(message.instances):
            size = frame_size(message, instance, system.spec.project.protocol)
            lengths.update(range(int(size.low) - head, int(size.high) - head + 1))
    starts = sorted(length for length in lengths if length - 1 not in lengths)
    ends = sorted(length for length in lengths if length + 1 not in lengths)
    return tuple(zip(starts, ends, strict=True))
