"""``receiver.yaml``: the receiver for companion computers and ground tools."""

from collections.abc import Iterator, Mapping

from codegen.frozen import dataclass
from codegen.model.spec.described import Amount, described
from codegen.source import Written


@dataclass(frozen=True, slots=True, kw_only=True)
class RolesSpec(Written):
    """The fields that tell how long a store in use still lasts, by their names in whichever message has them."""

    current: tuple[str, ...] = described("The current that is drawn.", default=())
    consumed: tuple[str, ...] = described("The charge that was drawn.", default=())
    left: tuple[str, ...] = described("The charge that is left.", default=())
    percent: tuple[str, ...] = described("The charge that is left, in % of a full one.", default=())
    full: tuple[str, ...] = described("The charge of a full one.", default=())
    serial: tuple[str, ...] = described("The serial number: with another one it is another one.", default=())
    cycles: tuple[str, ...] = described(
        "How often it was charged: without a serial number, another one if that is not the same or one more.",
        default=(),
    )
    count: tuple[str, ...] = described("How many values a list of single ones has, such as cells.", default=())
    counted_anew: bool = described(
        "true: what was drawn counts from 0 with another one, so a fall to less than a tenth of at least 10 mAh says "
        "that it is another one; a restart of the sender looks the same.",
        default=False,
    )
    charging: tuple[str, ...] = described("Entries of enums that say that it is being charged.", default=())

    def fields(self) -> Iterator[tuple[str, tuple[str, ...]]]:
        """Each role and its fields."""
        for name in ("current", "consumed", "left", "percent", "full", "serial", "cycles", "count"):
            yield name, getattr(self, name)


@dataclass(frozen=True, slots=True, kw_only=True)
class ReceiverSpec(Written):
    """``receiver.yaml``: for which component a receiver is made, and how long it trusts what it heard."""

    component: str = described("Component of the state whose messages are turned back into quantities.")
    stale_after: Amount = described(
        "Time without a message after which nothing is known any more, such as 10 s.", default=Amount("10 s")
    )
    rate_over: Amount = described(
        "Time over which the current is averaged for the time that remains, such as 30 s.", default=Amount("30 s")
    )
    roles: RolesSpec | None = described(
        "Fields that tell how long something lasts; without them nobody computes it.", default=None
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: units, views, age, interpreters, wire.", default_factory=dict
    )

    ASPECTS = ("units", "views", "age", "interpreters", "wire")
