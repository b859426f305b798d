"""The receiver, resolved: which messages it turns back into the quantities of which component."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from codegen.frozen import dataclass
from codegen.model.spec.receiver import ReceiverSpec
from codegen.model.vehicle import Citation, Component

if TYPE_CHECKING:
    from codegen.model.system import PopulatedMessage


@dataclass(frozen=True, slots=True)
class Receiver:
    """A receiver for the messages that are sent for each ``component``, in the order of their ids.

    After ``stale_after_ms`` without any of them an instance is stale; ``rate_over_ms`` is the time over which its
    current is averaged.
    """

    component: Component
    messages: tuple["PopulatedMessage", ...]
    stale_after_ms: int
    rate_over_ms: int
    citation: Citation | None
    aspects: Mapping[str, Citation]
    spec: ReceiverSpec
