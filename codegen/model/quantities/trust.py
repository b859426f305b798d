"""Thresholds of warnings about a value, and the time after which it is no longer believed."""

from codegen.frozen import dataclass


@dataclass(frozen=True, slots=True)
class Threshold:
    """``above`` these values, in stored units and by instance, a warning is logged, every ``every_ms`` at most."""

    above: tuple[int, ...]
    every_ms: int | None


@dataclass(frozen=True, slots=True)
class Trust:
    """The events after which a value is no longer believed, and so unknown; None: never for that reason.

    ``invalid_after`` counts failed readings in a row, ``stale_after_ms`` is the age of the last good one,
    or of what code has set.
    """

    invalid_after: int | None
    stale_after_ms: int | None

    def words(self, since: str = "the last good one") -> str:
        """Return when that happens, for people; nothing where it does not happen by itself."""
        causes = []
        if self.invalid_after is not None:
            causes.append(f"after {self.invalid_after} failed readings in a row")
        if self.stale_after_ms is not None:
            causes.append(f"{self.stale_after_ms} ms after {since}")
        return ", or ".join(causes)
