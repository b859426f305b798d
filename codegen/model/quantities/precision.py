"""The precision with which a number is kept, or told: which of its values stand for one that is expected."""

from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.code.storage import Storage

_SHARES = {Storage.BINARY32: Fraction(1, 2**23), Storage.BINARY64: Fraction(1, 2**51)}
"""The share of a float of that size that it may be off by, after a rounding or two."""


@dataclass(frozen=True, slots=True)
class Precision:
    """Numbers in a unit that are multiples of ``step`` (0: of none), each off by a ``share`` of it at most."""

    step: Fraction = Fraction(0)
    share: Fraction = Fraction(0)

    def exact(self, found: float | Fraction) -> Fraction:
        """Return the multiple that a double stands for: 12.6 V in mV are 12600 of them; all else as it is."""
        value = Fraction(found)
        return round(value / self.step) * self.step if self.step and isinstance(found, float) else value

    def is_same(self, found: float | Fraction, wanted: Fraction) -> bool:
        """Return whether ``found`` is the number nearest to ``wanted`` that there is."""
        exact = self.exact(found)
        return abs(exact - wanted) <= self.step / 2 + self._slack(found, exact)

    def is_between(self, found: float | Fraction, low: Fraction, high: Fraction) -> bool:
        """Return whether ``found`` lies between two numbers, or is one of them."""
        exact = self.exact(found)
        slack = self._slack(found, exact)
        return low - slack <= exact <= high + slack

    def _slack(self, found: float | Fraction, exact: Fraction) -> Fraction:
        share = max(self.share, _SHARES[Storage.BINARY64]) if isinstance(found, float) else self.share
        return abs(exact) * share


def kept_with(storage: Storage, steps: Fraction) -> Precision:
    """Return the precision of what is kept so, ``steps`` to a unit."""
    return Precision(share=share_of(storage)) if storage.is_float else Precision(1 / steps)


def share_of(storage: Storage) -> Fraction:
    """Return the share of a float by which it may be off; 0 for whole numbers."""
    return _SHARES.get(storage, Fraction(0))
