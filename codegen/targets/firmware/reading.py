"""Statements that take a reading over into the words of a component, and forget one that has become too old."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.model.payload_code import ELEMENT, UNKNOWN, each_element, indented
from codegen.model.vehicle import Component, Quantity, Returns, Threshold
from codegen.targets.firmware.payload import SpelledCode
from codegen.targets.firmware.words import TREND_WORDS, age_word, differ, measured_of

CLOCK_MASK = "0x3FFFFFFF"
"""Ticks are counted in 30 bits: boards count them so, and 64-bit interpreters further."""

FIRST, RETURNED, ABOVE, GOOD = 1, 2, 4, 8
"""What a reading gives cause to tell: bits of what the function returns."""


WAITING = -1000000000
"""The count of an instance that the board is being asked about."""


def expires(component: Component) -> bool:
    """Whether a reading of it can become too old."""
    measured = measured_of(component)
    return measured is not None and measured.trust.stale_after_ms is not None


def expiry(component: Component, code: SpelledCode, now: str, age: str) -> list[str]:
    """Forget the last reading where it is too old by the time ``now``, in ms; ``age`` is the variable for how old."""
    measured = measured_of(component)
    assert measured is not None
    cited = _cited(measured.cited("stale_after"))
    expires = code.word(component.name, "expires_ms")
    return [
        f"# A reading is forgotten once it is older than {measured.trust.stale_after_ms} ms{cited}.",
        f"if {code.number_of(expires)} != {UNKNOWN}:",
        f"    {age} = {now} - {expires} & {CLOCK_MASK}",
        f"    if {age} > 0 and {age} < 0x20000000:",
        *indented([*forgotten(component, code), f"{expires} = {UNKNOWN}"], 2),
    ]


def forgetting(quantity: Quantity, code: SpelledCode, now: str, age: str) -> list[str]:
    """Forget what code has set where that was too long ago by the time ``now``, in ms; ``age`` is a variable."""
    expires = code.word(quantity.component, age_word(quantity))
    cited = _cited(quantity.cited("stale_after"))
    element = ELEMENT if quantity.elements else ""
    forget = [f"{code.half(quantity, 0, element)} = {UNKNOWN}"]
    forget = each_element(0, quantity.elements[0], forget) if quantity.elements else forget
    return [
        f"# {quantity.path} is forgotten {quantity.trust.stale_after_ms} ms after it was set{cited}.",
        f"if {code.number_of(expires)} != {UNKNOWN}:",
        f"    {age} = {now} - {expires} & {CLOCK_MASK}",
        f"    if {age} > 0 and {age} < 0x20000000:",
        *indented([*forget, f"{expires} = {UNKNOWN}"], 2),
    ]


def forgotten(component: Component, code: SpelledCode) -> list[str]:
    """Make everything that is measured unknown."""
    lines = []
    for quantity in component.quantities.values():
        if quantity.derivation.comes_of_readings:
            lines.append(f"{code.word(component.name, quantity.attribute)} = {UNKNOWN}")
        if quantity.derivation.kept_readings:
            lines += [f"{code.word(component.name, f'{quantity.name}_{word}')} = 0" for word in TREND_WORDS]
    return lines


def taken(component: Component, code: SpelledCode) -> list[str]:
    """Take over the count that stands in its word, at ``now_ms``; one that cannot be is a failed reading.

    What there is to tell is in ``told``. The value is unknown afterwards, or the one that ``changed`` goes on with.
    """
    measured = measured_of(component)
    assert measured is not None
    conversion, threshold, lasting = (
        measured.derivation.conversion,
        measured.derivation.threshold,
        measured.trust.invalid_after,
    )
    assert conversion is not None
    name, full_scale = component.name, conversion.channel.full_scale
    value = code.word(name, measured.attribute)
    failures = code.word(name, "failures")
    failed = [f"{failures} = {failures} + 1"]
    if lasting:
        failed += [f"if {failures} >= {lasting}:", *indented(forgotten(component, code))]
    numerator, denominator = conversion.numerator, conversion.denominator
    good = [
        f"value = count * {code.word(name, 'multiplier')}",
        f"value = {_product(numerator, denominator)}",
        f"{value} = value",
        f"{failures} = 0",
    ]
    if measured.trust.stale_after_ms is not None:
        later = f"now_ms - {(1 << 30) - measured.trust.stale_after_ms} & {CLOCK_MASK}"  # a sum may be no small integer
        good.append(f"{code.word(name, 'expires_ms')} = {later}  # in {measured.trust.stale_after_ms} ms")
    logged = code.word(name, "is_logged")
    good += [f"if {logged} == 0:", f"    {logged} = 1", f"    told = {FIRST}"]
    if any(quantity.derivation.curves_by_instance for quantity in component.quantities.values()):
        good.append(f"told |= {GOOD}")
    if component.returns:
        good += _returned(component, component.returns, code)
    if threshold is not None:
        good += _above(measured, threshold, code)
    lasts = _until(lasting) + _cited(measured.cited("invalid_after"))
    head = f"# count / {full_scale} * reference * multiplier, rounded to nearest ({measured.citation or name})."
    return [
        "told = 0",
        f"count = {code.number_of(code.word(name, 'count'))}",
        f"if count < 0 or count > {full_scale}:",
        f"    # A failed reading keeps the last value{lasts}.",
        *indented(failed),
        "else:",
        *indented([head, *good]),
    ]


def changed(component: Component, code: SpelledCode) -> list[str]:
    """Take the value into the trend, where there is one; not for a value that is unknown."""
    measured = measured_of(component)
    trend = next((quantity for quantity in component.quantities.values() if quantity.derivation.kept_readings), None)
    return [] if trend is None or measured is None else list(_trend(trend, measured, component, code))


def known(component: Component, code: SpelledCode) -> str:
    """The condition that the measured value is known."""
    measured = measured_of(component)
    assert measured is not None
    return f"{code.number_of(code.word(component.name, measured.attribute))} != {UNKNOWN}"


def _until(failures: int | None) -> str:
    return "" if failures is None else f"; {failures} in a row make it unknown"


def _cited(criterion: str) -> str:
    return f" ({criterion})" if criterion else ""


def _product(numerator: int, denominator: int) -> str:
    """``value * numerator / denominator`` for a positive value, rounded to nearest, without a product of all three."""
    whole = f"value // {denominator}" + (f" * {numerator}" if numerator != 1 else "")
    rest = f"value % {denominator}" + (f" * {numerator}" if numerator != 1 else "")
    return f"{whole} + ({rest} + {denominator // 2}) // {denominator}" if denominator != 1 else f"value * {numerator}"


def _returned(component: Component, returns: Returns, code: SpelledCode) -> Iterator[str]:
    """Count that something has come back, and let what was counted for the last one begin anew."""
    name = component.name
    gone, counted = code.word(name, "gone"), code.word(name, returns.count.attribute)
    cited = _cited(str(returns.count.citation or ""))
    yield f"# Whether it is {returns.gone.name}; another one may have been put in{cited}."
    yield "is_gone = 0"
    source, condition = code.condition(returns.gone)
    assert source
    yield f"if {condition}:"
    yield "    is_gone = 1"
    yield f"if {gone} and is_gone == 0:"
    yield f"    told |= {RETURNED}"
    yield f"    if {code.number_of(counted)} == {UNKNOWN}:"
    yield f"        {counted} = 0"
    yield f"    {counted} = {counted} + 1"
    for quantity in returns.restarting:
        word = code.word(name, quantity.attribute)
        if quantity.initial is None:
            yield f"    if {code.number_of(word)} != {UNKNOWN}:"
            yield f"        {word} = 0"
        else:
            yield f"    {word} = {quantity.initial}"
    yield f"{gone} = is_gone"


def _above(measured: Quantity, threshold: Threshold, code: SpelledCode) -> Iterator[str]:
    """Warn of a value above a threshold, and then not for a while."""
    name, limits = measured.component, threshold.above
    warned = code.word(name, "warned_ms")
    limit = str(limits[0]) if not differ(limits) else code.number_of(code.word(name, "warn_above"))
    words = f"# Above {limit if limit.isdigit() else 'its limit'} a warning is due, unless there was one just now"
    yield f"{words}{_cited(measured.cited('warn_above'))}."
    yield f"since = {code.number_of(warned)}"
    yield f"if since != {UNKNOWN} and now_ms - since & {CLOCK_MASK} >= {threshold.every_ms or 0}:"
    yield f"    {warned} = {UNKNOWN}"
    yield f"if value > {limit} and {code.number_of(warned)} == {UNKNOWN}:"
    yield f"    {warned} = now_ms & {CLOCK_MASK}"
    yield f"    told |= {ABOVE}"


def _trend(trend: Quantity, measured: Quantity, component: Component, code: SpelledCode) -> Iterator[str]:
    """The newer half of the readings against the older one; a failed reading counts the last value once more."""
    assert component.period_ms is not None
    name, readings = component.name, trend.derivation.kept_readings
    half = readings // 2
    count, newer, older = (code.word(name, f"{trend.name}_{word}") for word in TREND_WORDS)
    word = code.word(name, trend.attribute)
    scale = Fraction(1000, half * half * component.period_ms)
    cited = _cited(str(trend.citation or ""))
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
