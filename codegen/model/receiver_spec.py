"""``receiver.yaml``: the receiver for companion computers and ground tools."""

from collections.abc import Mapping

from codegen.frozen import dataclass
from codegen.model.described import Amount, described
from codegen.source import Written


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
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: units, views, age, interpreters, wire.", default_factory=dict
    )

    ASPECTS = ("units", "views", "age", "interpreters", "wire")
