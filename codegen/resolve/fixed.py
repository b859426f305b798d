"""Answers that are known at build time: enum entries, flags, facts of the board and the dialect, unknown."""

from collections.abc import Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.dialect import Dialect, EnumDefinition, Kind, SentinelForm
from codegen.model.spec import Spec
from codegen.model.state_spec import StateSpec
from codegen.model.system import Elements, FixedBinding, FlagsBinding, PartBinding, TextBinding
from codegen.model.unit import decimal, read_measure
from codegen.model.vehicle import Component, Instance, Quantity, QuantityKind
from codegen.resolve.constant import BAD_CONSTANT, bind_constant, fits
from codegen.resolve.instances import cells_of, known_facts
from codegen.resolve.quantity import UNKNOWN_ENTRY, UNKNOWN_ENUM
from codegen.resolve.state import UNKNOWN_QUANTITY
from codegen.source import Place

NO_SENTINEL = Rule(
    "no-sentinel",
    "A table says unknown, or a quantity can become unknown, where the dialect has no value that means unknown. "
    "Give the quantity an initial value, answer the field otherwise, or, where the dialect states the sentinel only "
    "in words, add it to the corrections file.",
)
NOT_AN_ENUM_FIELD = Rule("not-an-enum-field", "An enum entry or flags are given for a field that has no such enum.")
UNKNOWN_FACT = Rule("unknown-fact", "A table names a fact that board.yaml, or the dialect, does not have.")
UNIQUE_ID = "unique_id"
"""What a table writes for the number that the maker gave the board's chip, as a text in hex."""
NOT_A_BOOLEAN = Rule("not-a-boolean", "Only a boolean quantity can decide whether a flag is set.")


def bind_unknown(covers: Elements, report: Report) -> FixedBinding | None:
    """The sentinel(s) of the dialect for every covered element."""
    field = covers.field
    sentinel = field.sentinel
    if sentinel is None or sentinel.values[covers.first] is None:
        report.add(
            NO_SENTINEL,
            covers.answer.at("unknown"),
            f"{field.name} has no value that means unknown",
            "if its description names one, add it to the corrections file as 'invalid'",
            [(field.definition.place, f"{field.name} is declared here")],
        )
        return None
    if field.type.kind is Kind.CHAR:
        return FixedBinding(covers, ("",), f"unknown ({sentinel.written})", is_unknown=True)
    if sentinel.form is SentinelForm.FIRST and covers.first == 0:
        values = (sentinel.values[0], *[0] * (covers.count - 1))
    else:
        values = sentinel.values[covers.first : covers.first + covers.count]
    known = [value for value in values if value is not None]
    if len(known) < covers.count:
        report.add(
            NO_SENTINEL,
            covers.answer.at("unknown"),
            f"{field.name} has no value that means unknown for each of these elements",
            f"the dialect says invalid={sentinel.written!r}",
            [(sentinel.place, "the sentinel is stated here")],
        )
        return None
    return FixedBinding(covers, tuple(known), f"unknown ({sentinel.written})", is_unknown=True)


def _enum_of(covers: Elements, dialect: Dialect, key: str, report: Report) -> EnumDefinition | None:
    name = covers.field.definition.enum
    if name is None:
        report.add(NOT_AN_ENUM_FIELD, covers.answer.at(key), f"{covers.field.name} has no enum in the dialect")
        return None
    enum = dialect.enums.get(name)
    if enum is None:
        report.add(UNKNOWN_ENUM, covers.answer.at(key), f"the dialect has no enum {name}")
    return enum


def _entry_value(enum: EnumDefinition, name: str, place: Place, dialect: Dialect, report: Report) -> int | None:
    entry = enum.entry(name)
    if entry is not None:
        return entry.value
    owner = next((other.name for other in dialect.enums.values() if other.entry(name)), None)
    hint = f"{name} belongs to {owner}" if owner else did_you_mean(name, [entry.name for entry in enum.entries])
    report.add(UNKNOWN_ENTRY, place, f"{enum.name} has no entry {name}", hint)
    return None


def bind_entry(covers: Elements, name: str, key: str, dialect: Dialect, report: Report) -> FixedBinding | None:
    """One entry of the field's enum."""
    enum = _enum_of(covers, dialect, key, report)
    value = _entry_value(enum, name, covers.answer.at(key), dialect, report) if enum else None
    if value is None or not fits(covers, value, key, name, report):
        return None
    return FixedBinding(covers, (value,) * covers.count, name)


def bind_flags(
    covers: Elements,
    flags: tuple[str, ...],
    dialect: Dialect,
    components: Mapping[str, Component],
    state: StateSpec,
    report: Report,
) -> FlagsBinding | None:
    """Entries of the field's bitmask, always set or set while a boolean quantity is true."""
    enum = _enum_of(covers, dialect, "flags", report)
    if enum is None:
        return None
    place = covers.answer.at("flags")
    if not (enum.is_bitmask or covers.field.definition.is_bitmask):
        report.add(NOT_AN_ENUM_FIELD, place, f"{enum.name} is not a bitmask", "give one entry with 'enum'")
        return None
    mask, names, conditional = 0, [], []
    for flag in flags:
        name, separator, path = flag.partition(" if ")
        value = _entry_value(enum, name.strip(), place, dialect, report)
        quantity = _condition(path.strip(), components, state, place, report) if separator else None
        if value is None or (separator and quantity is None) or not fits(covers, value, "flags", name, report):
            continue
        if quantity is None:
            mask |= value
            names.append(name.strip())
        else:
            conditional.append((name.strip(), value, quantity))
    return FlagsBinding(covers, mask, tuple(names), tuple(conditional))


def _condition(
    path: str, components: Mapping[str, Component], state: StateSpec, place: Place, report: Report
) -> Quantity | None:
    quantity = find_quantity(path, components, state, place, report)
    if quantity is not None and quantity.kind is not QuantityKind.BOOLEAN:
        report.add(NOT_A_BOOLEAN, place, f"{path} is not a boolean")
        return None
    return quantity


def find_quantity(
    path: str, components: Mapping[str, Component], state: StateSpec, place: Place, report: Report
) -> Quantity | None:
    """The quantity written as ``component.quantity``; one that is written but broken has been reported already."""
    component, _, name = path.partition(".")
    if component in components and name in components[component].quantities:
        return components[component].quantities[name]
    if component in state.components and name in state.components[component].quantities:
        return None
    known = [f"{owner.name}.{quantity}" for owner in components.values() for quantity in owner.quantities]
    report.add(UNKNOWN_QUANTITY, place, f"the state has no quantity {path}", did_you_mean(path, known))
    return None


def bind_fact(
    covers: Elements,
    path: str,
    component: Component | None,
    components: Mapping[str, Component],
    spec: Spec,
    dialect: Dialect,
    report: Report,
) -> FixedBinding | PartBinding | TextBinding | None:
    """A fact of board.yaml: an enum entry, a number or an amount; of a message for each instance, that of each.

    A message that is not sent for each instance has the fact of the first one. ``unique_id`` is the number of the chip.
    """
    if path == UNIQUE_ID:
        return _bind_text(covers, path, report)
    owner, _, name = path.partition(".")
    place = covers.answer.at("board")
    parts = components[owner].parts if owner in components else ()
    facts = [part.facts.get(name) for part in parts] or [spec.board.facts.get(owner, {}).get(name)]
    if component is None or component.name != owner:
        facts = facts[:1]
    found = [fact for fact in facts if fact is not None]
    if not found:
        hint = did_you_mean(path, [*known_facts(spec, components), UNIQUE_ID])
        report.add(UNKNOWN_FACT, place, f"board.yaml has no fact {path}", hint)
        return None
    if len(found) < len(facts):
        message = f"board.yaml has no fact {name} of {owner} {facts.index(None) + 1}"
        report.add(UNKNOWN_FACT, place, message, f"state it under instances, or under facts for every {owner}")
        return None
    if covers.answer.per_cell:
        times = _of_packs(covers, path, found, parts, report)
        if times is None:
            return None
        found = times
    bindings = []
    for fact in dict.fromkeys(found):
        binding = _bind_value(covers, fact, dialect, report)
        if binding is None:
            return None
        bindings.append(binding)
    if len(bindings) == 1:
        return bindings[0]
    by_fact = dict(zip(dict.fromkeys(found), bindings, strict=True))
    return PartBinding(covers, tuple(by_fact[fact] for fact in found))


def _of_packs(
    covers: Elements, path: str, facts: list[str | Fraction], parts: tuple[Instance, ...], report: Report
) -> list[str | Fraction] | None:
    """Facts of one cell, by instance, as those of the packs: numbers or amounts times the fact cells."""
    packs: list[str | Fraction] = []
    for fact, part in zip(facts, parts, strict=False):
        cells = cells_of(part)
        measure = read_measure(fact) if isinstance(fact, str) else None
        if cells is None or (isinstance(fact, str) and measure is None):
            message = f"{path} of {fact} cannot be multiplied with {part.facts.get('cells', 'no number of')} cells"
            report.add(UNKNOWN_FACT, covers.answer.at("per_cell"), message)
            return None
        packs.append(f"{decimal(measure.value * cells)} {measure.unit.name}" if measure else Fraction(fact) * cells)
    return packs


def _bind_value(covers: Elements, fact: str | Fraction, dialect: Dialect, report: Report) -> FixedBinding | None:
    if isinstance(fact, str) and read_measure(fact) is None and covers.field.type.kind is not Kind.CHAR:
        return bind_entry(covers, fact, "board", dialect, report)
    return bind_constant(covers, fact, "board", report)


def _bind_text(covers: Elements, source: str, report: Report) -> TextBinding | None:
    """A text that only the running board knows."""
    if covers.field.type.kind is not Kind.CHAR:
        message = f"{covers.field.name} is a {covers.field.type.name}, and {source} a text"
        report.add(BAD_CONSTANT, covers.answer.at("board"), message)
        return None
    return TextBinding(covers, source)


def bind_version(covers: Elements, name: str, dialect: Dialect, report: Report) -> FixedBinding | None:
    """A fact of the dialect; so far its version, which fields of type uint8_t_mavlink_version carry."""
    if name != "version":
        report.add(UNKNOWN_FACT, covers.answer.at("dialect"), f"the dialect has no fact {name}", "known: version")
        return None
    return FixedBinding(covers, (dialect.version,), "version of the dialect")
