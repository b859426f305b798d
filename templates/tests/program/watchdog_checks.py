"""The watchdog: what stands still is reset, what works never, and where it came from is told."""

import mock_board  # noqa: F401  the watchdog of this board, in the mocks

import asyncio
import machine
import messages
import sim_machine
import watchdog
from program_bench import FORCE_ARM, MEASURED, SECOND_US, Flash, live, main, mock_time, needs, new_craft, run
from program_facts import CONTROL_US, PARAMETERS, WATCHDOG

sim_machine.install()  # it has timers

TIMEOUT_US = WATCHDOG["timeout_ms"] * 1000
LOOK_US = WATCHDOG["look_ms"] * 1000
ABOUT_TO = "The watchdog is about to"
HAS_RESET = "The watchdog has reset"


def _for(duration_us):
    """Return a story in which time passes."""

    async def story():
        await asyncio.sleep_ms(duration_us // 1000)

    return story


def _is_reset(craft, duration_us):
    """Run a vehicle's tasks for so long; return whether the watchdog has reset the board before."""
    try:
        return live(craft, _for(duration_us))
    except machine.WatchdogReset:
        return True


def _hung():
    """Stand still for longer than any watchdog waits, which ends this."""
    while mock_time.elapsed_us() < 100 * TIMEOUT_US:
        mock_time.advance_us(1000)


def what_hangs_is_reset():
    """control(), the links, a reading, a task of the user's: at once and later, wherever one stands, time is up."""
    for after_us in (0, 3 * SECOND_US):
        for place in ("control", "links", "reading", "task"):
            if place == "reading" and not MEASURED:
                continue
            craft = new_craft()
            since = []

            def hang(*_arguments, since=since, after_us=after_us):
                if mock_time.elapsed_us() >= after_us:
                    since.append(mock_time.elapsed_us())
                    _hung()

            if place == "control":
                craft.scheduler._control.call = hang
            elif place == "links":
                craft.connections[0].run = hang
            elif place == "reading":
                setattr(craft.state, "update_" + MEASURED[0]["component"], hang)
            else:
                craft._is_due_to_save = hang  # the main task calls it
            assert _is_reset(craft, 60 * SECOND_US), (place, after_us)
            stood_us = mock_time.elapsed_us() - since[0]
            assert TIMEOUT_US - LOOK_US - SECOND_US // 10 <= stood_us <= TIMEOUT_US + 1000, (place, after_us, stood_us)


def a_dead_loop_is_reset():
    """The task of the main loop has ended, others go on: that is told, and then the board is reset."""
    craft = new_craft()

    async def ended():
        pass

    craft.scheduler.run = ended
    assert _is_reset(craft, 60 * SECOND_US)
    assert mock_time.elapsed_us() <= 2 * TIMEOUT_US + LOOK_US, mock_time.elapsed_us()
    assert [text for _, text in craft.said(ABOUT_TO)] == [ABOUT_TO + " reset the board: control stands still or fails"]


def short_stops_are_no_reason():
    """A loop that stands still again and again, for three looks each time, is not reset."""
    craft = new_craft()
    passes = [0]

    def control():
        passes[0] += 1
        if passes[0] % 10 == 0:
            mock_time.advance_us(3 * LOOK_US - CONTROL_US)

    craft.scheduler._control.call = control
    assert not _is_reset(craft, 20 * SECOND_US)
    assert passes[0] >= 20, passes
    assert craft.said(ABOUT_TO) == []


def what_always_fails_is_reset():
    """A reading that raises at each turn is told by its name before the board is reset; now and then is no reason."""
    needs(MEASURED, "something that is measured")
    name = MEASURED[0]["component"]
    for every in (1, 3):
        craft = new_craft()
        update = getattr(craft.state, "update_" + name)
        turns = [0]

        def fail(board, turns=turns, every=every, update=update):
            turns[0] += 1
            if turns[0] % every == 0:
                raise ValueError("broken")
            update(board)

        setattr(craft.state, "update_" + name, fail)
        assert _is_reset(craft, 5 * TIMEOUT_US) is (every == 1), every
        told = [text for _, text in craft.said(ABOUT_TO)]
        if every == 1:
            assert told[0] == f"{ABOUT_TO} reset the board: {name} stands still or fails", told
            assert mock_time.elapsed_us() <= TIMEOUT_US + SECOND_US


def faults_of_the_user_are_no_reason():
    """control() and measure() that raise each time, and one report that fails, are told and nobody is reset."""
    craft = new_craft()

    def fail():
        raise ValueError("broken")

    craft.scheduler._control.call = fail
    for job in craft.scheduler._jobs:
        if job.name == "measure":
            job.call = fail
    reports = []

    def report():
        reports.append(mock_time.elapsed_us())
        if len(reports) == 1:
            fail()

    for job in craft.scheduler._jobs:
        if job.name == "report":
            job.call = report
    assert not _is_reset(craft, 10 * TIMEOUT_US)
    assert len(craft.said("control failed")) == 1
    assert craft.said(ABOUT_TO) == []


def what_works_is_never_reset():
    """Saves into slow flash, and a flood of messages: fed at each look, and nothing else happens."""
    flash = Flash()
    flash.delay_us = 9000
    craft = new_craft(flash=flash)
    station = craft.ground_station()
    facts = next((each for each in PARAMETERS if each["minimum"] < each["maximum"]), None)
    seconds = 20

    async def flood():
        for turn in range(seconds * 20):
            for _ in range(10):
                station.send(messages.Ping, seq=turn)
            if facts is not None and turn % 100 == 0:
                steps = facts["minimum"] + (turn // 100) % 2
                value = steps * facts["numerator"] / facts["denominator"]
                station.set_parameter(facts, value)
            await asyncio.sleep_ms(50)

    assert not live(craft, flood)
    assert craft.said(ABOUT_TO) == []
    fed = machine.watchdog()[2]
    looks = seconds * SECOND_US // LOOK_US
    assert looks * 9 // 10 <= fed <= looks + 1, (fed, looks)
    assert facts is None or flash.operations, "nothing was saved"


def the_reason_is_told():
    """The cause of the last reset is told, in words; a warning if it was the watchdog, to later stations, too."""
    for number, words in WATCHDOG["causes"].items():
        machine.set_reset_cause(number)
        assert [text for _, text in new_craft().said("Started after")] == ["Started after " + words]
    machine.set_reset_cause(250)
    assert [text for _, text in new_craft().said("Started after")] == ["Started after a reset"]
    craft = new_craft()
    craft.scheduler._control.call = _hung
    assert _is_reset(craft, 10 * SECOND_US)
    craft = new_craft()
    assert [severity for severity, _ in craft.said(HAS_RESET)] == [4], craft.said()
    assert craft.said("Started after") == []
    station = craft.ground_station()
    run(craft, 12 * SECOND_US)
    station.received()
    station.send(messages.Heartbeat, type=6, autopilot=8)
    run(craft, 2 * SECOND_US)
    told = [text.text for text in station.received(messages.Statustext) if text.chunk_seq == 0]
    assert any(text.startswith(HAS_RESET) for text in told), told


def a_restart_is_no_warning():
    """The restart that a ground station asks for is told as one, even where the board does it by its watchdog."""
    craft = new_craft()
    craft.reboot(force=True)
    assert live(craft, _for(5 * SECOND_US))
    craft = new_craft()
    assert craft.said(HAS_RESET) == []
    assert [text for _, text in craft.said("Started after")] == ["Started after a restart"], craft.said()


def a_board_that_refuses():
    """Firmware that does not take the timeout is told, and the vehicle runs."""
    allowed = machine.watchdog_range_ms
    machine.watchdog_range_ms = (1, 2)
    try:
        craft = new_craft()
        assert not _is_reset(craft, 3 * TIMEOUT_US)
    finally:
        machine.watchdog_range_ms = allowed
    assert len(craft.said("there is no watchdog")) == 1
    assert craft.port.looks > 10


def a_prompt_is_left_alone():
    """Ctrl-C ends the program, the motors stop, and whoever is at the prompt has time; the next start ends that."""
    import main as program  # noqa: PLC0415

    class Interrupted:
        """A vehicle whose program is interrupted while the watchdog runs."""

        halted = 0

        async def run(self):
            watchdog.start(print)
            raise KeyboardInterrupt

        def halt_motors(self):
            self.halted += 1

    made = Interrupted()
    new_vehicle = program.new_vehicle
    program.new_vehicle = lambda: made
    try:
        program.main()
    except KeyboardInterrupt:
        pass
    else:
        raise AssertionError("nobody learns of it")
    finally:
        program.new_vehicle = new_vehicle
    assert made.halted == (0 if FORCE_ARM is None else 1)
    for _ in range(10 * TIMEOUT_US // 100000):
        mock_time.advance_us(100000)
    craft = new_craft()
    craft.scheduler._control.call = _hung
    assert _is_reset(craft, 5 * TIMEOUT_US)


CHECKS = (
    (what_hangs_is_reset, "watchdog.hung"),
    (a_dead_loop_is_reset, "watchdog.hung", "watchdog.fed"),
    (short_stops_are_no_reason, "watchdog.fed"),
    (what_always_fails_is_reset, "watchdog.fed"),
    (faults_of_the_user_are_no_reason, "watchdog.fed"),
    (what_works_is_never_reset, "watchdog.fed"),
    (the_reason_is_told, "watchdog.told"),
    (a_restart_is_no_warning, "watchdog.told"),
    (a_board_that_refuses, "watchdog.hung"),
    (a_prompt_is_left_alone, "watchdog.hung"),
)
LONG = (
    what_hangs_is_reset,
    what_always_fails_is_reset,
    faults_of_the_user_are_no_reason,
    what_works_is_never_reset,
    the_reason_is_told,
    a_board_that_refuses,
)

if __name__ == "__main__":
    main(CHECKS)
