"""One end of a MAVLink connection."""

from collections.abc import Iterable

from .message import Message
from .receiver import Receiver
from .sender import Sender, Stream
from .signing import Signing

class Link(Sender, Receiver):
    def __init__(
        self,
        stream: Stream | None,
        system_id: int = 1,
        component_id: int = 1,
        version: int = 2,
        messages: Iterable[type[Message] | Message] = (),
        longest: int = ...,
        signing: Signing | None = None,
    ) -> None: ...
