"""Checks of the resolved system: one module each, a pure function from the system to its findings."""

from collections.abc import Callable, Iterator

from codegen.diagnostics import Diagnostic
from codegen.model.system import System
from codegen.rules import (
    both_generations,
    cell_room,
    enum_constant,
    full_scale,
    instance_field,
    lifecycle,
    live_float,
    overlay_flag,
    overlay_id,
    overlay_text,
    pack_full_scale,
    protocol,
    shared_pin,
    small_int,
    stale_reading,
    stream_beyond_links,
    stream_rate,
    unused_stream,
)

RULES: tuple[Callable[[System], Iterator[Diagnostic]], ...] = (
    both_generations.check,
    cell_room.check,
    enum_constant.check,
    full_scale.check,
    instance_field.check,
    lifecycle.check,
    live_float.check,
    overlay_flag.check,
    overlay_id.check,
    overlay_text.check,
    pack_full_scale.check,
    protocol.check,
    shared_pin.check,
    small_int.check,
    stale_reading.check,
    stream_beyond_links.check,
    stream_rate.check,
    unused_stream.check,
)
"""The checks in the order of their names. To add one, write its module and list it here."""
