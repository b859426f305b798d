"""Statements that take a reading over into the words of a component, and forget one that has become too old."""

from collections.abc import Iterable, Iterator
from fractions import Fraction

from codegen.model.code.payload_code import ELEMENT, UNKNOWN, each_element, indented
from codegen.model.quantities.conversion import Factor
from codegen.model.quantities.trust import Threshold
from codegen.model.vehicle import Component, Parameter, Quantity, Reading, Represented, Returns
from codegen.targets.firmware.messages.payload import SpelledCode
from codegen.targets.firmware.readings.aged import aged, all_unknown, cited_in
from codegen.targets.firmware.readings.summing import CLOCK_MASK, begun, summed
from codegen.targets.firmware.words import TREND_WORDS, age_word, differ, factor_words

FIRST, RETURNED, ABOVE, GOOD = 1, 2, 4, 8
"""The events of a reading that can be logged: bits of the function's result."""


WAITING = -1000000000
"""The count of an instance that the board is being asked about."""


def expires(component: Component) -> bool:
    """Return whether a reading of it can become too old."""
    return any(reading.expires for reading in component.readings)


def expiry(readings: Iterable[Reading], code: SpelledCode, now: str) -> list[str]:
    """Forget the last readings where they are too old by the time ``now``, in ms."""
    return [line for reading in readings for line in _expiry(reading, code, now)]


def _expiry(reading: Reading, code: SpelledCode, now: str) -> list[str]:
    if reading.quantity.trust.stale_after_ms is None:
        return []
    expires = code.word(reading.component.name, reading.word("expires_ms"))
    return [_of_age(reading), *_once_past(expires, [*forgotten(reading, code), f"{expires} = {UNKNOWN}"], code, now)]


def _of_age(reading: Reading) -> str:
    measured = reading.quantity
    what = "A reading" if reading.is_first else f"The {measured.name}"
    cited = cited_in(measured.cited("stale_after"))
    return f"# {what} is forgotten once it is older than {measured.trust.stale_after_ms} ms{cited}."


def _lost(reading: Reading, code: SpelledCode) -> list[str]:
    """Forget a reading that failed too often, or is too old: messages do that too, but nobody may build one with it.

    One that is too old counts as failed so often; where there is none, the time may be any, and nothing is forgotten.
    """
    trust = reading.quantity.trust
    if trust.invalid_after is None:
        return _expiry(reading, code, "now_ms")
    failures = code.word(reading.component.name, reading.word("failures"))
    lost = [f"if {failures} >= {trust.invalid_after}:", *indented(forgotten(reading, code))]
    if trust.stale_after_ms is not None:
        expires = code.word(reading.component.name, reading.word("expires_ms"))
        too_old = [f"if {_is_past(expires, 'now_ms')}:", f"    {failures} = {trust.invalid_after}"]
        lost = [_of_age(reading), *too_old, *lost]
    return lost


def forgetting(quantity: Quantity, code: SpelledCode, now: str) -> list[str]:
    """Forget what code has set where that was too long ago by the time ``now``, in ms."""
    expires = code.word(quantity.component, age_word(quantity))
    cited = cited_in(quantity.cited("stale_after"))
    element = ELEMENT if quantity.elements else ""
    forget = [f"{code.half(quantity, 0, element)} = {UNKNOWN}"]
    forget = each_element(0, quantity.elements[0], forget) if quantity.elements else forget
    return [
        f"# {quantity.path} is forgotten {quantity.trust.stale_after_ms} ms after it was set{cited}.",
        *_once_past(expires, [*forget, f"{expires} = {UNKNOWN}"], code, now),
    ]


def _once_past(moment: str, statements: list[str], code: SpelledCode, now: str) -> list[str]:
    """The statements where ``moment``, in ms, is known and lies before ``now``, by less than half the range of ticks.

    Without a variable for the age: functions with many of them keep all on the heap in plain Python.
    """
    return [f"if {moment} != {code.unknown()}:", f"    if {_is_past(moment, now)}:", *indented(statements, 2)]


def _is_past(moment: str, now: str) -> str:
    return f"{now} - {moment} - 1 & {CLOCK_MASK} < 0x1FFFFFFF"


def forgotten(reading: Reading, code: SpelledCode) -> list[str]:
    """Make what comes of a reading unknown."""
    return _forgotten(reading, reading.given, code)


def _forgotten(reading: Reading, quantities: Iterable[Quantity], code: SpelledCode) -> list[str]:
    lines, name = [], reading.component.name
    for quantity in quantities:
        lines.append(f"{code.word(name, quantity.attribute)} = {UNKNOWN}")
        if quantity.derivation.kept_readings:
            lines += [f"{code.word(name, f'{quantity.name}_{word}')} = 0" for word in TREND_WORDS]
    return lines


def taken(reading: Reading, code: SpelledCode, counting_on: list[str] | None = None) -> list[str]:
    """Take over the count that stands in its word, at ``now_ms``; one that cannot be is a failed reading.

    ``counting_on`` are the statements that count on what it sums up to, where these are not to stand here themselves.
    What there is to tell is in ``told``. The value is unknown afterwards, or the one that ``changed`` goes on with.
    """
    measured, conversion = reading.quantity, reading.conversion
    lasting, stale_ms = measured.trust.invalid_after, measured.trust.stale_after_ms
    name, full_scale = reading.component.name, conversion.channel.full_scale
    failures = code.word(name, reading.word("failures"))
    failed = [f"{failures} = {failures} + 1"]
    lost = _lost(reading, code)
    if measured.derivation.prefers is None:
        failed += lost
    good = [
        *_converted(reading, code),
        *(summed(reading, code) if counting_on is None else counting_on),
        f"{code.word(name, measured.attribute)} = value",
        f"{failures} = 0",
    ]
    if stale_ms is not None:
        later = f"now_ms - {(1 << 30) - stale_ms} & {CLOCK_MASK}"  # a sum may be no small integer
        good.append(f"{code.word(name, reading.word('expires_ms'))} = {later}  # in {stale_ms} ms")
    lasts = _until(lasting) + cited_in(measured.cited("invalid_after"))
    failed = [f"# A failed reading keeps the last value{lasts}.", *failed]
    following = [*_followed(reading, code)]
    if measured.derivation.represented is None:
        good += following
        following = []
    else:  # the count of what code sets is none
        failed = [*_set(reading, measured.derivation.represented, code), "else:", *indented(failed)]
        failed.append(f"    value = {UNKNOWN}")
        following = [f"if value != {UNKNOWN}:", *indented(following)]
    taking = [f"if count < 0 or count > {full_scale}:", *indented(failed), "else:", *indented(good), *following]
    return [
        *(aged(reading, code) if reading.is_first else ()),
        "told = 0",
        f"count = {code.number_of(code.word(name, reading.word('count')))}",
        *taking,
        *_preferred(reading, lost, code),
    ]


def _followed(reading: Reading, code: SpelledCode) -> Iterator[str]:
    """Yield what follows from a new ``value``."""
    threshold = reading.quantity.derivation.threshold
    logged = code.word(reading.component.name, reading.word("is_logged"))
    yield from (f"if not {logged}:", f"    {logged} = 1", f"    told = {FIRST}")
    if reading.is_estimated_from:
        yield f"told |= {GOOD}"
    if reading.returns:
        yield from _returned(reading.component, reading.returns, code)
    if threshold is not None and reading.quantity.derivation.prefers is None:
        yield from _above(reading, threshold, code)


def _set(reading: Reading, represented: Represented, code: SpelledCode) -> Iterator[str]:
    """Yield where code sets the value: ``value`` is what it has set, unless that was too long ago."""
    measured, name = reading.quantity, reading.component.name
    failures = code.word(name, reading.word("failures"))
    cited = cited_in(measured.cited("set_stale_after"))
    yield f"if {code.word(name, reading.word('is_set'))}:"
    yield f"    # Code sets it; that is forgotten {represented.stale_after_ms} ms later{cited}."
    yield f"    {failures} = {failures} + 1"
    yield f"    if {failures} > {represented.readings(reading.component)}:"
    yield f"        {code.word(name, measured.attribute)} = {UNKNOWN}"
    if reading.returns:
        yield from indented([*_gone(reading.component, reading.returns, code, sums=True)], 2)
    if lost := _forgotten(reading, [each for each in reading.given if each is not measured], code):
        yield f"    if {code.word(name, measured.attribute)} == {code.unknown()}:"  # code may say so, too
        yield from indented(lost, 2)
    yield f"    value = {code.number_of(code.word(name, measured.attribute))}"


def _preferred(reading: Reading, lost: list[str], code: SpelledCode) -> Iterator[str]:
    """Take what comes before a reading, where all of it is known; else ``lost`` is what a failed one does.

    What was counted of readings so far, such as a trend, goes on with it.
    """
    measured, name = reading.quantity, reading.component.name
    if measured.derivation.prefers is None:
        return
    listed = reading.component.quantities[measured.derivation.prefers]
    word = code.half(listed, 0, "count")
    cited = cited_in(measured.cited("stale_after"))
    yield f"# The sum of {listed.path} comes first while all of them are known{cited}."
    yield "value = 0"
    yield "count = 0"
    yield f"while count < {code.count(listed)} and {word} != {code.unknown()}:"
    yield f"    value += {code.number_of(word)}"
    yield "    count += 1"
    yield f"if count == {code.count(listed)}:"
    yield f"    {code.word(name, measured.attribute)} = value"
    if measured.trust.stale_after_ms is not None:
        later = f"now_ms - {(1 << 30) - measured.trust.stale_after_ms} & {CLOCK_MASK}"
        yield f"    {code.word(name, reading.word('expires_ms'))} = {later}"
    if reading.is_estimated_from:  # the converter may have failed
        yield f"    told |= {GOOD}"
    if lost:
        failing = code.word(name, reading.word("failures"))
        if measured.derivation.represented is not None:
            failing += f" and not {code.word(name, reading.word('is_set'))}"
        yield f"elif {failing}:"
        yield from indented(lost)
    if measured.derivation.threshold is not None:  # the limit is that of what has become the value
        yield f"value = {code.number_of(code.word(name, measured.attribute))}"
        yield f"if value != {UNKNOWN}:"
        yield from indented(list(_above(reading, measured.derivation.threshold, code)))


def _converted(reading: Reading, code: SpelledCode) -> list[str]:
    """Set ``value`` to what ``count`` stands for."""
    measured, conversion = reading.quantity, reading.conversion
    steps = [_steps(reading, word, factor, code) for word, factor in factor_words(reading)]
    cited = measured.citation or reading.name
    volts = f"count / {conversion.channel.full_scale} * reference"
    numerator, denominator = conversion.numerator, conversion.denominator
    if conversion.offset is None:
        return [
            f"# {volts} * multiplier, rounded to nearest ({cited}).",
            f"value = count * {steps[0]}",
            f"value = {_product(numerator, denominator)}",
        ]
    head = f"# ({volts} - offset) * multiplier, rounded to nearest ({cited})."
    limits = [(f"value < {conversion.low}", conversion.low), (f"value > {conversion.high}", conversion.high)]
    limited = [line for test, end in limits if end is not None for line in (f"if {test}:", f"    value = {end}")]
    numerators = (numerator, conversion.offset_numerator)
    return [head, *_difference((f"count * {steps[0]}", f"{steps[1]} * {steps[0]}"), numerators, denominator), *limited]


def _steps(reading: Reading, word: str, factor: Factor, code: SpelledCode) -> str:
    """The steps of a factor: a number, or its word."""
    if not isinstance(factor, Parameter):
        return str(factor.default)
    word = code.word(reading.component.name, reading.word(word))
    number = code.number_of(word) if factor.minimum < 0 else word
    return word if number == word else f"({number})"


def _difference(products: tuple[str, str], numerators: tuple[int, int], denominator: int) -> list[str]:
    """``value``: the difference of two products, each times its numerator, divided and rounded to nearest.

    Quotients and remainders are taken apart, so that no product of all three passes a small integer.
    """
    (count, away), (of_count, of_away) = products, numerators
    if denominator == 1:
        return [f"value = {count} * {of_count} - {away} * {of_away}"]
    half = denominator // 2
    constants = [int(text) for text in away.split(" * ") if text.lstrip("-").isdigit()]
    if len(constants) == 2:
        whole, rest = divmod(half - constants[0] * constants[1] * of_away, denominator)
        return [
            f"count = {count}",
            f"value = (count % {denominator} * {of_count} + {rest}) // {denominator}",
            f"value += count // {denominator} * {of_count} {'-' if whole < 0 else '+'} {abs(whole)}",
        ]
    return [
        f"count = {count}",
        f"away = {away}",
        f"value = (count % {denominator} * {of_count} - away % {denominator} * {of_away} + {half}) // {denominator}",
        f"value += count // {denominator} * {of_count} - away // {denominator} * {of_away}",
    ]


def changed(reading: Reading, code: SpelledCode) -> list[str]:
    """Take the value into the trend, where there is one; not for a value that is unknown."""
    return [] if reading.trend is None else list(_trend(reading.trend, reading, code))


def known(reading: Reading, code: SpelledCode) -> str:
    """The condition that the measured value is known."""
    word = code.word(reading.component.name, reading.quantity.attribute)
    return f"{word} != {code.unknown()}"


def _until(failures: int | None) -> str:
    return "" if failures is None else f"; {failures} in a row make it unknown"


def _product(numerator: int, denominator: int) -> str:
    """``value * numerator / denominator`` for a positive value, rounded to nearest, without a product of all three."""
    whole = f"value // {denominator}" + (f" * {numerator}" if numerator != 1 else "")
    rest = f"value % {denominator}" + (f" * {numerator}" if numerator != 1 else "")
    return f"{whole} + ({rest} + {denominator // 2}) // {denominator}" if denominator != 1 else f"value * {numerator}"


def _returned(component: Component, returns: Returns, code: SpelledCode) -> Iterator[str]:
    """Count that something has come back, and let what was counted for the last one begin anew."""
    name = component.name
    gone, counted = code.word(name, "gone"), code.word(name, returns.count.attribute)
    cited = cited_in(str(returns.count.citation or ""))
    yield f"# Whether it is {returns.gone.name}; another one may have been put in{cited}."
    least = returns.count.derivation.back_from
    yield f"is_gone = {gone}" if least else "is_gone = 0"
    source, condition = code.condition(returns.gone)
    assert source
    yield f"if {condition}:"
    yield "    is_gone = 1"
    if least:
        own = code.number_of(code.word(name, f"{returns.count.name}_back_from")) if differ(least) else least[0]
        yield f"if value >= {own}:"
        yield "    is_gone = 0"
    if forgotten := [*_gone(component, returns, code)]:
        yield f"if {gone} or is_gone:"
        yield from indented(forgotten)
    yield f"if {gone} and not is_gone:"
    yield f"    told |= {RETURNED}"
    yield f"    if {counted} == {code.unknown()}:"
    yield f"        {counted} = 0"
    yield f"    {counted} = {counted} + 1"
    for quantity in returns.restarting:
        word = code.word(name, quantity.attribute)
        if quantity.derivation.sums:
            yield f"    if {word} != {code.unknown()}:"
            yield from indented(begun(quantity, code), 2)
        elif not _is_forgotten(quantity):
            yield f"    {word} = {quantity.initial}"
    yield f"{gone} = is_gone"


def _gone(component: Component, returns: Returns, code: SpelledCode, *, sums: bool = False) -> Iterator[str]:
    """Forget what belonged to what is gone; ``sums``, too, where code sets these."""
    for quantity in returns.restarting:
        if _is_forgotten(quantity) or (sums and quantity.derivation.sums):
            word = code.word(component.name, quantity.attribute)
            yield from all_unknown(quantity, component, code) if quantity.elements else [f"{word} = {UNKNOWN}"]


def _is_forgotten(quantity: Quantity) -> bool:
    """Return whether it is unknown while what it belongs to is gone; sums and what
    has an initial value stay until another.
    """
    return quantity.initial is None and not quantity.derivation.sums


def _above(reading: Reading, threshold: Threshold, code: SpelledCode) -> Iterator[str]:
    """Warn of a value above a threshold, and then not for a while."""
    name, limits, measured = reading.component.name, threshold.above, reading.quantity
    warned = code.word(name, reading.word("warned_ms"))
    own = differ(limits)
    limit = code.number_of(code.word(name, reading.word("warn_above"))) if own else str(limits[0])
    words = f"# Above {limit if limit.isdigit() else 'its limit'} a warning is due, unless there was one just now"
    yield f"{words}{cited_in(measured.cited('warn_above'))}."
    yield f"since = {warned}"
    yield f"if since != {code.unknown()} and now_ms - since & {CLOCK_MASK} >= {threshold.every_ms or 0}:"
    yield f"    {warned} = {UNKNOWN}"
    yield f"if value > {limit} and {warned} == {code.unknown()}:"
    yield f"    {warned} = now_ms & {CLOCK_MASK}"
    yield f"    told |= {ABOVE}"


def _trend(trend: Quantity, reading: Reading, code: SpelledCode) -> Iterator[str]:
    """The newer half of the readings against the older one; a failed reading counts the last value once more."""
    component, measured = reading.component, reading.quantity
    assert component.period_ms is not None
    name, readings = component.name, trend.derivation.kept_readings
    half = readings // 2
    count, newer, older = (code.word(name, f"{trend.name}_{word}") for word in TREND_WORDS)
    word = code.word(name, trend.attribute)
    scale = Fraction(1000, half * half * component.period_ms)
    cited = cited_in(str(trend.citation or ""))
    ring = f"{trend.name}_readings"
    yield f"# The change per second: the sum of the newer {half} readings against that of the older ones{cited}."
    yield f"value = {code.word(name, measured.attribute)}"
    yield f"count = {count}"
    yield "at = count"
    yield f"if at >= {readings}:"
    yield f"    at -= {readings}"
    yield f"    oldest = {code.word(name, ring, 'at')}"
    yield f"    {older} = {older} - oldest"
    yield f"if count >= {half}:"
    yield f"    middle = at + {half}"
    yield f"    if middle >= {readings}:"
    yield f"        middle -= {readings}"
    yield f"    middle = {code.word(name, ring, 'middle')}"
    yield f"    {newer} = {newer} - middle"
    yield f"    {older} = {older} + middle"
    yield f"{newer} = {newer} + value"
    yield f"{code.word(name, ring, 'at')} = value"
    yield "count += 1"
    yield f"if count == {2 * readings}:"
    yield f"    count = {readings}"
    yield f"{count} = count"
    yield f"if count < {readings}:"
    yield f"    {word} = {UNKNOWN}"
    yield "else:"
    yield f"    value = {code.number_of(newer)}"
    yield f"    value -= {code.number_of(older)}"
    product = f"value * {scale.numerator}" if scale.numerator != 1 else "value"
    part = scale.denominator // 2
    yield "    if value < 0:"
    yield f"        {word} = 0 - ({part} - {product}) // {scale.denominator}"
    yield "    else:"
    yield f"        {word} = ({product} + {part}) // {scale.denominator}"
