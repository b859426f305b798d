"""View of the receiver's module: a function for each message, the facts and quantities, and who carries them."""

import keyword
import math
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.code.reading import Reading
from codegen.model.receiver import Receiver
from codegen.model.spec.receiver import RolesSpec
from codegen.model.system import PopulatedMessage, System
from codegen.model.units.unit import Unit, ratio, unit_named
from codegen.model.vehicle import Component
from codegen.targets.naming import class_name, class_names, prose, quoted
from codegen.targets.receiver.readings import CHARGING, FACT, readings_of
from codegen.targets.receiver.roles import UNITS, role_of

TAKEN = frozenset(
    (
        *(
            "system",
            "number",
            "swaps",
            "components",
            "flags",
            "messages",
            "info",
            "age_ms",
            "is_stale",
            "is_contested",
            "contest",
            CHARGING,
        ),
        *("mean_current_a", "charge_left_ah", "time_left_s", "take", "keep_time"),
    )
)
"""Attributes of every view, which a quantity cannot have for its name."""
MODULES = frozenset(
    (
        "checksum",
        "consumption",
        "contest",
        "enum_names",
        "fields",
        "live_fields",
        "frames",
        "mavlink",
        "message",
        "messages",
        "nearest",
        "readings",
        "receiver",
        "sender",
    )
) | {"view", "views", "frames_plain", "frames_viper"}
"""Modules of every receiver, which the one with the views cannot have for its name."""
WIDTH = 112
"""Columns of a line without its indentation."""
MISSED = 3
"""Messages in a row that may be lost before what they say counts no more."""


@dataclass(frozen=True, slots=True)
class ReaderView:
    """One message: its class, the field with the number of the instance, and the readings.

    ``reads`` are the methods of the message that the readings ask.
    """

    name: str
    id: int
    class_name: str
    function: str
    number_field: str
    stale_ms: int
    readings: tuple[Reading, ...]
    lines: tuple[str, ...]
    reads: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class AttributeView:
    """An attribute of a view or of its facts: ``key`` is its name among the readings."""

    name: str
    key: str
    doc: str
    enum: str
    method: str


@dataclass(frozen=True, slots=True)
class RoleView:
    """The players of a role: pairs of a reading's name and the factor to the unit of the role, as a tuple in Python."""

    name: str
    players: str


@dataclass(frozen=True, slots=True)
class ReceiverView:
    """The module, and the page about it."""

    project: str
    component: str
    doc: str
    citation: str
    module: str
    views_class: str
    view_class: str
    info_class: str
    stale_ms: int
    window_ms: int
    readers: tuple[ReaderView, ...]
    quantities: tuple[AttributeView, ...]
    facts: tuple[AttributeView, ...]
    carriers: tuple[tuple[str, str], ...]
    flags: str
    roles: tuple[RoleView, ...]
    is_counted_anew: bool
    names: str
    stale_by_kind: str
    functions: tuple[str, ...]
    example: str
    enums: tuple[str, ...]


def plural(name: str) -> str:
    """boat -> boats, battery -> batteries."""
    if name.endswith("y") and name[-2:-1] not in "aeiou":
        return f"{name[:-1]}ies"
    return f"{name}es" if name.endswith(("s", "x", "ch", "sh")) else f"{name}s"


def receiver_view(system: System, receiver: Receiver) -> ReceiverView:
    """The view of the module and of its page."""
    component = receiver.component
    spoken = receiver.spec.roles or RolesSpec(place=receiver.spec.place)
    said = {message.wire.name: readings_of(message, component, spoken, system.dialect) for message in receiver.messages}
    classes = class_names(message.wire.name for message in receiver.messages)
    readings = [reading for found in said.values() for reading in found]
    ranked = _ranked(system, receiver, said)
    uses: set[str] = {name for reading in readings for name in reading.uses}
    if any(reading.enum for reading in readings):
        uses.add("entry")
    enums = {*(uses & system.dialect.enums.keys()), *(reading.enum for reading in readings if reading.enum)}
    module = plural(component.name)
    owner = class_name(component.name)
    return ReceiverView(
        project=prose(system.spec.project.project),
        component=component.name,
        doc=prose(component.spec.doc),
        citation=str(receiver.citation or ""),
        module=f"{module}_" if module in MODULES else module,
        views_class=class_name(module),
        view_class=f"{owner}View",
        info_class=f"{owner}Info",
        stale_ms=receiver.stale_after_ms,
        window_ms=receiver.rate_over_ms,
        readers=tuple(
            ReaderView(
                name=message.wire.name,
                id=message.wire.id,
                class_name=classes[message.wire.name],
                function=f"_read_{message.wire.name.lower()}",
                number_field=_number_field(message),
                stale_ms=stale_after_ms(message, receiver),
                readings=said[message.wire.name],
                lines=tuple(line for reading in said[message.wire.name] for line in _lines(reading)),
                reads=tuple(
                    name
                    for name in ("get", "raw")
                    if any(f"{name}(" in reading.expression for reading in said[message.wire.name])
                ),
            )
            for message in receiver.messages
        ),
        quantities=_attributes(ranked, TAKEN, is_fact=False),
        facts=_attributes(ranked, frozenset(), is_fact=True),
        carriers=_carriers(receiver, ranked),
        flags=_tuple(sorted({quoted(reading.name) for reading in readings if "flags" in reading.uses})),
        roles=_roles(readings, spoken),
        is_counted_anew=spoken.counted_anew,
        names=_tuple(quoted(message.wire.name) for message in receiver.messages),
        stale_by_kind=_tuple(str(stale_after_ms(message, receiver)) for message in receiver.messages),
        functions=tuple(sorted(uses - enums)),
        example=_example(component, readings),
        enums=tuple(sorted(enums)),
    )


def _lines(reading: Reading) -> Iterator[str]:
    """The entry of a reading; what gets too long has each argument in a line of its own."""
    comment = f"  # {reading.unit}" if reading.unit else ""
    line = f"{quoted(reading.name)}: {reading.expression},{comment}"
    if len(line) <= WIDTH:
        yield line
        return
    function, _, rest = reading.expression.partition("(")
    yield f"{quoted(reading.name)}: {function}("
    yield from (f"    {argument}," for argument in _arguments(rest.removesuffix(")")))
    yield f"),{comment}"


def _arguments(text: str) -> Iterator[str]:
    """The arguments of a call, at the commas that stand in no brackets."""
    depth, begin = 0, 0
    for index, character in enumerate(text):
        depth += (character == "(") - (character == ")")
        if character == "," and depth == 0:
            yield text[begin:index].strip()
            begin = index + 1
    yield text[begin:].strip()


def _example(component: Component, readings: Iterable[Reading]) -> str:
    """Return some quantities of the component that have a unit, as the page prints them."""
    names = [reading.name for reading in readings if reading.name in component.quantities and reading.unit]
    read = {name for name, quantity in component.quantities.items() if quantity.derivation.conversion}
    shown = sorted(set(names) - TAKEN, key=lambda name: (name not in read, name))
    return "".join(f"view.{name}, " for name in shown[:2])


def _number_field(message: PopulatedMessage) -> str:
    return next(answer.covers.field.name for answer in message.answers if answer.is_instance_number)


def stale_after_ms(message: PopulatedMessage, receiver: Receiver) -> int:
    """Age from which on a message counts no more: a slow one has longer."""
    rate = message.stream.default_rate if message.stream else 0
    return max(receiver.stale_after_ms, math.ceil(MISSED * 1000 / rate)) if rate else receiver.stale_after_ms


def _ranked(
    system: System, receiver: Receiver, said: Mapping[str, tuple[Reading, ...]]
) -> dict[str, dict[str, Reading]]:
    """Return by name, in order, and by message, the preferred one first, the reading under that name."""
    found: dict[str, dict[str, Reading]] = {}
    for message in sorted(receiver.messages, key=lambda message: _preference(message, system)):
        for reading in said[message.wire.name]:
            found.setdefault(reading.name, {})[message.wire.name] = reading
    return dict(sorted(found.items()))


def _attributes(
    ranked: Mapping[str, Mapping[str, Reading]], taken: frozenset[str], *, is_fact: bool
) -> tuple[AttributeView, ...]:
    found = []
    for key, by_message in ranked.items():
        if key == CHARGING or key.startswith(FACT) != is_fact:
            continue
        name = key.removeprefix(FACT)
        while name in taken or keyword.iskeyword(name):
            name += "_"
        reading = next(iter(by_message.values()))
        method = "_fact" if is_fact else "_elements" if reading.is_by_element else "_quantity"
        found.append(AttributeView(name, key, _doc(by_message), reading.enum, method))
    return tuple(found)


def _doc(by_message: Mapping[str, Reading]) -> str:
    """Return what the attribute is, in one sentence, and its unit."""
    reading = next(iter(by_message.values()))
    if reading.doc:
        doc = prose(reading.doc).partition(". ")[0].rstrip(".")  # the rest is about the sender
        doc += ", as a tuple" if reading.is_by_element else ""
    elif "flags" in reading.uses:
        doc = f"The flags of `{reading.field}` that are set, by their names, as a tuple"
    else:
        fields: dict[str, list[str]] = {}
        for message, said in by_message.items():
            fields.setdefault(said.field, []).append(message)
        doc = ", else ".join(f"`{field}` of {', '.join(messages)}" for field, messages in fields.items())
    return f"{doc}. Unit: {reading.unit}." if reading.unit else f"{doc}."


def _carriers(receiver: Receiver, ranked: Mapping[str, Mapping[str, Reading]]) -> tuple[tuple[str, str], ...]:
    """The kinds of message that carry each name, the preferred one first, as a tuple of the generated Python."""
    kinds = {message.wire.name: str(kind) for kind, message in enumerate(receiver.messages)}
    return tuple((name, _tuple(kinds[message] for message in by_message)) for name, by_message in ranked.items())


def _preference(message: PopulatedMessage, system: System) -> tuple[int, int]:
    """The new generation goes first and the old one last; where none is declared, the higher id is the newer one."""
    rank = 1
    for generations in system.generations:
        if message.name in generations.new:
            rank = 0
        elif message.name in generations.old:
            rank = 2
    return rank, -message.wire.id


def _roles(readings: Iterable[Reading], spoken: RolesSpec) -> tuple[RoleView, ...]:
    players: dict[str, dict[str, float | int]] = {}
    for reading in readings:
        role = "charging" if reading.name == CHARGING else role_of(reading.field, spoken)
        if role is None:
            continue
        wanted = UNITS.get(role)
        factor: Fraction | None = Fraction(1)
        if wanted is not None:
            unit = Unit.parse(reading.unit)
            factor = ratio(unit, unit_named(wanted)) if unit else None
        if factor is not None:
            players.setdefault(role, {})[reading.name] = int(factor) if factor.denominator == 1 else float(factor)
    pairs = {name: [f"({quoted(key)}, {factor})" for key, factor in found.items()] for name, found in players.items()}
    return tuple(RoleView(name, _tuple(pairs[name])) for name in sorted(pairs))


def _tuple(items: Iterable[str]) -> str:
    """A tuple of the generated Python."""
    listed = list(items)
    return f"({listed[0]},)" if len(listed) == 1 else f"({', '.join(listed)})"
