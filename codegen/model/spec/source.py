"""``sources`` of ``board.yaml``, as written: what every kind of sensor has. The rest stands in the folder of each."""

from collections.abc import Mapping
from typing import ClassVar

from codegen.frozen import dataclass
from codegen.model.spec.described import Amount, Verbatim, described
from codegen.source import Written


@dataclass(frozen=True, slots=True, kw_only=True)
class SourceSpec(Written):
    """A sensor: its ``driver`` decides what else is written about it (``codegen/sources/``)."""

    CHOSEN_BY: ClassVar[str] = "driver"
    ASPECTS: ClassVar[tuple[str, ...]] = ("rate", "limit", "range", "failure", "recovery", "texts")

    driver: str = described("The kind of sensor: adc, ina219, ina226, nmea, pulse, user, or a file of specs/drivers.")
    doc: str | None = described("What it is, for people.", default=None)
    rate: Amount | None = described("How often it is asked, such as 10 Hz. Default: that of the driver.", default=None)
    limit: Amount | None = described(
        "Longest time that it may take each time, such as 2 ms; what takes longer is counted and told.", default=None
    )
    retry: Amount | None = described(
        "Time between two attempts to set it up again after it failed, such as 1 s.", default=None
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: rate, limit, range, failure, recovery, texts.", default_factory=dict
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class OwnSourceSpec(SourceSpec):
    """A sensor with a driver of the project's own: ``specs/drivers/`` has a file about it, which declares its keys."""

    REST: ClassVar[str] = "keys"

    keys: Mapping[str, Verbatim] = described("What the driver declares: key and value.", default_factory=dict)
