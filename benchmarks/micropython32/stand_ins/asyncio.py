"""Coroutines as tasks, as far as the firmware uses them: this port has the queue of asyncio in C, but not the rest.

A board has all of asyncio in its flash. The names are those of MicroPython's asyncio; what the mocks replace is here
called `core`, as there.
"""

import sys
from _asyncio import Task, TaskQueue
from time import ticks_add, ticks_diff
from time import ticks_ms as ticks

core = sys.modules[__name__]  # cur_task and _task_queue are what the queue in C looks for here


class CancelledError(BaseException):
    """A task was cancelled."""


class IOQueue:
    """Waits for the next task; there are no streams."""

    def __init__(self):
        """Have nothing to wait for."""

    def wait_io_event(self, milliseconds):
        """Let time pass."""
        end = ticks_add(ticks(), milliseconds)
        while ticks_diff(end, ticks()) > 0:
            pass


class _Pause:
    """The object that sleep_ms() waits for, the same each time: a task that sleeps leaves nothing on the heap."""

    def __iter__(self):
        return self

    def __next__(self):
        if self.until is None:
            raise StopIteration
        _task_queue.push(cur_task, self.until)
        self.until = None


_pause = _Pause()


def sleep_ms(milliseconds):
    """Wait; other tasks run meanwhile."""
    _pause.until = ticks_add(ticks(), max(0, milliseconds))
    return _pause


def create_task(coroutine):
    """Let a coroutine run beside the others; return its task."""
    task = Task(coroutine, globals())
    _task_queue.push(task)
    return task


def new_event_loop():
    """Forget all tasks."""
    global _task_queue, _io_queue, cur_task  # noqa: PLW0603  there is one loop
    _task_queue = TaskQueue()
    _io_queue = IOQueue()
    cur_task = None


def run(coroutine):
    """Run a coroutine, and its tasks, until it ends; return what it returns."""
    global cur_task  # noqa: PLW0603
    main = create_task(coroutine)
    while True:
        _wait()
        task = cur_task = _task_queue.pop()
        problem = task.data
        task.data = None
        try:
            if problem:
                task.coro.throw(problem)
            else:
                task.coro.send(None)
        except BaseException as end:
            if task is main:
                if isinstance(end, StopIteration):
                    return end.value
                raise
            if not isinstance(end, (Exception, CancelledError)):  # a reset ends the program
                raise
            _finish(task, end)


def _wait():
    delay = 1
    while delay > 0:
        task = _task_queue.peek()
        delay = max(0, ticks_diff(task.ph_key, ticks())) if task else -1
        _io_queue.wait_io_event(delay)
        if delay < 0:
            raise RuntimeError("no task can go on")


def _finish(task, end):
    """Wake who waits for a task; a task that nobody waits for may end, or be cancelled, but not fail."""
    waiting = task.state
    task.data = end
    task.state = False
    if waiting is True:
        if not isinstance(end, (StopIteration, CancelledError)):
            sys.print_exception(end, sys.stderr)
    elif waiting:
        while waiting.peek():
            _task_queue.push(waiting.pop())


new_event_loop()
