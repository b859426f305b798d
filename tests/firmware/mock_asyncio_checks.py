"""asyncio on the virtual clock: time passes only while all tasks wait, and then at once."""

import mock_time

mock_time.install()

import mock_asyncio  # noqa: E402  the clock comes first

mock_asyncio.install()

import asyncio  # noqa: E402

from checks import run  # noqa: E402

HOUR = 3600


def elapsed_by(coroutine):
    """Return the microseconds that a coroutine takes."""
    start = mock_time.elapsed_us()
    asyncio.run(coroutine)
    return mock_time.elapsed_us() - start


def sleep_takes_virtual_time():
    mock_time.set_ticks_us(0)

    async def sleeps():
        await asyncio.sleep_ms(1)
        await asyncio.sleep(2)
        await asyncio.sleep_ms(HOUR * 1000)
        await asyncio.sleep_ms(0)
        await asyncio.sleep_ms(-5)

    assert elapsed_by(sleeps()) == 1000 + 2000000 + HOUR * 1000000


def tasks_wake_up_in_order():
    mock_time.set_ticks_us(0)
    seen = []

    async def every(milliseconds, times):
        for _ in range(times):
            await asyncio.sleep_ms(milliseconds)
            seen.append((mock_time.elapsed_us() // 1000, milliseconds))

    async def main():
        await asyncio.gather(every(30, 3), every(50, 2), every(7, 4))

    assert elapsed_by(main()) == 100000
    assert [time for time, _ in seen] == [7, 14, 21, 28, 30, 50, 60, 90, 100], seen
    assert [period for _, period in seen] == [7, 7, 7, 7, 30, 50, 30, 30, 50], seen


def work_takes_time_too():
    mock_time.set_ticks_us(0)
    seen = []

    async def works():
        for _ in range(3):
            mock_time.sleep_us(2500)
            await asyncio.sleep_ms(0)

    async def main():
        task = asyncio.create_task(works())
        await asyncio.sleep_ms(4)
        seen.append(mock_time.elapsed_us())
        await task

    asyncio.run(main())
    assert seen[0] in (5000, 7500), seen  # whose turn is first at 5000 is up to the interpreter


def boards_wake_up_where_the_milliseconds_change():
    for start, expected in ((0, 2000), (1, 1999), (999, 1001)):
        mock_time.set_ticks_us(start)
        assert elapsed_by(asyncio_sleep_ms(2)) == expected


async def asyncio_sleep_ms(milliseconds):
    await asyncio.sleep_ms(milliseconds)


def wrap_of_the_ticks_is_nothing_special():
    for start in ((1 << 30) - 500, (1 << 30) * 1000 - 500):
        mock_time.set_ticks_us(start)
        assert elapsed_by(asyncio_sleep_ms(10)) // 1000 in (9, 10)


def events_and_locks_work():
    mock_time.set_ticks_us(0)
    seen = []

    async def waits(event):
        await event.wait()
        seen.append(mock_time.elapsed_us())

    async def main():
        event = asyncio.Event()
        task = asyncio.create_task(waits(event))
        await asyncio.sleep_ms(20)
        event.set()
        await asyncio.sleep_ms(1)
        assert seen == [20000], seen
        await task
        lock = asyncio.Lock()
        async with lock:
            seen.append(mock_time.elapsed_us())

    asyncio.run(main())
    assert seen == [20000, 21000], seen


def tasks_are_cancelled_and_time_out():
    mock_time.set_ticks_us(0)
    seen = []

    async def sleeps():
        try:
            await asyncio.sleep_ms(HOUR * 1000)
        except asyncio.CancelledError:
            seen.append("cancelled")
            raise

    async def main():
        task = asyncio.create_task(sleeps())
        await asyncio.sleep_ms(5)
        task.cancel()
        await asyncio.sleep_ms(1)
        try:
            await asyncio.wait_for(sleeps(), 3)
        except asyncio.TimeoutError:  # noqa: UP041 - MicroPython has no other
            seen.append("late")

    elapsed = elapsed_by(main())
    assert seen == ["cancelled", "cancelled", "late"], seen
    assert elapsed // 1000 == 3006, elapsed


def hook_is_told_how_long_nothing_happens():
    mock_time.set_ticks_us(0)
    told = []

    def hook(duration_us):
        told.append((mock_time.elapsed_us(), duration_us))

    async def main():
        await asyncio.sleep_ms(20)
        await asyncio.sleep_ms(30)

    mock_asyncio.on_wait(hook)
    try:
        asyncio.run(main())
    finally:
        mock_asyncio.on_wait(None)
    assert [each for each in told if each[1]] == [(0, 20000), (20000, 30000)], told
    number = len(told)
    asyncio.run(main())
    assert len(told) == number


def hook_may_leave_out_what_it_is_not_due_for():
    """Calls with 0 right behind a wait, before its time, and no others."""
    mock_time.set_ticks_us(0)
    told = []

    async def main():
        for _ in range(4):
            await asyncio.sleep_ms(10)

    mock_asyncio.on_wait(lambda duration_us: told.append((mock_time.elapsed_us(), duration_us)))
    mock_asyncio.leave_out_until(30000)
    try:
        asyncio.run(main())
    finally:
        mock_asyncio.on_wait(None)
    assert [each for each in told if each[1]] == [(at, 10000) for at in (0, 10000, 20000, 30000)], told
    assert {at for at, duration_us in told if not duration_us and at} >= {30000, 40000}, told
    assert not {10000, 20000} & {at for at, duration_us in told if not duration_us}, told


def failures_come_out():
    async def fails():
        await asyncio.sleep_ms(1)
        raise ValueError("as it was")

    try:
        asyncio.run(fails())
    except ValueError:
        return
    raise AssertionError("a task that fails has to be seen")


run(
    sleep_takes_virtual_time,
    tasks_wake_up_in_order,
    work_takes_time_too,
    boards_wake_up_where_the_milliseconds_change,
    wrap_of_the_ticks_is_nothing_special,
    events_and_locks_work,
    tasks_are_cancelled_and_time_out,
    hook_is_told_how_long_nothing_happens,
    hook_may_leave_out_what_it_is_not_due_for,
    failures_come_out,
)
