"""The whole story of one thing as text for a terminal: a message, a field, a parameter, a command, a rule, the loop."""

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from textwrap import fill

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.explain.commands import command_story, command_topics
from codegen.explain.corrections import correction_facts
from codegen.explain.dialect import attributes, dialect_story
from codegen.explain.receptions import explained_received_field, explained_reception
from codegen.explain.text import cited, columns, facts
from codegen.explain.watching import watching_stories, watching_topics
from codegen.findings.catalogue import rule_catalogue
from codegen.model.answers.account import FLAGS
from codegen.model.quantities.reach import reach_words, reaches
from codegen.model.system import Generations, PopulatedMessage, Representation, System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import Parameter, Quantity, Stream
from codegen.summaries.fields import FieldRow, field_rows, others_of, withheld_of
from codegen.summaries.generations import GenerationTable, generation_tables, sent_at_once
from codegen.summaries.parameters import type_words, uses

UNKNOWN_TOPIC = Rule(
    "unknown-topic",
    "explain was asked for something that is no message, field, parameter, quantity, sensor, failsafe or rule of this "
    "project, or that errors in the specification leave nothing to tell of.",
    unreadable=True,
    remedy="name a message, a field as MESSAGE.field, a parameter, a quantity or a rule",
)

LOOP, HEAP = "loop", "heap"
"""The topics that are nothing in a specification: the main loop and the heap, whatever else is called so."""

_COLUMNS = (
    "offset",
    "size",
    "field",
    "type",
    "unit",
    "source",
    "conversion",
    "limits",
    "unknown",
    "criterion",
    "where",
)


def explain_rule(topic: str) -> str | None:
    """Return what a rule means and what to do; None if there is no such rule."""
    rule = rule_catalogue().get(topic)
    return None if rule is None else f"{rule.id} ({rule.standing})\n\n{rule.explanation}\n"


def explain(topic: str, system: System | None, report: Report) -> str | None:
    """The text for ``topic``; None, with a finding, if there is nothing to tell. Rules need no system."""
    if system is None:
        return explain_rule(topic)
    story = own_story(topic, system)
    if story is None and not system.tables(topic.partition(".")[0].upper()):
        story = dialect_story(topic, system)
    if story is None:
        place, topics = system.spec.project.place, _topics(system)
        if topic in topics:  # its table is there, and what that says of it has errors
            text = f"nothing can be told of {topic}: the specification has errors"
            report.add(UNKNOWN_TOPIC, place, text, "mend these first")
        else:
            report.add(UNKNOWN_TOPIC, place, f"nothing is called {topic}", did_you_mean(topic, topics))
    return story


def own_story(topic: str, system: System) -> str | None:
    """The text for a rule, or what a program has itself; None for what only its dialect knows, and for nothing."""
    if topic == LOOP:
        from codegen.explain.loop import loop_story  # noqa: PLC0415  nothing else needs what was measured

        return loop_story(system)
    if topic == HEAP:
        from codegen.explain.heap import heap_story  # noqa: PLC0415  nor what was weighed

        return heap_story(system)
    return explain_rule(topic) or _explain_part(topic, system)


def _explain_part(topic: str, system: System) -> str | None:
    name, _, field = topic.partition(".")
    tables = [message for message in system.messages if message.name == name] or system.tables(name.upper())
    received = [table for table in system.receptions if table.name == name or table.wire.name == name.upper()]
    if tables or received:
        stories = [_message(message, system) if not field else _field(message, field, system) for message in tables]
        stories += [
            explained_reception(table) if not field else explained_received_field(table, field, system)
            for table in received
        ]
        return "\n".join(filter(None, stories)) or None
    if name.upper() in system.dialect.messages:
        return None
    if name in system.requirements:
        return _requirement(topic, system)
    if topic in system.streams:
        return _stream(system.streams[topic], system)
    if topic in system.components:
        quantities = [_quantity(quantity, system) for quantity in system.components[topic].quantities.values()]
        costs = _prices(lambda generations: generations.component.name == topic, system)
        return "\n".join([*quantities, *costs[1:], *watching_stories(topic, system)]) + "\n" * bool(costs)
    if topic in system.parameters:
        return _parameter(system.parameters[topic], system)
    quantity = system.quantity(topic)
    if quantity is not None:
        return _quantity(quantity, system)
    watching = "\n".join(watching_stories(topic, system))
    if watching:
        return watching
    story = command_story(topic, system)
    return None if story is None else "\n".join([story[0], story[1].strip(), "", *facts(story[2])]) + "\n"


def _topics(system: System) -> list[str]:
    known = list(dict.fromkeys(name for message in system.messages for name in (message.name, message.wire.name)))
    known += list(dict.fromkeys(name for table in system.receptions for name in (table.name, table.wire.name)))
    known += [f"{table.name}.{taken.label}" for table in system.receptions for taken in table.fields]
    known += [f"{message.name}.{field.name}" for message in system.messages for field in message.wire.fields]
    known += [quantity.path for component in system.components.values() for quantity in component.quantities.values()]
    known += [*system.components, *system.streams, *system.requirements]
    return [
        LOOP,
        HEAP,
        *known,
        *system.parameters,
        *watching_topics(system),
        *command_topics(system),
        *rule_catalogue(),
        *system.dialect.messages,
    ]


def _message(message: PopulatedMessage, system: System) -> str:
    wire = message.wire
    extensions = f", {wire.length} with extensions" if wire.length != wire.base_length else ""
    lines = [
        f"{message.title}, CRC_EXTRA {wire.crc_extra}, payload {wire.base_length} bytes{extensions}",
        f"{cited(message.citation)}",
        f"{_rate(message)}; {message.instances} of it{_pages(message)}",
        *([f"sent at once {sent_at_once(message)}"] if message.is_announced else []),
        *_others(message),
        *_withheld(message),
        *(f"about {choice.component.name}: {_chosen(choice)}" for choice in message.represents.values()),
        "",
        *_table(field_rows(message)),
        *_prices(lambda generations: message.name in (*generations.old, *generations.new), system),
    ]
    return "\n".join(lines) + "\n"


def _others(message: PopulatedMessage) -> list[str]:
    """The fields that the table does not list."""
    fields = others_of(message)
    return [fill(f"unknown, as the table does not list them: {fields}", 100)] if fields else []


def _withheld(message: PopulatedMessage) -> list[str]:
    """Return what withholds the message."""
    causes = withheld_of(message)
    return [fill(f"withheld while one of these is unknown: {causes}", 100)] if causes else []


def _pages(message: PopulatedMessage) -> str:
    return f", up to {message.pages} pages each" if message.pages > 1 else ""


def _chosen(choice: Representation) -> str:
    """Return which instance a single message reports."""
    if choice.parameter is not None:
        return f"the one whose number {choice.parameter.name} has, else the first enabled one"
    if choice.quantity is not None:
        return f"the enabled one with the lowest {choice.quantity.name}, else the first enabled one"
    return "the first one"


def _rate(message: PopulatedMessage) -> str:
    stream = message.stream
    if stream is None:
        return "sent when a ground station asks for it"
    rate = f"{decimal(stream.default_rate)} Hz"
    if stream.parameter is not None:
        return f"stream {stream.name}: {stream.parameter.name} sets the rate, {rate} by default"
    return f"stream {stream.name}: {rate}"


def _cells(row: FieldRow) -> Iterator[tuple[str, ...]]:
    """The cells of a row; each further flag has a line of its own."""
    source, *others = row.source.split(FLAGS)
    yield (
        str(row.offset),
        str(row.size),
        row.field,
        row.type,
        row.unit,
        source,
        row.conversion,
        row.limits,
        row.sentinel,
        row.criterion,
        row.place.shown().rpartition(":")[0],
    )
    for flag in others:
        yield tuple(flag if name == "source" else "" for name in _COLUMNS)


def _table(rows: Sequence[FieldRow]) -> list[str]:
    return columns([_COLUMNS, *(cells for row in rows for cells in _cells(row))], numbers=2, is_ruled=True)


def _field(message: PopulatedMessage, name: str, system: System) -> str | None:
    wire = message.wire.field(name.partition("[")[0])
    answers = [answer for answer in message.answers if name in (answer.covers.field.name, answer.covers.label)]
    if wire is None or not answers:
        return None
    rows = {row.offset: row for row in field_rows(message)}
    parts = [f"{message.name}.{wire.name}", fill(wire.definition.description, 100), ""]
    for answer in answers:
        row = rows[answer.covers.offset]
        told = [
            ("field", row.field),
            ("offset", f"{row.offset}, {row.size} bytes"),
            ("type", row.type),
            ("unit", row.unit),
            ("enum", wire.definition.enum or ""),
            *attributes(wire),
            ("source", row.source),
            ("conversion", row.conversion),
            ("limits", row.limits),
            ("unknown", f"{row.sentinel}  ({wire.sentinel.place.shown()})" if wire.sentinel else "no sentinel"),
            *correction_facts(system.dialect, message.name, wire.name),
            ("criterion", cited(answer.covers.citation)),
            ("answered at", row.place.shown()),
            ("declared at", wire.definition.place.shown()),
            ("note", answer.covers.written.note or ""),
        ]
        parts += facts(told)
    return "\n".join(parts) + "\n"


def _parameter(parameter: Parameter, system: System) -> str:
    unit = f" {parameter.unit.name}" if parameter.unit.name else ""
    meanings = [f"{decimal(steps * parameter.step)} {meaning}" for steps, meaning in sorted(parameter.choices.items())]
    told = [
        ("type", type_words(parameter, system)),
        ("default", f"{decimal(parameter.default * parameter.step)}{unit}"),
        (
            "range",
            f"{decimal(parameter.minimum * parameter.step)}..{decimal(parameter.maximum * parameter.step)}{unit}",
        ),
        ("step", f"{decimal(parameter.step)}{unit}; kept as {parameter.minimum}..{parameter.maximum} steps"),
        ("used", "from the next start" if parameter.spec.reboot else "at once"),
        ("values", ", ".join(meanings)),
        (
            "sets",
            ", ".join(uses(parameter, system))
            or "nothing in the firmware: ground stations and the user's code read it",
        ),
        ("criterion", cited(parameter.citation)),
        ("declared at", parameter.spec.place.shown()),
    ]
    costs = _prices(lambda generations: generations.parameter is parameter, system)
    return "\n".join([parameter.name, parameter.spec.doc.strip(), "", *facts(told), *costs]) + "\n"


def _prices(concerns: Callable[[Generations], bool], system: System) -> list[str]:
    """Return what the generations of messages cost that a topic concerns, each with an empty line before it."""
    return [
        line
        for generations, table in zip(system.generations, generation_tables(system), strict=True)
        if concerns(generations)
        for line in _generations(table)
    ]


def _generations(table: GenerationTable) -> list[str]:
    choices = [("bytes/s", *table.instances, table.on, "messages")]
    choices += [(row.choice, *row.by_instance, row.whole, row.messages) for row in table.choices]
    frames = [("message", "generation", "rate", *(f"bytes, {name}" for name in table.instances), "sent at once")]
    for row in table.frames:
        sizes = [*row.by_instance, *[""] * (len(table.instances) - len(row.by_instance))]
        frames.append((row.message, row.generation, row.rate, *sizes, row.sent_at_once))
    title = f"{table.component} messages of two generations, at the default rates ({table.chosen_by})"
    return ["", title, "", *columns(choices), "", *columns(frames), "", fill(table.counted, 100)]


def _quantity(quantity: Quantity, system: System) -> str:
    fields = [
        f"{message.name}.{answer.covers.label}"
        for message in system.messages
        for answer in message.answers
        if quantity in answer.quantities
    ]
    limits = reach_words(quantity, reaches(system)[quantity.path])
    told = "; what is set beyond them is limited in messages, counted, and told once"
    if quantity.derivation.gives:
        told = "; nothing is sent beyond them: what its sensor gives beyond what is plausible is unknown"
    titled = [
        ("kept as", f"{quantity.attribute}, {quantity.kept_in}"),
        ("limits", limits and limits + told),
        *quantity.derivation.story(quantity, system),
        ("initial", quantity.start),
        ("unknown", quantity.lost),
        ("sent in", ", ".join(fields)),
        ("criterion", cited(quantity.citation)),
        ("declared at", quantity.spec.place.shown()),
    ]
    return "\n".join([quantity.path, quantity.spec.doc.strip(), "", *facts(titled)]) + "\n"


def _requirement(topic: str, system: System) -> str | None:
    """A document with its criteria, or one criterion, and the fields that answer to each."""
    name, _, number = topic.partition(".")
    requirement = system.requirements[name]
    criteria = [criterion for criterion in requirement.criteria if number in ("", str(criterion.number))]
    if number and not criteria:
        return None
    lines = [f"{requirement.id} | {requirement.title} ({requirement.status})  ({requirement.place.shown()})"]
    needed_by = _needed_by(system)
    for criterion in criteria:
        named = f"{requirement.id}.{criterion.number}"
        lines += ["", f"{named}: {criterion.text}"]
        lines += [
            f"  depends on {each}" for each in criterion.depends_on if each.partition(".")[0] in system.requirements
        ]
        lines += [f"  {name} depends on it" for name in needed_by.get(named, ())]
        lines += [f"  {field}" for field in _answering(named, system)]
    return "\n".join(lines) + "\n"


def _needed_by(system: System) -> dict[str, list[str]]:
    """Return by criterion those that depend on it."""
    found: dict[str, list[str]] = {}
    for requirement in {each.id: each for each in system.requirements.values()}.values():
        for criterion in requirement.criteria:
            for written in criterion.depends_on:
                document, dot, number = written.partition(".")
                known = system.requirements.get(document)
                name = f"{known.id if known else document}{dot}{number}"
                found.setdefault(name, []).append(f"{requirement.id}.{criterion.number}")
    return found


def _answering(criterion: str, system: System) -> list[str]:
    return [
        f"{message.name}.{answer.covers.label}  ({answer.covers.written.place.shown()})"
        for message in system.messages
        for answer in message.answers
        if str(answer.covers.citation) == criterion
    ] + [
        f"{table.name}.{taken.label}, received  ({taken.spec.place.shown()})"
        for table in system.receptions
        for taken in table.fields
        if str(taken.citation) == criterion
    ]


def _stream(stream: Stream, system: System) -> str:
    messages = [message for message in system.messages if message.stream is stream]
    told = [
        ("rate", stream.parameter.name if stream.parameter else f"{decimal(stream.rate or Fraction(0))} Hz"),
        ("messages", ", ".join(message.name for message in messages)),
        ("criterion", cited(stream.citation)),
        ("declared at", stream.spec.place.shown()),
    ]
    return "\n".join([stream.name, stream.spec.doc.strip(), "", *facts(told)]) + "\n"
