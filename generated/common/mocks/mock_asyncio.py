# Generated from templates/mocks/mock_asyncio.py: do not edit.
# Inputs: b8545c9928eb798a
"""Lets asyncio run on the clock of mock_time: while all tasks wait, the clock goes on to the first that is due.

A program calls install() after mock_time.install() and before it makes a task. MicroPython keeps its own asyncio, with
another clock and another wait; where MICROPYPATH is set, it has to have ".frozen" in it, or asyncio is not found.
"""

import asyncio
import sys

import mock_time

_LATER_MS = 1 << 24  # five hours: the queue in C asks the host's clock when tasks are due at once: ours is ahead of it

_hooks = []
_quiet = [False, 0]  # whether nothing has run since hooks were called; until when they need not be asked then


def install():
    """Take the place of the clock and of the waiting; nothing may be running."""
    if sys.implementation.name == "micropython":
        _install_micropython()
    else:
        _install_cpython()


def on_wait(hook):
    """Call `hook` with the microseconds for which no task is due, before the clock skips them; 0: one is due now.

    A simulator waits here for the true time to catch up. None takes all hooks away.
    """
    if hook is None:
        _hooks.clear()
    else:
        _hooks.append(hook)
    leave_out_until(0)


def leave_out_until(due_us):
    """Do not call hooks with 0 right behind a wait, while mock_time.elapsed_us() is less than this."""
    _quiet[1] = due_us


def _wait(duration_us):
    if duration_us:
        for hook in _hooks:
            hook(duration_us)
        mock_time.advance_us(duration_us)
        _quiet[0] = True
        return
    is_quiet = _quiet[0] and mock_time.elapsed_us() < _quiet[1]
    _quiet[0] = False
    if not is_quiet:
        for hook in _hooks:
            hook(0)


def _until_us(milliseconds):
    """Return the microseconds to where ticks_ms() is so much more, which is when boards wake up."""
    return milliseconds * 1000 - mock_time.elapsed_us() % 1000


def _install_micropython():
    core = asyncio.core
    words = mock_time.words
    fast = mock_time.machine_code
    host = mock_time.host_time
    started = [0, 0]  # when the loop was made: milliseconds of the host's clock, of ours

    class VirtualQueue(core.IOQueue):
        """The queue of tasks that wait for streams, in which MicroPython waits for time as well: a loop makes one."""

        def __init__(self):
            core_init(self)
            if not hasattr(self, "map"):  # nobody says whether tasks wait for streams
                self.map = (None,)
            started[0] = host.ticks_add(host.ticks_ms(), _LATER_MS)
            started[1] = mock_time.elapsed_us() // 1000
            if fast is not None:
                fast.start_ms = started[0] - words[4]

        def wait_io_event(self, milliseconds):
            if milliseconds < 0:  # only streams can go on
                _wait(0)
                core_wait(self, 1)
                return
            _wait(1000 * milliseconds - words[2] if milliseconds > 0 else 0)  # see _until_us()
            if self.map:
                core_wait(self, 0)

    core_init = core.IOQueue.__init__
    core_wait = core.IOQueue.wait_io_event
    core.ticks = lambda: host.ticks_add(started[0], mock_time.elapsed_us() // 1000 - started[1])
    if fast is not None:
        core.ticks = fast.loop_ms
    core.ticks_add = host.ticks_add
    core.ticks_diff = host.ticks_diff
    core.IOQueue = VirtualQueue
    core.new_event_loop()


def _install_cpython():
    import selectors  # noqa: PLC0415 - MicroPython has none

    class VirtualSelector(selectors.DefaultSelector):
        """Does not wait but moves the clock, unless a stream is ready."""

        def select(self, timeout=None):
            if timeout is None:  # only streams can go on
                _wait(0)
                return super().select(0.001)
            ready = super().select(0)
            _wait(0 if ready else max(0, round(timeout * 1000000)))
            return ready

    class VirtualLoop(asyncio.SelectorEventLoop):
        """The event loop of the virtual clock."""

        def __init__(self):
            super().__init__(VirtualSelector())
            self._clock_resolution = 1e-6

        def time(self):
            return mock_time.elapsed_us() / 1000000

    async def sleep_ms(milliseconds):
        await asyncio.sleep(_until_us(milliseconds) / 1000000 if milliseconds > 0 else 0)

    asyncio.sleep_ms = sleep_ms
    asyncio.new_event_loop = asyncio.events.new_event_loop = VirtualLoop
