"""Views of what is estimated after a good reading, by curves of points."""

from collections.abc import Iterator

from codegen.frozen import dataclass
from codegen.model.vehicle import Reading
from codegen.targets.firmware.words import Block, curve_constant


@dataclass(frozen=True, slots=True)
class EstimateView:
    """An estimate by what a reading measures: its word and its name, and the curve as a constant with its ``text``.

    ``place`` is behind the constant where each instance has a curve of its own. ``gone`` is the word that tells whether
    the component is gone, where the estimate begins anew with another one.
    """

    name: str
    word: str
    gone: str | None
    constant: str
    text: str
    several: bool

    def curve_of(self, instance: str) -> str:
        """Return the expression of the curve of an instance."""
        return f"{self.constant}[{instance}]" if self.several else self.constant


def estimate_views(reading: Reading, block: Block) -> Iterator[EstimateView]:
    """Yield the estimates that follow what ``reading`` measures, in order."""
    component = reading.component
    several = component.instances > 1
    for quantity in reading.given:
        curves = quantity.derivation.curves_by_instance
        if not curves:
            continue
        yield EstimateView(
            name=quantity.name,
            word=block.constant(quantity.attribute),
            gone=block.constant("gone") if quantity.spec.restarts_with else None,
            constant=curve_constant(quantity, component),
            text=repr(curves if several else curves[0]),
            several=several,
        )
