"""View of board.py: how each measured component is read."""

from collections.abc import Mapping
from dataclasses import dataclass

from codegen.model.spec import AdcSpec
from codegen.model.system import AdcChannel, System
from codegen.targets.naming import prose


@dataclass(frozen=True, slots=True)
class ReaderView:
    """The ADC channel of one component: ``shift`` turns the 16 bits of read_u16() into counts.

    ``spare_bits`` are the bits of the 12 bit converter that a count leaves out.
    """

    component: str
    gpio: int
    shift: int
    spare_bits: int
    full_scale: int
    samples: int
    half: int
    read_limit_us: int | None
    citation: str
    cited: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class BoardView:
    """The board and its readers."""

    board: str
    mcu: str
    readers: tuple[ReaderView, ...]
    is_timed: bool


def board_view(system: System) -> BoardView:
    """The view of the whole module."""
    readers = [
        _reader(component, quantity.conversion.channel)
        for component, quantity in system.measured()
        if quantity.conversion is not None
    ]
    is_timed = any(reader.read_limit_us is not None for reader in readers)
    return BoardView(
        board=prose(system.spec.board.board),
        mcu=prose(system.spec.board.mcu),
        readers=tuple(readers),
        is_timed=is_timed,
    )


def _reader(component: str, channel: AdcChannel) -> ReaderView:
    return ReaderView(
        component=component,
        gpio=channel.gpio,
        shift=16 - channel.bits,
        spare_bits=12 - channel.bits,
        full_scale=channel.full_scale,
        samples=channel.samples,
        half=channel.samples // 2,
        read_limit_us=channel.read_limit_us,
        citation=channel.cited("samples"),
        cited={aspect: channel.cited(aspect) for aspect in AdcSpec.ASPECTS},
    )
