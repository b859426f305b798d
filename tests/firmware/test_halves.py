"""Numbers in halves of 16 bits: the conditions of the firmware say the same as arithmetic, for every type and limit."""

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from codegen.answers.halves import float_within, next_float
from codegen.model.answers.scaling import Scaling
from codegen.model.code.halves import above, below, beyond, equal
from codegen.model.code.storage import Storage, storage_of
from codegen.model.spec.population import Rounding

INTEGERS = (Storage.INT32, Storage.UINT32, Storage.INT64, Storage.UINT64)
FLOATS = (Storage.BINARY32, Storage.BINARY64)


@st.composite
def pairs(draw: st.DrawFn) -> tuple[Storage, Fraction, Fraction]:
    """A storage, and two numbers that it holds: often close together, equal, or with equal halves."""
    storage = draw(st.sampled_from((*INTEGERS, *FLOATS)))
    if storage.is_float:
        floats = st.floats(width=16 * storage.halves, allow_nan=False, allow_infinity=False)
        first = Fraction(draw(floats))
        second = draw(st.one_of(floats.map(Fraction), st.just(first), st.just(-first)))
        return storage, first, second
    low, high = (int(limit) for limit in storage.limits)
    first = draw(st.integers(low, high))
    near = st.sampled_from((0, 1, -1, 0x10000, -0x10000, 1 << 31, -(1 << 31))).map(lambda step: first + step)
    second = draw(st.one_of(st.integers(low, high), near.filter(lambda value: low <= value <= high)))
    return storage, Fraction(first), Fraction(second)


def holds(condition: str, value: Fraction, storage: Storage) -> bool:
    """Return the value of the condition for a number, as the firmware reads it."""
    split = storage.split(float(value) if storage.is_float else int(value))
    return said(condition, {f"half{at}": half for at, half in enumerate(split)})


def said(condition: str, halves: dict[str, int]) -> bool:
    """Return the value of the condition for these halves."""
    return bool(eval(condition, dict(halves)))  # noqa: S307  the generator's own text


@given(pairs())
def test_conditions_say_what_arithmetic_says(pair: tuple[Storage, Fraction, Fraction]):
    """More, less and equal, of whole numbers with and without a sign and of floats."""
    storage, value, limit = pair
    halves = [f"half{at}" for at in range(storage.halves)]
    exact = limit if storage.is_float else int(limit)
    assert holds(above(halves, exact, storage), value, storage) == (value > limit)
    assert holds(below(halves, exact, storage), value, storage) == (value < limit)
    assert holds(equal(halves, exact, storage), value, storage) == (value == limit)


@given(pairs(), st.integers(0, 2**64 - 1))
def test_beyond_is_outside_of_both_limits(pair: tuple[Storage, Fraction, Fraction], bits: int):
    """With two limits or one, whatever the highest half says alone."""
    storage, value, limit = pair
    halves = [f"half{at}" for at in range(storage.halves)]
    other = limit * Fraction(bits, 2**64) if not storage.is_float else -limit
    low, high = sorted((limit, other if storage.is_float else Fraction(int(other))))
    exact = [bound if storage.is_float else int(bound) for bound in (low, high)]
    assert holds(beyond(halves, exact[0], exact[1], storage), value, storage) == (not low <= value <= high)
    assert holds(beyond(halves, exact[0], None, storage), value, storage) == (value < low)
    assert holds(beyond(halves, None, exact[1], storage), value, storage) == (value > high)


def test_a_negative_zero_is_a_zero():
    """Neither more nor less than 0, and equal to it."""
    halves = {"half0": 0, "half1": 0x8000}
    names = list(halves)
    assert said(equal(names, 0, Storage.BINARY32), halves)
    assert not said(below(names, 0, Storage.BINARY32), halves)
    assert not said(above(names, 0, Storage.BINARY32), halves)


@given(st.floats(width=32, allow_nan=False, allow_infinity=False, max_value=2.0**126))
def test_the_next_float_is_the_next_one(value: float):
    """None lies between."""
    found = float(next_float(Fraction(value), Storage.BINARY32))
    assert found > value
    between = Storage.BINARY32.held((value + found) / 2)
    assert between in (value, found)


@pytest.mark.parametrize("storage", FLOATS)
def test_limits_of_floats_lie_within_what_is_written(storage: Storage):
    """1/10 is no float: the limits are the floats next to it, on the inner side; beside 0 is the least normal one."""
    scaling = float_within(Scaling(Fraction(1), Rounding.NEAREST, Fraction(-1, 10), Fraction(1, 10)), 0.0, storage)
    assert Fraction(-1, 10) <= scaling.low < 0 < scaling.high <= Fraction(1, 10)
    assert next_float(scaling.high, storage) > Fraction(1, 10)
    assert scaling.hole == 0
    assert scaling.beside == Fraction(1, 1 << {Storage.BINARY32: 126, Storage.BINARY64: 1022}[storage])


@pytest.mark.parametrize(
    ("low", "high", "storage"),
    [
        (-(2**30) + 1, 2**30 - 1, Storage.SMALL),
        (-(2**30), 0, Storage.INT32),
        (0, 2**31, Storage.UINT32),
        (-1, 2**31, Storage.INT64),
        (0, 2**63, Storage.UINT64),
        (-1, 2**63, None),
    ],
)
def test_the_smallest_storage_is_taken(low: int, high: int, storage: Storage | None):
    """Words are few on a board."""
    assert storage_of(low, high) == storage


def test_a_float_is_split_into_its_bits():
    """1.0 is 0x3F800000."""
    assert Storage.BINARY32.split(1.0) == (0, 0x3F80)
    assert math.isinf(2 * float(Storage.BINARY64.limits[1]))
