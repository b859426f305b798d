"""Views of what state.py does with readings: how they are converted, and what is told about them."""

from collections.abc import Iterator, Mapping

from codegen.frozen import dataclass
from codegen.model.spec.state import QuantitySpec
from codegen.model.units.unit import decimal, unit_named
from codegen.model.vehicle import Component, Parameter, Reading
from codegen.targets.firmware.readings.reading import ABOVE, FIRST, RETURNED
from codegen.targets.firmware.readings.sum_words import fulls
from codegen.targets.firmware.words import Block, differ, factor_words
from codegen.targets.naming import family_constant, parameter_expression


@dataclass(frozen=True, slots=True)
class MeasuredView:
    """The conversion of an ADC count to a component's quantity, and the log texts about its readings.

    ``formula`` is for people, in its unit, with the names adc, mult and offset, the ``taken`` of which are arguments.
    ``set_up`` are the words of its factors with the expressions of their steps by instance, ``followed`` those that
    change while the program runs; ``is_set`` is the word that says that code sets it, or "". What is calibrated is
    ``plain``: ``own_name`` is the expression of its parameter's name, and its steps stand in the word ``multiplier``.
    """

    name: str
    word: str
    unit: str
    formula: str
    taken: str
    citation: str
    plain: bool
    multiplier_name: str
    multiplier: str
    own_name: str
    set_up: tuple[tuple[str, str], ...]
    followed: tuple[tuple[str, str], ...]
    warn_text: str
    invalid_after: int | None
    stale_after_ms: int | None
    prefers: str
    is_set: str
    cited: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class TellView:
    """A log call, as arguments of the generated Python, for a reading whose result has a bit set."""

    bit: int
    text: str


@dataclass(frozen=True, slots=True)
class FurtherView:
    """A reading behind the first of a component, as state.py and board.py know it: its module, and when it is wanted.

    ``wanted`` is the condition on the parameters, "" for always.
    """

    name: str
    wanted: str


def unreadable(component: Component, further: str = "") -> str:
    """The text about a board that raises, as a literal of the generated Python."""
    what = f"'s {further}" if further else ""
    if component.instances == 1:
        return f'"error: the board cannot read the {component.name}{what}:"'
    return f'f"error: the board cannot read {component.name} {{instance + 1}}{what}:"'


def further_view(reading: Reading, parameters: str) -> FurtherView:
    """The view of a further reading; ``parameters`` is the expression for them."""
    when = reading.conversion.channel.when
    if when is None:
        return FurtherView(reading.name, "")
    switch, steps = when
    if switch.siblings:
        each = f"getattr({parameters}, each) == {steps}"
        return FurtherView(reading.name, f"any({each} for each in {family_constant(switch)})")
    return FurtherView(reading.name, f"{parameter_expression(switch, parameters)} == {steps}")


def texts_of(reading: Reading, measured: MeasuredView) -> Iterator[TellView]:
    """Yield what a reading can give cause to tell: that it is the first, that
    something came back, that it is too high.
    """
    component = reading.component
    name, several = component.name, component.instances > 1
    number, mark = (" {instance + 1}", "f") if several else ("", "")
    yield TellView(FIRST, f'f"{name}{number}: {measured.name} {{value:.2f}} {measured.unit}"')
    if reading.returns:
        yield TellView(RETURNED, f'{mark}"notice: {name.capitalize()}{number} connected"')
    if measured.warn_text:
        owner = f"{name}{number}'s" if several else f"the {name}'s"
        text = f"warning: {owner} {measured.name} is above {measured.warn_text}:"
        yield TellView(ABOVE, f'{"f" if "{" in text else ""}"{text}", value')


def measured_view(reading: Reading, block: Block, parameters: str = "self.parameters") -> MeasuredView:
    """The view of a reading; ``parameters`` is the expression for them."""
    quantity, conversion, component = reading.quantity, reading.conversion, reading.component
    threshold, multiplier = quantity.derivation.threshold, conversion.multiplier
    warn_text = ""
    if threshold is not None:
        text = decimal(threshold.above[0] / quantity.steps)
        if differ(threshold.above):
            word = block.constant(reading.word("warn_above"))
            owner = "self" if reading.is_first else "state"
            text = f"{{{owner}.{component.name}_words[instance][{word}] / {decimal(quantity.steps)}}}"
        warn_text = f"{text} {quantity.unit.name}"
    factors = [
        (block.constant(reading.word(word)), factor)
        for word, factor in factor_words(reading)
        if isinstance(factor, Parameter)
    ]
    set_up = [(word, parameter_expression(factor, parameters)) for word, factor in factors]
    followed = [pair for pair, (_, factor) in zip(set_up, factors, strict=True) if not factor.spec.reboot]
    sizes = [(block.constant(word), one) for word, one in fulls(reading).items()]
    shown = [(word, parameter_expression(one, parameters)) for word, one in sizes]
    set_up += shown
    followed += [pair for pair, (_, one) in zip(shown, sizes, strict=True) if not one.spec.reboot]
    formula, taken = _formula(reading)
    return MeasuredView(
        name=quantity.name,
        word=block.constant(quantity.attribute),
        unit=quantity.unit.name,
        formula=formula,
        taken=taken,
        citation=str(quantity.citation or ""),
        plain=conversion.is_plain,
        multiplier_name=multiplier.name,
        multiplier=block.constant(reading.word("multiplier")) if conversion.is_plain else "",
        own_name=_own_name(multiplier.name, multiplier.siblings),
        set_up=tuple(set_up),
        followed=tuple(followed),
        warn_text=warn_text,
        invalid_after=quantity.trust.invalid_after,
        stale_after_ms=quantity.trust.stale_after_ms,
        prefers=quantity.derivation.prefers or "",
        is_set=block.constant(reading.word("is_set")) if quantity.derivation.represented else "",
        cited={aspect: quantity.cited(aspect) for aspect in QuantitySpec.ASPECTS},
    )


def _formula(reading: Reading) -> tuple[str, str]:
    """The formula for people with the arguments that it takes: a parameter is one, in its unit."""
    quantity, conversion = reading.quantity, reading.conversion
    channel, multiplier, offset = conversion.channel, conversion.multiplier, conversion.offset
    text, taken = f"adc / {channel.full_scale} * {decimal(channel.reference)}", ["adc"]
    scale = multiplier.unit.scale * unit_named("V").scale / quantity.unit.scale
    if isinstance(multiplier, Parameter):
        taken.append("mult")
    if isinstance(offset, Parameter):
        taken.append("offset")
        scaled = offset.unit.scale / unit_named("V").scale
        text = f"({text} - offset{'' if scaled == 1 else f' * {decimal(scaled)}'})"
    elif offset is not None:
        text = f"({text} - {decimal(offset.value * offset.unit.scale / unit_named('V').scale)})"
    if isinstance(multiplier, Parameter):
        text = f"{text} * mult{'' if scale == 1 else f' * {decimal(scale)}'}"
    else:
        text = f"{text} * {decimal(multiplier.value * scale)}"
    return text, ", ".join(taken)


def _own_name(name: str, siblings: tuple[str, ...]) -> str:
    """The expression of a parameter's name; of a family that of the instance."""
    if not siblings:
        return f'"{name}"'
    names = ", ".join(f'"{sibling}"' for sibling in siblings)
    return f"({names})[instance]" if len(siblings) > 1 else f'"{siblings[0]}"'


def read_words(reading: Reading, block: Block, parameters: str) -> Iterator[tuple[str, str]]:
    """The words that say whether code sets an instance, and whether a parameter lets it be read, where they can be."""
    when, enabled = reading.conversion.channel.when, reading.component.enabled
    represented = reading.quantity.derivation.represented
    if represented is not None:
        own = parameter_expression(represented.parameter, parameters)
        yield block.constant(reading.word("is_set")), f"1 if {own} == {represented.steps} else 0"
    if when is None:
        return
    switch = reading.component.switch
    is_on = "" if enabled is None or switch is when[0] else f" and words[{block.constant(enabled.attribute)}]"
    is_chosen = f"{parameter_expression(when[0], parameters)} == {when[1]}"
    if represented is not None:  # what code sets is taken as a reading, too
        is_chosen += f" or words[{block.constant(reading.word('is_set'))}]"
        is_chosen = f"({is_chosen})" if is_on else is_chosen
    yield block.constant(reading.word("is_read")), f"1 if {is_chosen}{is_on} else 0"
