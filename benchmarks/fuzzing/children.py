"""Judges inputs in children of this process, a few at a time: nothing that one leaves behind meets many others."""

import multiprocessing
from collections.abc import Callable, Iterator
from multiprocessing.connection import Connection, wait
from typing import TypeVar

T = TypeVar("T")

EACH = 50
"""Inputs that a child judges before the next one takes its place."""
_FORK = multiprocessing.get_context("fork")


def in_children(judge: Callable[[int], T], batches: Iterator[range], jobs: int) -> Iterator[tuple[int, T | None]]:
    """Yield each number of the batches with what ``judge`` returns for it, or None where its child ended before that.

    What is left of the batch of such a child is judged by another one. A child begins with all that this process has
    imported and keeps. The next batch is asked for when a child is free.
    """
    running: dict[Connection, list[int]] = {}
    left: list[list[int]] = []
    while True:
        while len(running) < jobs and (numbers := left.pop() if left else list(next(batches, ()))):
            told, tells = _FORK.Pipe(duplex=False)
            _FORK.Process(target=_judge_all, args=(judge, tuple(numbers), tells), daemon=True).start()
            tells.close()
            running[told] = numbers
        if not running:
            return
        for told in wait(list(running)):
            assert isinstance(told, Connection)
            numbers = running[told]
            try:
                result = told.recv()
            except EOFError:
                del running[told]
                if numbers:
                    yield numbers.pop(0), None
                if numbers:
                    left.append(numbers)
            else:
                yield numbers.pop(0), result


def _judge_all(judge: Callable[[int], T], numbers: tuple[int, ...], tells: Connection) -> None:
    for number in numbers:
        tells.send(judge(number))
    tells.close()
