"""View of what is counted of the values of a sensor: what they sum up to, as with the readings of an ADC."""

from dataclasses import dataclass as changing
from typing import NamedTuple

from codegen.model.quantities.basis import Basis
from codegen.model.vehicle import Quantity
from codegen.targets.firmware.messages.payload_plain import PlainCode
from codegen.targets.firmware.readings.reading import forgetting
from codegen.targets.firmware.readings.summing import CLOCK_MASK, summed
from codegen.targets.firmware.words import Layout, age_word


@changing(slots=True)
class SensedCode(PlainCode):
    """Plain Python, with a constant for each word of one instance in the array."""

    instance: int = 0

    def subscript(self, component: str, place: str) -> str:
        """The constant has the number of the instance, where there are several."""
        return f"words[{numbered(place, component, self.instance, self.layout)}]"

    def constants(self) -> dict[str, int]:
        """Return the constants that were spelled, with their places in the array."""
        return {
            numbered(self.layout.blocks[owner].constant(word), owner, self.instance, self.layout): self.layout.places(
                owner, word
            )[self.instance]
            for owner, words in self.words.items()
            for word in sorted(words)
        }


def numbered(constant: str, component: str, instance: int, layout: Layout) -> str:
    """The name of a constant, with the number of the instance where there are several."""
    several = layout.blocks[component].component.instances > 1
    return f"{constant}_{instance + 1}" if several else constant


class CountView(NamedTuple):
    """The function that counts on with each value, and the ``lost`` words, which are unknown while the value is."""

    name: str
    counted: str
    lines: tuple[str, ...]
    lost: tuple[str, ...]


def count_view(basis: Basis, instance: int, layout: Layout, constants: dict[str, int]) -> CountView:
    """The view for one instance; the words that it takes are added to the constants."""
    code = SensedCode(layout, basis.component.name, instance=instance)
    owner, quantities = basis.component.name, basis.component.quantities
    lines = []
    looked_at = [each.derivation.sums.times for each in basis.sums if each.derivation.sums]
    if any(each.derivation.lasts for each in basis.given):
        looked_at.append(basis.quantity.name)  # a mean begins anew where it has been forgotten
    for name in dict.fromkeys(filter(None, looked_at)):
        if quantities[name].ages:
            lines += forgetting(quantities[name], code, "now_ms")
    lines += summed(basis, code)
    lost = []
    for each in basis.given:
        lost += [code.word(owner, each.attribute), *([code.word(owner, age_word(each))] if each.ages else [])]
        if each.ages:
            lines.append(_until(each, code))
    constants |= code.constants()
    return CountView(
        name=f"_count_{numbered(f'{owner}_{basis.quantity.name}', owner, instance, layout)}",
        counted=", ".join(each.name for each in (*basis.sums, *basis.given)),
        lines=tuple(lines),
        lost=tuple(lost),
    )


def _until(quantity: Quantity, code: SensedCode) -> str:
    """Say until when it is believed, as long as the value that it comes of."""
    stale_ms = quantity.trust.stale_after_ms or 0
    word = code.word(quantity.component, age_word(quantity))
    return f"{word} = now_ms - {(1 << 30) - stale_ms} & {CLOCK_MASK}  # in {stale_ms} ms"
