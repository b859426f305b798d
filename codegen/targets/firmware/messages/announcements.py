"""View of what streams.py announces: what is sent at once, on connection or because a quantity has changed."""

from collections.abc import Mapping

from codegen.frozen import dataclass
from codegen.model.system import PopulatedMessage, System
from codegen.targets.firmware.messages.sending import SentView, WayView, ways, word
from codegen.targets.firmware.words import Layout

_LINE = 105
"""Characters that a condition may have."""


@dataclass(frozen=True, slots=True)
class WatchView:
    """A quantity whose change announces messages, with their places; ``place`` is where its last value is kept.

    Of several instances ``place`` and ``instance`` are expressions of the loop over them, to which ``indent`` belongs.
    """

    path: str
    instances: int
    expression: str
    indent: str
    place: str
    instance: str
    messages: tuple[tuple[int, str], ...]
    citation: str


@dataclass(frozen=True, slots=True)
class AnnouncementView:
    """The messages sent at once: literals of frames, (message, what sends it, instance, page), and ways to send one.

    The first ``on_connection`` of the frames are for who appears on the link. ``unchanged`` says whether everything
    that is watched is as it was when it was ``seen``; empty where that is more than a line. ``withholds``: one of them
    may be withheld, and goes out as soon as it is known.
    """

    frames: tuple[str, ...]
    on_connection: int
    ways: tuple[WayView, ...]
    watches: tuple[WatchView, ...]
    seen: tuple[str, ...]
    withholds: bool

    @property
    def looks(self) -> bool:
        """Return whether there is something to look for all the time: a change, or that it is known by now."""
        return bool(self.watches) or self.withholds

    @property
    def unchanged(self) -> str:
        """The expression in which every instance is compared."""
        compared = " and ".join(f"{read} == seen[{place}]" for place, read in enumerate(self.seen))
        return compared if len(compared) <= _LINE else ""


def announcements(messages: tuple[SentView, ...], system: System, layout: Layout) -> AnnouncementView | None:
    """The view of all that is announced; None where nothing is. ``messages`` are those of the streams."""
    populated = {message.name: message for message in system.messages}
    announced = [(place, view) for place, view in enumerate(messages) if populated[view.name].is_announced]
    if not announced:
        return None
    announced.sort(key=lambda found: not populated[found[1].name].on_connection)
    frames = [
        (populated[view.name].on_connection, f"({place}, _announce{view.way.suffix}, {instance}, {page})")
        for place, view in announced
        for instance in range(view.instances)
        for page in range(view.pages)
    ]
    watches, seen = _watches(announced, populated, system, layout)
    return AnnouncementView(
        frames=tuple(text for _, text in frames),
        on_connection=sum(is_first for is_first, _ in frames),
        ways=ways(view for _, view in announced),
        watches=watches,
        seen=seen,
        withholds=any(populated[view.name].withheld_for for _, view in announced),
    )


def _watches(
    announced: list[tuple[int, SentView]], populated: Mapping[str, PopulatedMessage], system: System, layout: Layout
) -> tuple[tuple[WatchView, ...], tuple[str, ...]]:
    """The watched quantities, and what each of their instances is at the start."""
    watches: list[WatchView] = []
    seen: list[str] = []
    changes = {
        quantity.path: quantity for _, view in announced if (quantity := populated[view.name].on_change) is not None
    }
    for path, quantity in changes.items():
        component = system.components[quantity.component]
        several, first = component.instances > 1, len(seen)
        messages = [(place, view.name) for place, view in announced if populated[view.name].on_change is quantity]
        watches.append(
            WatchView(
                path=path,
                instances=component.instances,
                expression=word(component, quantity, layout),
                indent="    " if several else "",
                place=f"{f'{first} + ' if first else ''}instance" if several else str(first),
                instance="instance" if several else "0",
                messages=tuple(messages),
                citation=str(populated[messages[0][1]].citation),
            )
        )
        read = word(component, quantity, layout)
        seen += [read.replace("[instance]", f"[{instance}]") for instance in range(component.instances)]
    return tuple(watches), tuple(seen)
