"""What a quantity of the state comes from, and when it is unknown, in words: for documents, pages and explain."""

from codegen.model.unit import decimal
from codegen.model.vehicle import Quantity
from codegen.targets.table import limit_text


def quantity_source(quantity: Quantity) -> str:
    """What gives a quantity its value."""
    conversion = quantity.conversion
    if conversion is not None:
        channel = conversion.channel
        gpio = channel.pin.name if channel.pin else channel.gpio
        formula = f"count / {channel.full_scale} * {decimal(channel.reference)} V * {conversion.multiplier.name}"
        return f"GPIO {gpio}: {formula}"
    if quantity.spec.counts_returns_of:
        return f"counts when {quantity.component}.{quantity.spec.counts_returns_of} ends"
    if quantity.spec.restarts_with:
        return f"set by the vehicle; anew with {quantity.component}.{quantity.spec.restarts_with}"
    if quantity.while_known:
        return f"while {quantity.component}.{quantity.while_known} is known"
    if quantity.follows:
        return f"while {quantity.component}.{quantity.followed} is {limit_text(quantity)}"
    if quantity.enabled_by:
        return f"while {quantity.enabled_by.name} is not 0"
    if quantity.trend:
        return f"change of {quantity.component}.{quantity.trend.quantity} over {quantity.trend.readings} readings"
    if quantity.estimate:
        return f"discharge curve by {quantity.component}.{quantity.estimate.quantity}"
    return "set by the vehicle"


def becomes_unknown(quantity: Quantity) -> str:
    """When a quantity that was measured is no longer known; nothing where that does not happen by itself."""
    causes = []
    if quantity.spec.invalid_after is not None:
        causes.append(f"after {quantity.spec.invalid_after} failed readings in a row")
    if quantity.stale_after_ms is not None:
        causes.append(f"{quantity.stale_after_ms} ms after the last good one")
    return ", or ".join(causes)
