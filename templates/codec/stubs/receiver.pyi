"""The half of a link that receives."""

from collections.abc import Iterable, Iterator

from .message import Message
from .signing import Signing

class Receiver:
    refused: int
    unknown: int
    crc_errors: int
    def __init__(
        self, messages: Iterable[type[Message] | Message] = (), signing: Signing | None = None, size: int = ...
    ) -> None: ...
    @property
    def received(self) -> int: ...
    @property
    def signed(self) -> int: ...
    @property
    def dropped(self) -> int: ...
    def feed(self, data: bytes | bytearray | memoryview | None) -> Iterator[Message]: ...
