"""Judges changes of a vehicle by what ground stations hear: nothing any more, less often, or other numbers."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction

from codegen.diagnostics import shortened_list
from codegen.diff.change import Change, ChangeRule
from codegen.diff.system import acted_otherwise, commanded_otherwise, kept_otherwise, told_otherwise
from codegen.diff.system import behaviour_rules as rules
from codegen.diff.system.carrying import carried_on, fields_by_source, scaling_parameters, told_of_fact
from codegen.diff.system.judged import Sides, breaking, doubtful, is_narrower, table_of
from codegen.model.price import default_rate
from codegen.model.reception import ReceivedField
from codegen.model.spec.receive import Sender as TakenFrom
from codegen.model.system import PopulatedMessage, System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import AdcChannel, Parameter
from codegen.summaries.parameters import uses

_ADDRESSED = ("uart", "baud", "udp", "tcp_server", "tcp_client", "to", "local_port")
_WIRED = ("tx", "rx")


def heard_otherwise(changes: Iterable[Change], old: System, new: System) -> Iterator[Change]:
    """The changes of a program, those judged that alter what ground stations hear."""
    sides = Sides(old, new, {**fields_by_source(old), **fields_by_source(new)})
    for change in changes:
        judge = _JUDGES.get(change.rule)
        yield judge(change, sides) if judge is not None else change


def _schedule(change: Change, sides: Sides) -> Change:
    """A message on another stream, or on none: nothing is heard, or less."""
    old, new = (table_of(side, change.subject) for side in (sides.old, sides.new))
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


def _stream_rate(change: Change, sides: Sides) -> Change:
    name = change.subject.removeprefix("stream ")
    change = told_otherwise.asked(change, sides)
    if name not in sides.old.streams or name not in sides.new.streams or change.is_breaking:
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
        if old is None or new is None or _is_told_elsewhere(new, sides.new):
            return change
        decided = " and ".join(_decided(new, sides.new))
        wanted = f"another value is meant for {decided}" if decided else "what it decides is meant"
        return doubtful(change, f"whether {wanted}, where no value is stored")
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
    return tuple(each.removeprefix(f"of {first.component} {first.instance + 1}: ") for each in uses(first, system))


def _is_told_elsewhere(parameter: Parameter, system: System) -> bool:
    """Return whether it says nothing but what is judged by itself: the rate of a stream, who the vehicle is, which
    generation is sent.
    """
    chosen = (
        system.system_parameter,
        system.component_parameter,
        *(stream.parameter for stream in system.streams.values()),
        *(generations.parameter for generations in system.generations),
    )
    return any(each is not None and each.name == parameter.name for each in chosen)


def _channel(change: Change, sides: Sides) -> Change:
    """An ADC channel with another pin, reference or resolution: the same counts are other numbers."""
    old, new = (side.channels.get(change.subject.removeprefix("adc.")) for side in (sides.old, sides.new))
    fields = shortened_list(sides.fields.get(change.subject, ()), 3)
    if old is not None and new is None:
        return breaking(change, f"nothing is measured for {fields}") if fields else change
    if old is None or new is None:
        return change
    doubt = "whether the board was changed with it"
    if not fields:  # failsafes and code may act on it all the same
        is_read = any(change.subject in carried_on(side) for side in (sides.old, sides.new))
        return doubtful(change, doubt) if is_read and _wired(old) != _wired(new) else change
    factor = _volts(new) / _volts(old)
    if factor != 1:
        return doubtful(change, doubt, f"the same count is {decimal(factor)} times what it was in {fields}")
    if _wired(old) != _wired(new):
        return doubtful(change, doubt, f"{fields} are measured at another pin")
    return change


def _wired(channel: AdcChannel) -> tuple[object, ...]:
    """Return where a count comes from, and what it is."""
    return channel.gpio, channel.pin and channel.pin.name, _volts(channel)


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
    if old.spec.credentials != new.spec.credentials:
        return doubtful(change, f"whether {new.spec.credentials} is on boards, for the same network")
    return change


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
        change = doubtful(change, "whether nothing is to be done when it arrives")
    if before - after or new.spec.sender is not old.spec.sender:
        change = doubtful(change, "whether what others send, or send otherwise, is to be obeyed")
    return change


def _taken_range(change: Change, sides: Sides) -> Change:
    """A field of a received message of which fewer numbers count as plausible."""
    old, new = (_taken(side, change.subject) for side in (sides.old, sides.new))
    if old is None or new is None or (old.factor, old.spec.rounding) != (new.factor, new.spec.rounding):
        return change  # whose limits are other numbers anyway
    if is_narrower((old.low, old.high), (new.low, new.high)):
        return doubtful(change, "whether what is ignored now is sent, which nothing tells")
    return change


def _taken(system: System, subject: str) -> ReceivedField | None:
    name = subject.removesuffix(", received")
    fields = ((f"{table.name}.{field.label}", field) for table in system.receptions for field in table.fields)
    return next((field for label, field in fields if label == name), None)


def _taken_as(change: Change, sides: Sides) -> Change:
    """A field of a received message of which the same number is another amount."""
    old, new = (_taken(side, change.subject) for side in (sides.old, sides.new))
    if old is None or new is None or _amount(old) == _amount(new):
        return change
    return doubtful(change, "whether who sends it means the other amount")


def _amount(field: ReceivedField) -> Fraction:
    """Return what a step on the wire is taken for, whatever unit it is kept in."""
    return field.factor * field.quantity.stored.scale


_JUDGES: Mapping[ChangeRule, Callable[[Change, Sides], Change]] = {
    rules.MESSAGE_STREAM: _schedule,
    rules.MESSAGE_INSTANCES: told_otherwise.instances,
    rules.STREAM_RATE: _stream_rate,
    rules.STREAM_REMOVED: told_otherwise.asked,
    rules.PARAMETER_DEFAULT: _default,
    rules.CHANNEL: _channel,
    rules.LINK: _link,
    rules.INSTANCES: _instances,
    rules.FACT: _fact,
    rules.GENERATIONS: _generations,
    rules.TAKEN_FROM: _taken_from,
    rules.TAKEN_AS: _taken_as,
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
