"""Statements that count on what readings sum up to: the sum over time, what it leaves, and how long that lasts."""

from codegen.model.code.payload_code import UNKNOWN, indented
from codegen.model.quantities.basis import Basis
from codegen.model.quantities.summed import RADIX, Lasting, Rest, Sum
from codegen.model.vehicle import Quantity
from codegen.targets.firmware.messages.payload import SpelledCode
from codegen.targets.firmware.readings.sum_words import full_word, rest_words

CLOCK_MASK = "0x3FFFFFFF"
"""Ticks are counted in 30 bits: boards count them so, and 64-bit interpreters further."""


def begun(quantity: Quantity, code: SpelledCode) -> list[str]:
    """Begin a sum anew."""
    owner, rests = quantity.component, rest_words(quantity)
    return [
        f"{code.word(owner, quantity.attribute)} = 0",
        *(f"{code.word(owner, word)} = {at}" for word, at in rests.items()),
    ]


def summed(reading: Basis, code: SpelledCode) -> list[str]:
    """Count on with a good reading, which is in ``value`` and not yet stored, at ``now_ms``."""
    owner, quantity = reading.component.name, reading.quantity
    before = code.word(owner, quantity.attribute)
    lines = []
    if reading.sums:
        since, stale_ms = code.word(owner, reading.word("since_ms")), quantity.trust.stale_after_ms
        lines += [
            f"# A reading stands for the time since the last; more than {stale_ms} ms, or an unknown one, is a gap.",
            f"took = now_ms - {since} & {CLOCK_MASK}",
            f"if took > {stale_ms} or {before} == {code.unknown()}:",
            "    took = 0",
            f"{since} = now_ms & {CLOCK_MASK}",
            "took = value * took",
        ]
    for each in reading.sums:
        assert each.derivation.sums is not None
        lines += _sum(each, each.derivation.sums, reading, code)
    for each in reading.given:
        if each.derivation.remains:
            lines += _left(each, each.derivation.remains, reading, code)
    for each in reading.given:
        if each.derivation.lasts:
            lines += _lasting(each, each.derivation.lasts, reading, code)
    return lines


def _sum(quantity: Quantity, found: Sum, reading: Basis, code: SpelledCode) -> list[str]:
    owner = quantity.component
    word = code.word(owner, quantity.attribute)
    start = [f"if {word} == {code.unknown()}:", *indented(begun(quantity, code))]
    cited = f" ({quantity.citation})" if quantity.citation else ""
    head = f"# {quantity.path}: {found.parts} parts are a step, and what is less is kept{cited}."
    if found.times is None:
        (rest,) = (code.word(owner, name) for name in rest_words(quantity))
        carried = [f"part = took + {rest}", f"{rest} = part % {found.parts}"]
        carried.append(f"part = {code.number_of(word)} + part // {found.parts}")
        return [head, *start, *carried, *_limited("part", quantity), f"{word} = part"]
    multiplied = code.word(owner, reading.component.quantities[found.times].attribute)
    times = code.number_of(multiplied)
    factor = f"({times})" if " " in times else times  # code may set one that is below 0
    low, middle, high = (code.word(owner, name) for name in rest_words(quantity))
    last = found.parts // RADIX // RADIX
    lines = [
        *start,
        f"part = took % {RADIX} * {factor} + {low}",
        f"{low} = part % {RADIX}",
        f"part = part // {RADIX} + {middle}",
        f"part += took // {RADIX} % {RADIX} * {factor}",
        f"{middle} = part % {RADIX}",
        f"part = part // {RADIX} + {high}",
        f"part += took // {RADIX * RADIX} * {factor}",
        f"{high} = part % {last}",
        f"part = {code.number_of(word)} + part // {last}",
        *_limited("part", quantity),
        f"{word} = part",
    ]
    return [head, f"if {multiplied} != {code.unknown()}:", *indented(lines)]


def _limited(name: str, quantity: Quantity) -> list[str]:
    least, most = int(quantity.minimum), int(quantity.maximum)
    return [f"if {name} > {most}:", f"    {name} = {most}", f"if {name} < {least}:", f"    {name} = {least}"]


def _left(quantity: Quantity, rest: Rest, reading: Basis, code: SpelledCode) -> list[str]:
    owner = quantity.component
    word, full = code.word(owner, quantity.attribute), code.word(owner, full_word(rest))
    after = code.number_of(code.word(owner, reading.component.quantities[rest.after].attribute))
    size = full if rest.steps == 1 else f"({full} * {rest.steps})"
    most = rest.full.maximum * rest.steps
    cited = f" ({quantity.citation})" if quantity.citation else ""
    lines = [
        f"# {quantity.path}: what {rest.after} leaves of {rest.full.name}{cited}.",
        f"part = {size} - {f'({after})' if ' ' in after else after}",
        "if part < 0:",
        "    part = 0",
        f"if part > {size}:",
        f"    part = {size}",
    ]
    told = [] if rest.share is None else [f"part = (part * {rest.share} + {size} // 2) // {size}"]
    told += _most("part", quantity) if (most if rest.share is None else rest.share) > quantity.maximum else []
    return [*lines, f"if not {full}:", f"    {word} = {UNKNOWN}", "else:", *indented([*told, f"{word} = part"])]


def _lasting(quantity: Quantity, lasting: Lasting, reading: Basis, code: SpelledCode) -> list[str]:
    owner, quantities = quantity.component, reading.component.quantities
    word, mean = code.word(owner, quantity.attribute), code.word(owner, f"{quantity.name}_mean")
    before = code.word(owner, quantities[lasting.at].attribute)
    left = code.word(owner, quantities[lasting.left].attribute)
    number = code.number_of(mean)
    cited = f" ({quantity.citation})" if quantity.citation else ""
    first, second = lasting.factors(quantities[lasting.left].derivation.remains)
    found = [f"part = {left} * {first} // part", *_most("part", quantity), f"{word} = part"]
    if second != 1:  # the product with all of the factor may be no small integer
        found = [
            f"{word} = {left} * {first} // part",
            f"if {word} > {int(quantity.maximum) // second}:",
            f"    {word} = {int(quantity.maximum) // second}",
            f"part = {word} * {second} + {left} * {first} % part * {second} // part",
            *_most("part", quantity),
            f"{word} = part",
        ]
    # Rounded down, a mean of many readings would stay below what is drawn for ever.
    parts = lasting.smooth_steps * lasting.readings
    new = "value" if lasting.smooth_steps == 1 else f"value * {lasting.smooth_steps}"
    return [
        f"# {quantity.path}: {lasting.left} at the mean of {lasting.at}; unknown while nothing is drawn{cited}.",
        f"part = {number}",
        f"if {before} == {code.unknown()}:",
        f"    part = value * {parts}",
        f"part += {new} - (part + {lasting.readings // 2}) // {lasting.readings}",
        f"{mean} = part",
        f"part = (part + {parts // 2}) // {parts}",
        f"if part <= 0 or {left} == {code.unknown()}:",
        f"    {word} = {UNKNOWN}",
        "else:",
        *indented(found),
    ]


def _most(name: str, quantity: Quantity) -> list[str]:
    return [f"if {name} > {int(quantity.maximum)}:", f"    {name} = {int(quantity.maximum)}"]
