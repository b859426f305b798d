"""Inputs are judged in children: none is lost, whatever becomes of the child, and none meets what many others left."""

import os

from fuzzing.children import in_children

SEEN: list[int] = []


def squared(number: int) -> int:
    """Return the square of a number, but for two numbers that end the process."""
    SEEN.append(number)
    if number in (0, 4):
        os._exit(7)
    return number * number


def count(number: int) -> tuple[int, int]:
    """Return a process and how many numbers it has been given."""
    SEEN.append(number)
    return os.getpid(), len(SEEN)


def test_each_number_has_its_result() -> None:
    """The two that end their child have none, and what was left of their batches is judged nevertheless."""
    found = dict(in_children(squared, iter([range(4), range(4, 6), range(6, 7)]), jobs=2))
    assert found == {0: None, 1: 1, 2: 4, 3: 9, 4: None, 5: 25, 6: 36}


def test_a_child_has_one_batch() -> None:
    """And this process has none."""
    SEEN.clear()
    found = dict(in_children(count, iter([range(3), range(3, 5)]), jobs=1))
    assert [number for _, number in found.values()] == [1, 2, 3, 1, 2]
    assert len({process for process, _ in found.values()} - {os.getpid()}) == 2
    assert not SEEN


def test_a_batch_is_asked_for_when_a_child_is_free() -> None:
    """The one who asks may say meanwhile that the time is over."""
    asked: list[int] = []

    def batches():
        for number in range(3):
            asked.append(number)
            yield range(number, number + 1)

    told = in_children(squared, batches(), jobs=1)
    assert next(told) == (0, None)
    assert asked == [0]
