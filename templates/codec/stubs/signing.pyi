"""Signatures of MAVLink 2."""

from collections.abc import Callable, Collection
from typing import Any

class Signing:
    key: bytes
    link_id: int
    timestamp: int
    unsigned: Collection[int]
    accepted: int
    def __init__(
        self,
        key: bytes,
        link_id: int = 0,
        timestamp: int = 0,
        clock: Callable[[], float] = ...,
        unsigned: Collection[int] = ...,
        streams: int = 16,
    ) -> None: ...
    def renew(self, key: bytes, timestamp: int = 0) -> None: ...
    def save(self, path: str) -> None: ...

def load(path: str, **options: Any) -> Signing: ...
