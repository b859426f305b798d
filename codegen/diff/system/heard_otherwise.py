"""Judges changes of a vehicle by what ground stations hear: nothing any more, less often, or other numbers."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction

from codegen.diagnostics import shortened_list
from codegen.diff.change import Change, ChangeRule
from codegen.diff.system import acted_otherwise, commanded_otherwise, kept_otherwise
from codegen.diff.system import behaviour_rules as rules
from codegen.diff.system.carrying import fields_by_source, scaling_parameters, told_of_fact
from codegen.diff.system.judged import Sides, breaking, doubtful, is_narrower
from codegen.model.price import default_rate
from codegen.model.spec.receive import Sender as TakenFrom
from codegen.model.system import PopulatedMessage, System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import AdcChannel, Parameter
from codegen.summaries.parameters import uses

_ADDRESSED = ("uart", "baud", "udp", "tcp_server", "tcp_client", "to", "local_port")
_WIRED = ("tx", "rx")
_TOLD_APART = ("the rate of stream", "which generation")
"""Uses of parameters whose defaults are changes of their own: what is sent by default."""


def heard_otherwise(changes: Iterable[Change], old: System, new: System) -> Iterator[Change]:
    """The changes of a program, those judged that alter what ground stations hear."""
    sides = Sides(old, new, {**fields_by_source(old), **fields_by_source(new)})
    for change in changes:
        judge = _JUDGES.get(change.rule)
        yield judge(change, sides) if judge is not None else change


def _schedule(change: Change, sides: Sides) -> Change:
    """A message on another stream, or on none: nothing is heard, or less."""
    old, new = (_table(side, change.subject) for side in (sides.old, sides.new))
    if old is None or new is None:
        return change
    before, after = default_rate(old), default_rate(new)
    if before and not after and new.stream is None and not (new.on_connection or new.on_change):
        return breaking(change, "who does not ask for it hears nothing")
    if old.on_change is not None and new.on_change is not old.on_change:
        change = _told_of_change(change, old, new, is_sent=bool(after))
    if old.on_connection and not (new.on_connection or after):
        change = breaking(change, "who connects and does not ask for it hears nothing")
    if len(new.withheld_for) > len(old.withheld_for):
        return doubtful(change, "whether receivers take its silence for a lost link while something is unknown")
    return _rates(change, before, after)


def _told_of_change(change: Change, old: PopulatedMessage, new: PopulatedMessage, *, is_sent: bool) -> Change:
    """A message that is no longer sent as soon as a quantity is another one."""
    assert old.on_change is not None
    path = old.on_change.path
    if new.on_change is not None and new.on_change.path == path:
        return change
    if not is_sent and new.on_change is None:
        return breaking(change, f"who does not ask for it hears of no change of {path}")
    return doubtful(change, f"whether it is heard soon enough that {path} has changed")


def _table(system: System, name: str) -> PopulatedMessage | None:
    return next((message for message in system.messages if message.name == name), None)


def _stream_rate(change: Change, sides: Sides) -> Change:
    name = change.subject.removeprefix("stream ")
    if name not in sides.old.streams or name not in sides.new.streams:
        return change
    return _rates(change, sides.old.streams[name].default_rate, sides.new.streams[name].default_rate)


def _rates(change: Change, before: Fraction, after: Fraction) -> Change:
    if before and not after:
        return breaking(change, "who does not ask for it hears nothing")
    if after < before:
        shown = f"{decimal(after)} times a second and no longer {decimal(before)}"
        return doubtful(change, f"whether it is heard often enough: {shown}")
    return change


def _default(change: Change, sides: Sides) -> Change:
    """A parameter whose default makes numbers, a multiplier or what goes out itself, or decides what is done."""
    fields = sides.fields.get(change.subject, ())
    old, new = (side.parameters.get(change.subject) for side in (sides.old, sides.new))
    if not fields:
        decided = () if new is None else _decided(new, sides.new)
        if not decided:
            return change
        return doubtful(change, f"whether another value is meant for {' and '.join(decided)}, where no value is stored")
    shown = shortened_list(fields, 3)
    scaled = scaling_parameters(sides.new).get(change.subject)
    if scaled and old is not None and new is not None and old.default:
        factor = decimal(Fraction(new.default) * new.step / (old.default * old.step))
        effect = f"the same reading is {factor} times what it was in {shown}, where no value is stored"
        return doubtful(change, "whether what is measured changed with it", effect)
    return doubtful(change, f"whether other numbers in {shown} are meant, where no value is stored")


def _decided(parameter: Parameter, system: System) -> tuple[str, ...]:
    """Return what a parameter decides, in words, those of a family together."""
    first = system.parameters.get(parameter.siblings[0], parameter) if parameter.siblings else parameter
    found = [each.removeprefix(f"of {first.component} {first.instance + 1}: ") for each in uses(first, system)]
    return tuple(each for each in found if not each.startswith(_TOLD_APART))


def _channel(change: Change, sides: Sides) -> Change:
    """An ADC channel with another pin, reference or resolution: the same counts are other numbers."""
    old, new = (side.channels.get(change.subject.removeprefix("adc.")) for side in (sides.old, sides.new))
    fields = shortened_list(sides.fields.get(change.subject, ()), 3)
    if old is not None and new is None:
        return breaking(change, f"nothing is measured for {fields}") if fields else change
    if old is None or new is None or not fields:
        return change
    doubt = "whether the board was changed with it"
    factor = _volts(new) / _volts(old)
    if factor != 1:
        return doubtful(change, doubt, f"the same count is {decimal(factor)} times what it was in {fields}")
    if (old.gpio, old.pin and old.pin.name) != (new.gpio, new.pin and new.pin.name):
        return doubtful(change, doubt, f"{fields} are measured at another pin")
    return change


def _volts(channel: AdcChannel) -> Fraction:
    """Return what a count is, in volts."""
    return channel.reference / channel.full_scale


def _link(change: Change, sides: Sides) -> Change:
    name = change.subject.removeprefix("link.")
    old, new = (next((link for link in side.links if link.name == name), None) for side in (sides.old, sides.new))
    if old is None:
        return change
    if new is None or old.kind is not new.kind:
        return breaking(change, "who listens on it hears nothing")
    if any(getattr(old.spec, name) != getattr(new.spec, name) for name in _ADDRESSED):
        return breaking(change, "who listens as before hears nothing")
    if any(getattr(old.spec, name) != getattr(new.spec, name) for name in _WIRED):
        return doubtful(change, "whether the wiring was changed with it")
    return change


def _represented(change: Change, sides: Sides) -> Change:
    """A message that is about another one of several instances."""
    old, new = (_table(side, change.subject) for side in (sides.old, sides.new))
    if old is None or new is None:
        return change
    chosen = [
        {name: (each.policy, each.parameter and each.parameter.name) for name, each in side.represents.items()}
        for side in (old, new)
    ]
    other = [name for name in chosen[1] if name in chosen[0] and chosen[0][name] != chosen[1][name]]
    return doubtful(change, f"whether another {' and '.join(other)} is meant") if other else change


def _instances(change: Change, sides: Sides) -> Change:
    old, new = (side.components.get(change.subject) for side in (sides.old, sides.new))
    if old is None or new is None or len(new.parts) >= len(old.parts):
        return change
    return breaking(change, f"nothing is told of {len(old.parts) - len(new.parts)} of them")


def _fact(change: Change, sides: Sides) -> Change:
    """A fact of the board that messages tell."""
    _, component, fact = change.subject.split(".", 2)
    fields = told_of_fact(sides.new, component, fact)
    if not fields or change.old is None or change.new is None:
        return change
    shown = shortened_list(fields, 3)
    return doubtful(
        change, f"whether {change.new.removeprefix(fact).strip()} is what receivers are to be told in {shown}"
    )


def _generations(change: Change, sides: Sides) -> Change:
    sent = [{name for each in side.generations for name in each.names(each.default)} for side in (sides.old, sides.new)]
    gone = sorted(sent[0] - sent[1])
    return doubtful(change, f"whether anybody still needs {', '.join(gone)}, not sent by default") if gone else change


def _taken_from(change: Change, sides: Sides) -> Change:
    """A table that takes a message under other conditions, or from others: who meets the old ones is not heard."""
    name = change.subject.removesuffix(", received")
    old, new = (next((each for each in side.receptions if each.name == name), None) for side in (sides.old, sides.new))
    if old is None or new is None:
        return change
    before, after = ({(field.name, number) for field, number in each.conditions} for each in (old, new))
    narrower = sorted(after - before)
    if narrower:
        shown = " and ".join(f"{field} {number}" for field, number in narrower)
        return breaking(change, f"who sends it with anything but {shown} is not heard any more, and nothing tells")
    if new.spec.sender not in (old.spec.sender, TakenFrom.ANY):
        return breaking(change, f"only a sender that is {new.spec.sender.value} is heard, and nothing tells")
    if old.spec.call and not new.spec.call:
        return doubtful(change, "whether nothing is to be done when it arrives")
    return change


def _taken_range(change: Change, sides: Sides) -> Change:
    """A field of a received message of which fewer numbers count as plausible."""
    name = change.subject.removesuffix(", received")
    taken = [
        {f"{table.name}.{field.label}": field for table in side.receptions for field in table.fields}
        for side in (sides.old, sides.new)
    ]
    old, new = (each.get(name) for each in taken)
    if old is None or new is None or (old.factor, old.spec.rounding) != (new.factor, new.spec.rounding):
        return change  # whose limits are other numbers anyway
    if is_narrower((old.low, old.high), (new.low, new.high)):
        return doubtful(change, "whether what is ignored now is sent, which nothing tells")
    return change


_JUDGES: Mapping[ChangeRule, Callable[[Change, Sides], Change]] = {
    rules.MESSAGE_STREAM: _schedule,
    rules.STREAM_RATE: _stream_rate,
    rules.PARAMETER_DEFAULT: _default,
    rules.CHANNEL: _channel,
    rules.LINK: _link,
    rules.INSTANCES: _instances,
    rules.MESSAGE_INSTANCES: _represented,
    rules.FACT: _fact,
    rules.GENERATIONS: _generations,
    rules.TAKEN_FROM: _taken_from,
    rules.TAKEN_RANGE: _taken_range,
    rules.COMMAND: commanded_otherwise.command,
    rules.COMMAND_RANGE: commanded_otherwise.accepted,
    rules.COMMAND_REMOVED: commanded_otherwise.refused,
    rules.QUANTITY_SOURCE: kept_otherwise.source,
    rules.QUANTITY_AGE: kept_otherwise.trust,
    rules.QUANTITY_UNIT: kept_otherwise.width,
    rules.QUANTITY_RANGE: kept_otherwise.limits,
    rules.SENSOR: kept_otherwise.sensor,
    rules.PARAMETER_RANGE: kept_otherwise.parameter_range,
    rules.PARAMETER: kept_otherwise.parameter,
    rules.FAILSAFE: acted_otherwise.failsafe,
    rules.PROGRAM: acted_otherwise.program,
    rules.MODE: commanded_otherwise.mode,
}
