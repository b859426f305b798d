"""Checks of the resolved system: one module each, a pure function from the system to its findings."""

from collections.abc import Callable, Iterator

from codegen.diagnostics import Diagnostic
from codegen.model.system import System
from codegen.rules import full_scale, lifecycle, live_float, protocol, small_int, stream_rate

RULES: tuple[Callable[[System], Iterator[Diagnostic]], ...] = (
    full_scale.check,
    lifecycle.check,
    live_float.check,
    protocol.check,
    small_int.check,
    stream_rate.check,
)
"""The checks in the order of their names. To add one, write its module and list it here."""
