"""The half of a link that sends."""

from collections.abc import Callable
from typing import Any, Protocol

from .message import Message
from .signing import Signing

LONGEST_PAYLOAD: int

class Stream(Protocol):
    def write(self, data: memoryview, /) -> Any: ...

class Sender:
    stream: Stream | None
    tx_errors: int
    encode: Callable[[Message], memoryview]
    sequence: int
    def __init__(
        self,
        stream: Stream | None,
        system_id: int = 1,
        component_id: int = 1,
        version: int = 2,
        longest: int = ...,
        signing: Signing | None = None,
    ) -> None: ...
    @property
    def version(self) -> int: ...
    @property
    def signing(self) -> Signing | None: ...
    def send(self, message: Message) -> Any: ...
    def send_frame(self, frame: memoryview) -> Any: ...
