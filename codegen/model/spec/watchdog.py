"""The watchdog that vehicle.yaml asks for."""

from collections.abc import Mapping

from codegen.frozen import dataclass
from codegen.model.spec.described import Amount, described
from codegen.source import Written


@dataclass(frozen=True, slots=True, kw_only=True)
class WatchdogSpec(Written):
    """The watchdog of vehicle.yaml: it resets the board when the main loop stands still."""

    timeout: Amount = described(
        "How long the main loop may stand still, such as 2 s: at least 1 s, and what the board's watchdog can do."
    )
    requirement: str | None = described("Requirement, or criterion of one, that asks for it.", default=None)
    criteria: Mapping[str, str] = described(
        "Criteria for single aspects: hung (what stands still is reset), fed (by what, and what does not keep it from "
        "that), told (the reason of the last reset).",
        default_factory=dict,
    )

    ASPECTS = ("hung", "fed", "told")
