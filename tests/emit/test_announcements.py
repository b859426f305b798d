"""What streams.py announces: first what is for a new connection, then what goes out because something has changed."""

from types import SimpleNamespace
from typing import Any

from codegen.targets.firmware.messages.announcements import announcements
from codegen.targets.firmware.messages.sending import WayView

ONCE, EACH = WayView("", "", "", False, False), WayView("_each", "", "", True, True)


def quantity(component: str, name: str) -> Any:
    return SimpleNamespace(component=component, attribute=name, path=f"{component}.{name}")


SERIAL, STATE = quantity("pack", "serial"), quantity("boat", "state")
COMPONENTS = {
    "pack": SimpleNamespace(name="pack", instances=2),
    "boat": SimpleNamespace(name="boat", instances=1),
}
LAYOUT: Any = SimpleNamespace(
    blocks={
        "pack": SimpleNamespace(constant=lambda word: f"_PACK_{word.upper()}"),
        "boat": SimpleNamespace(constant=lambda word: f"_BOAT_{word.upper()}"),
    }
)


def announced(*messages: tuple[str, WayView, int, int, bool, Any]) -> Any:
    """The view of messages: name, way, instances, pages, whether a connection gets them, and what they watch."""
    sent = [
        SimpleNamespace(name=name, way=way, instances=instances, pages=pages)
        for name, way, instances, pages, _, _ in messages
    ]
    populated = [
        SimpleNamespace(
            name=name,
            withheld_for=(),
            is_announced=on_connection or watched is not None,
            on_connection=on_connection,
            on_change=watched,
            citation=f"FR-{name}",
        )
        for name, _, _, _, on_connection, watched in messages
    ]
    system: Any = SimpleNamespace(messages=populated, components=COMPONENTS)
    return announcements(tuple(sent), system, LAYOUT)  # type: ignore[arg-type]


def test_what_is_only_streamed_is_not_announced() -> None:
    assert announced(("A", ONCE, 1, 1, False, None)) is None


def test_frames_for_a_connection_come_first() -> None:
    """Each instance and page is a frame; the places are those of all messages, in the order in which they are sent."""
    view = announced(
        ("A", ONCE, 1, 1, False, None),
        ("B", ONCE, 1, 1, False, STATE),
        ("C", EACH, 2, 2, True, SERIAL),
        ("D", ONCE, 1, 1, True, None),
    )
    assert view.frames == (
        "(2, _announce_each, 0, 0)",
        "(2, _announce_each, 0, 1)",
        "(2, _announce_each, 1, 0)",
        "(2, _announce_each, 1, 1)",
        "(3, _announce, 0, 0)",
        "(1, _announce, 0, 0)",
    )
    assert view.on_connection == 5
    assert view.ways == (EACH, ONCE)


def test_what_is_watched_is_seen_once_for_each_instance() -> None:
    """Of several messages that watch the same quantity, too; what a later one is seen at lies behind the others."""
    view = announced(
        ("B", ONCE, 1, 1, False, STATE),
        ("C", EACH, 2, 1, False, SERIAL),
        ("D", ONCE, 1, 1, False, SERIAL),
    )
    state, serial = view.watches
    assert (state.path, state.instances, state.indent, state.place, state.instance) == ("boat.state", 1, "", "0", "0")
    assert (state.expression, state.messages, state.citation) == ("state.words[_BOAT_STATE]", ((0, "B"),), "FR-B")
    assert (serial.instances, serial.indent, serial.place, serial.instance) == (2, "    ", "1 + instance", "instance")
    assert (serial.messages, serial.citation) == (((1, "C"), (2, "D")), "FR-C")
    assert view.seen == (
        "state.words[_BOAT_STATE]",
        "state.words[_PACK_SERIAL[0]]",
        "state.words[_PACK_SERIAL[1]]",
    )
    compared = [f"{read} == seen[{place}]" for place, read in enumerate(view.seen)]
    assert len(" and ".join(compared)) > 105
    assert view.unchanged == ""  # it is more than a line
    assert announced(("C", EACH, 2, 1, False, SERIAL)).watches[0].place == "instance"
    assert announced(("B", ONCE, 1, 1, False, STATE)).unchanged == compared[0]
