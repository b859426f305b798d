"""View of sources.py: how each sensor is opened, and how what it gives gets into the words of the state."""

from collections.abc import Iterable, Iterator
from fractions import Fraction
from typing import NamedTuple

from codegen.frozen import dataclass
from codegen.model.code.clock import CLOCK
from codegen.model.code.payload_code import indented
from codegen.model.code.storage import SMALL_INT_MAX, Storage
from codegen.model.quantities.source_kind import Output, Source
from codegen.model.sensor_turns import Turns, turns_of
from codegen.model.system import System
from codegen.model.vehicle import Quantity
from codegen.targets.firmware.readings.sensed import CountView, count_view, numbered
from codegen.targets.firmware.readings.summing import CLOCK_MASK
from codegen.targets.firmware.words import ConstantView, Layout, age_word
from codegen.targets.imports import LINE_LENGTH, either_import, import_lines
from codegen.targets.naming import prose, quoted
from codegen.targets.source_files import module_name

_CLOCK = "_CLOCK"


@dataclass(frozen=True, slots=True)
class GivenView:
    """The value that one instance of a quantity takes from a sensor: the ``place`` of the output among its values.

    ``word`` and ``expires`` are the constants of the words that it has in the state, and ``count`` is what counts on
    with its values, or None.
    """

    quantity: Quantity
    output: Output
    place: int
    factor: Fraction
    instance: int
    word: str
    expires: str
    count: CountView | None


@dataclass(frozen=True, slots=True)
class SourceView:
    """One sensor: the lines that keep and lose its values, and the expression that makes it."""

    name: str
    attribute: str
    about: str
    counts: tuple[CountView, ...]
    gives: str
    keep: tuple[str, ...]
    lost: str
    lose: tuple[str, ...]
    made: str
    period_us: int
    uses_time: bool
    loses: bool


class ListenerView(NamedTuple):
    """A sensor that speaks by itself, and its place among all of them."""

    name: str
    place: int


@dataclass(frozen=True, slots=True)
class SourcesView:
    """The module; ``turns`` are as the main loop asks for them."""

    imports: tuple[str, ...]
    machine_imports: tuple[str, ...]
    turns: Turns
    constants: tuple[ConstantView, ...]
    sources: tuple[SourceView, ...]
    listeners: tuple[ListenerView, ...]


def sources_view(system: System, layout: Layout) -> SourcesView:
    """The view of the whole module."""
    constants: dict[str, int] = {}
    sources = tuple(_source(source, given_by(source, system, layout, constants), system) for source in system.polled)
    clocked = [source for source in system.polled if clock_is_set(source, system)]
    if clocked:
        constants[_CLOCK] = layout.blocks[CLOCK].base
    listeners = tuple(
        ListenerView(source.name, place) for place, source in enumerate(system.polled) if source.silence_ms is not None
    )
    names = {("array", "array"), ("micropython", "const")}
    names |= {(source.module, source.opened.partition("(")[0]) for source in system.polled}
    names |= {("listening", "Listener")} if listeners else set()
    names |= {("polling", "Poller")} if len(listeners) < len(sources) else set()
    names |= {("polling", "Fault")} if any(source.declared_values is not None for source in system.polled) else set()
    names |= {(module_name(source.clock_modules[0]), "set_clock") for source in clocked}
    modules = ["machine"] if any("machine." in source.opened for source in system.polled) else []
    modules.append("time")
    program = system.program
    return SourcesView(
        imports=import_lines(modules, names),
        machine_imports=either_import("turns", ["asking"], machine_code=system.spec.project.machine_code),
        turns=turns_of(system, program.control_us if program else 1000),
        constants=tuple(ConstantView(name, value) for name, value in constants.items()),
        sources=sources,
        listeners=listeners,
    )


def clock_is_set(source: Source, system: System) -> bool:
    """Return whether a sensor sets the clock of the state."""
    return source.sets_clock and CLOCK in system.components


def given_by(source: Source, system: System, layout: Layout, constants: dict[str, int]) -> list[GivenView]:
    """Return what the quantities of the state take from a sensor; the words of these are added to the constants."""
    places, at = {}, 0
    for output in source.outputs:
        places[output.name] = at
        at += output.storage.words
    found = []
    for component in system.components.values():
        block = layout.blocks[component.name]
        bases = {basis.quantity.name: basis for basis in component.counted_on}
        for quantity in component.quantities.values():
            for instance, (name, output, factor) in enumerate(quantity.derivation.gives):
                if name != source.name:
                    continue
                words = [quantity.attribute, *([age_word(quantity)] if quantity.ages else [])]
                shown = [numbered(block.constant(word), component.name, instance, layout) for word in words]
                for word, constant in zip(words, shown, strict=True):
                    constants[constant] = layout.places(component.name, word)[instance]
                basis = bases.get(quantity.name)
                count = None if basis is None else count_view(basis, instance, layout, constants)
                place = places[output.name]
                found.append(GivenView(quantity, output, place, factor, instance, shown[0], shown[-1], count))
    return sorted(found, key=lambda given: given.count is not None)  # products are of the newest values


def _source(source: Source, given: list[GivenView], system: System) -> SourceView:
    polling = source.polling
    keep = list(_keep(source, given, sets_clock=clock_is_set(source, system)))
    lose = [line for each in given for line in _losing(each)]
    after = _listed(
        dict.fromkeys(
            f"{each.quantity.path} after {each.quantity.trust.invalid_after}"
            for each in given
            if each.quantity.trust.invalid_after is not None
        )
    )
    functions = f"(words, _keep_{source.name}, _lose_{source.name})"
    arguments = [quoted(source.name), source.opened, functions]
    arguments += [str(polling.limit_us), str(polling.retry_ms), quoted(source.cause), "log"]
    maker = "Poller"
    if source.silence_ms is not None:
        maker, arguments = "Listener", [str(source.silence_ms), *arguments]
    cited = f" ({polling.citation})" if polling.citation else ""
    return SourceView(
        name=source.name,
        attribute=f"self.{source.name}",
        about=prose(polling.spec.doc or source.words()).rstrip(".") + cited,
        counts=tuple(each.count for each in given if each.count is not None),
        gives=_listed(dict.fromkeys(each.quantity.path for each in given)),
        keep=tuple(keep) or ("pass",),
        lost=f"Forget what failures in a row make unknown: {after}." if lose else "Failures make nothing unknown.",
        lose=tuple(lose) or ("pass",),
        made=_call(maker, arguments),
        period_us=polling.period_us,
        uses_time=any(each.quantity.ages for each in given),
        loses=bool(lose),
    )


def _listed(paths: Iterable[str]) -> str:
    """The quantities, or how many they are where one line has no room."""
    text = ", ".join(paths) or "nothing"
    return text if len(text) < 70 else f"{len(text.split(', '))} quantities"


def _call(maker: str, arguments: list[str]) -> str:
    """A call as the formatter prints it in a method."""
    inside = ", ".join(arguments)
    if len(inside) + len(maker) + 30 <= LINE_LENGTH:
        return f"{maker}({inside})"
    lines = [_broken(argument) for argument in arguments]
    return f"{maker}(\n            " + ",\n            ".join(lines) + ",\n        )"


def _broken(argument: str) -> str:
    """One argument of such a call; one that has arguments itself has a line for each where one has no room."""
    if len(argument) + 13 <= LINE_LENGTH or not argument.endswith(")"):
        return argument
    maker, _, inside = argument.removesuffix(")").partition("(")
    parts, depth, start = [], 0, 0
    for at, letter in enumerate(inside):
        depth += (letter in "([") - (letter in ")]")
        if letter == "," and not depth:
            parts.append(inside[start:at].strip())
            start = at + 1
    parts.append(inside[start:].strip())
    return f"{maker}(\n                " + ",\n                ".join(parts) + ",\n            )"


def _keep(source: Source, given: list[GivenView], *, sets_clock: bool) -> Iterator[str]:
    """Put all values into their words; where not all of them are new at once, those that are."""
    behind = sum(output.storage.words for output in source.outputs)
    if source.declared_values is not None:
        yield f"if len(values) != {source.declared_values}:"
        yield f'    raise Fault(f"has {{len(values)}} values, and {source.declared_values} are declared")'
    if not source.tells_new:
        for each in given:
            yield from _keeping(each, keeps_limits=source.keeps_limits)
        return
    mask = behind + (4 if source.sets_clock else 0)
    yield f"new = values[{mask}]"
    for each in given:
        yield f"if new & {1 << source.outputs.index(each.output)}:"
        yield from indented(list(_keeping(each, keeps_limits=source.keeps_limits)))
    if sets_clock:
        yield f"if new & {1 << len(source.outputs)}:"
        yield f"    set_clock(words, {_CLOCK}, values, {behind})"


def _keeping(given: GivenView, *, keeps_limits: bool) -> Iterator[str]:
    """Put one value into its words; what is unknown or cannot be makes the quantity unknown."""
    quantity, output = given.quantity, given.output
    unit = output.unit.name
    what = f"{output.name or quantity.name}{f' [{unit}]' if unit else ''}"
    yield f"value = values[{given.place}]  # {what}"
    if output.storage is not Storage.SMALL:
        put = [f"words[{given.word}] = value"]
        if keeps_limits:
            known = ["if value != _UNKNOWN:"]
            more = range(1, output.storage.words)
            put += [f"words[{given.word} + {half}] = values[{given.place + half}]" for half in more]
        else:
            known = list(_plausible_halves(given))
            put.append(f"words[{given.word} + 1] = above{'' if output.low >= 0 else ' & 0xFFFF'}")
    else:
        known = [f"if {_plausible(output, keeps_limits=keeps_limits)}:"]
        put = list(_scaled(given, output))
        if given.count is not None:
            put += [f"{given.count.name}(words, value, now_ms)", f"words[{given.word}] = value"]
    yield from known
    yield from indented(put)
    if quantity.ages:
        back = (1 << 30) - (quantity.trust.stale_after_ms or 0)
        yield f"    words[{given.expires}] = now_ms - {back} & {CLOCK_MASK}  # in {quantity.trust.stale_after_ms} ms"
    yield "else:"
    yield from indented(list(_unknown(given)))


def _plausible_halves(given: GivenView) -> Iterator[str]:
    """Ask whether a number of 32 bits in halves is within its limits, without making a number of them.

    The upper half may have its sign or not. What is no half, in the first place, is unknown as well.
    """
    output = given.output
    upper = f"values[{given.place + 1}]"
    yield f"above = {upper} & 0xFFFF" if output.low >= 0 else f"above = ({upper} & 0xFFFF ^ 0x8000) - 0x8000"
    (least, low), (most, high) = divmod(output.low, 1 << 16), divmod(output.high, 1 << 16)
    yield f"is_enough = 0 <= value <= 0xFFFF and (above > {least} or (above == {least} and value >= {low}))"
    yield f"if is_enough and (above < {most} or (above == {most} and value <= {high})):"


def _plausible(output: Output, *, keeps_limits: bool) -> str:
    if keeps_limits and (output.low, output.high) == (-SMALL_INT_MAX, SMALL_INT_MAX):
        return "value != _UNKNOWN"
    return f"{output.low} <= value <= {output.high}"


def _scaled(given: GivenView, output: Output) -> Iterator[str]:
    """Put ``value`` times a factor, to the nearest, a half away from zero, without a product beyond 30 bits."""
    numerator, denominator = given.factor.numerator, given.factor.denominator
    word = f"words[{given.word}]" if given.count is None else "value"
    times = "" if numerator == 1 else f" * {numerator}"
    if denominator == 1:
        if given.count is None or times:
            yield f"{word} = value{times}"
        return
    half = denominator // 2
    product = f"value // {denominator}{times} + (value % {denominator}{times} + {half}) // {denominator}"
    if output.low >= 0:
        yield f"{word} = {product}"
        return
    yield "if value < 0:"
    yield "    value = -value"
    yield f"    {word} = -({product})"
    yield "else:"
    yield f"    {word} = {product}"


def _unknown(given: GivenView) -> Iterator[str]:
    """Make a quantity unknown, or what it is initially."""
    quantity = given.quantity
    initial = quantity.initial
    if initial is None:
        yield f"words[{given.word}] = _UNKNOWN"
        if quantity.ages:
            yield f"words[{given.expires}] = _UNKNOWN"
        yield from (f"{word} = _UNKNOWN" for word in (given.count.lost if given.count else ()))
        return
    assert not isinstance(initial, str)
    halves = (int(initial),) if quantity.storage is Storage.SMALL else quantity.storage.split(int(initial))
    for at, half in enumerate(halves):
        yield f"words[{given.word}{f' + {at}' if at else ''}] = {half}"


def _losing(given: GivenView) -> Iterator[str]:
    lasting = given.quantity.trust.invalid_after
    if lasting is not None:
        yield f"if failures >= {lasting}:"
        yield from indented(list(_unknown(given)))
