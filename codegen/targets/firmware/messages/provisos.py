"""The condition under which other fields of a received message say that one is no value, in both kinds of code."""

from collections.abc import Iterator

from codegen.model.reception import Proviso
from codegen.targets.firmware.messages.wire_numbers import Plain, number_of


def broken(provisos: tuple[Proviso, ...], code: Plain) -> str:
    """Return the condition that one of them does not hold: flags are looked at by bytes, numbers have two at most."""
    ways = [way for each in provisos for way in _ways(each, code)]
    return ways[0] if len(ways) == 1 else " or ".join(f"({way})" if " and " in way else way for way in ways)


def _ways(proviso: Proviso, code: Plain) -> Iterator[str]:
    """Yield conditions of which one is met where it does not hold."""
    if not proviso.is_of_flags:
        read = number_of(proviso.field, proviso.field.offset, code)
        tests = [f"{read} {'==' if proviso.is_denied else '!='} {number}" for number in proviso.numbers]
        if proviso.is_denied:
            yield from tests
        else:
            yield " and ".join(tests)
    elif proviso.is_denied:
        for mask in proviso.numbers:
            yield " and ".join(f"wire[{at}] & 0x{part:X} == 0x{part:X}" for at, part in _bytes(proviso, mask))
    else:
        wanted = 0
        for mask in proviso.numbers:
            wanted |= mask
        for at, part in _bytes(proviso, wanted):
            yield f"wire[{at}] & 0x{part:X} != 0x{part:X}"


def _bytes(proviso: Proviso, mask: int) -> Iterator[tuple[int, int]]:
    """Yield the bytes of the payload that a mask looks at, each with its part of it."""
    for at, part in enumerate(mask.to_bytes(proviso.field.type.size, "little")):
        if part:
            yield proviso.field.offset + at, part
