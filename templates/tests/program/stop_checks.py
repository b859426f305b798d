"""The user's code: which class is started, and stop_motors(), called in each failure; a fault in it changes nothing."""

import asyncio
import machine
import sys
from program_bench import Craft, SECOND_US, live, main, needs, needs_arming, new_craft, run
from program_facts import ACTIONS, FORCE_ARM, USER


def _stopping(craft, fails=False):
    """Let a vehicle note when its motors are stopped, and fail then, if it is to."""

    def stop_motors():
        craft.calls.append("stop_motors")
        if fails:
            raise OSError(5)

    craft.stop_motors = stop_motors
    return craft


def _told(craft):
    return [text for severity, text in craft.said("stop_motors() failed") if severity == 3]


def disarming_stops_them():
    """Before on_disarm(), and only where it was armed."""
    needs_arming()
    craft = _stopping(new_craft())
    craft.disarm()
    craft.arm(force=True)
    craft.disarm()
    assert craft.calls == ["on_arm", "stop_motors", "on_disarm"], craft.calls


def terminating_stops_them():
    """Each action that disarms, also where its call fails."""
    terminating = [(number, call) for number, call, _, disarms in ACTIONS if disarms]
    needs(terminating, "an action that disarms")
    for number, call in terminating:
        for fails in (False, True):
            craft = _stopping(new_craft())

            def terminate(fails=fails, craft=craft):
                craft.calls.append("terminate")
                if fails:
                    raise ValueError("broken")

            setattr(craft, call, terminate)
            craft.arm(force=True)
            with craft._guard:
                craft._act(number)
            assert craft.calls == ["on_arm", "terminate", "stop_motors", "on_disarm"], craft.calls
            assert not craft.is_armed


def a_fault_of_control_stops_them():
    """Once until control() works again."""
    needs_arming()
    craft = _stopping(new_craft())

    def fail():
        raise ValueError("broken")

    control = craft.scheduler._control.call
    for times in (1, 2):
        craft.scheduler._control.call = fail
        run(craft, SECOND_US)
        assert craft.calls == ["stop_motors"] * times, craft.calls
        craft.scheduler._control.call = control
        run(craft, SECOND_US)
    assert craft.calls == ["stop_motors"] * 2, craft.calls


def a_restart_stops_them():
    """Before the board is reset, and control() does not run after that."""
    needs_arming()
    craft = _stopping(new_craft())
    craft.scheduler._control.call = lambda: craft.calls.append("control")

    async def restart():
        await asyncio.sleep_ms(100)
        craft.reboot()
        await asyncio.sleep_ms(5000)

    assert live(craft, restart)
    assert craft.calls[-2:] == ["control", "stop_motors"], craft.calls[-3:]
    assert craft.calls.count("stop_motors") == 1


def code_that_cannot_start_stops_them():
    """A constructor that fails, after the motors are set up or before: a spare vehicle runs, and says what is wrong.

    What the first one leaves on the heap is collected before there is another one.
    """
    needs_arming()
    import main as program  # noqa: PLC0415
    import vehicle  # noqa: PLC0415

    stopped, made, collected = [], [], []

    class Collecting:
        """Stands in for the module gc."""

        @staticmethod
        def collect():
            """Note it."""
            collected.append(len(made))

    class Spare(Craft):
        """The vehicle in place of that."""

        def __init__(self):
            made.append(self)
            Craft.__init__(self)

    class Faulty(Craft):
        """A vehicle whose constructor fails."""

        def __init__(self):
            Craft.__init__(self)
            raise ValueError("no motors")

        def stop_motors(self):
            """Note it; another fault is told, too."""
            stopped.append(True)
            if len(stopped) == 2:
                raise OSError(5)

    plain, found, told, heap = vehicle.Vehicle, program.vehicle_class, getattr(program, "sys", None), program.gc
    program.gc = Collecting
    program.sys = None  # a traceback would stand between what is printed
    program.vehicle_class = lambda: Faulty
    vehicle.Vehicle = Spare
    try:
        for times in (1, 2):
            spare = program.new_vehicle()
            assert len(stopped) == times, stopped
            assert len(_told(spare)) == times - 1, spare.said()
            assert "no motors" in spare.check_arming(), spare.check_arming()
            assert collected == list(range(times)), collected
    finally:
        vehicle.Vehicle, program.vehicle_class, program.sys, program.gc = plain, found, told, heap


def a_fault_in_it_changes_nothing():
    """It is told, and the vehicle is disarmed, the loop runs on, the board is reset as it was to be."""
    needs_arming()
    craft = _stopping(new_craft(), fails=True)
    craft.arm(force=True)
    craft.disarm()
    assert craft.calls == ["on_arm", "stop_motors", "on_disarm"], craft.calls
    assert not craft.is_armed
    assert len(_told(craft)) == 1

    def fail():
        raise ValueError("broken")

    control = craft.scheduler._control.call
    craft.scheduler._control.call = fail
    looks = craft.port.looks
    run(craft, SECOND_US)
    craft.scheduler._control.call = control
    assert craft.port.looks > looks + 10
    assert len(craft.said("control failed")) == 1
    assert len(_told(craft)) == 2
    craft.reboot()
    assert live(craft, _wait)
    assert len(_told(craft)) == 3
    assert machine.watchdog()[1] == 0


async def _wait():
    await asyncio.sleep_ms(5000)


class Module:
    """Stands in for the user's module."""


def _started():
    """Return what main.py takes for the class of the vehicle."""
    import main as program  # noqa: PLC0415

    return program.vehicle_class()


def _made():
    """Return the vehicle that main.py makes."""
    import main as program  # noqa: PLC0415

    return program.new_vehicle()


def its_class_is_taken():
    """One that is derived from Vehicle is; another one is a fault that names both; without the module it is Vehicle."""
    import vehicle  # noqa: PLC0415

    name, class_name = USER
    before = sys.modules.get(name)

    class Own(vehicle.Vehicle):
        """A vehicle of the user's."""

        def __init__(self):
            self.is_made = True

    try:
        module = sys.modules[name] = Module()
        setattr(module, class_name, Own)
        assert _started() is Own
        assert _made().is_made, "it is made without a fault"
        setattr(module, class_name, Module)
        told = ""
        try:
            _started()
        except TypeError as error:
            told = str(error)
        assert f"{name}.{class_name}" in told, told
    finally:
        del sys.modules[name]
        if before is not None:
            sys.modules[name] = before


def without_it_there_is_a_vehicle():
    """A board that has only the firmware runs it."""
    import vehicle  # noqa: PLC0415

    try:
        __import__(USER[0])
    except ImportError:
        assert _started() is vehicle.Vehicle
        return
    needs(False, "a board without the user's module")


CHECKS = (
    (its_class_is_taken,),
    (without_it_there_is_a_vehicle,),
    (disarming_stops_them, "arming.stop"),
    (terminating_stops_them, "arming.stop"),
    (a_fault_of_control_stops_them, "arming.stop"),
    (a_restart_stops_them, "arming.stop"),
    (code_that_cannot_start_stops_them, "arming.stop"),
    (a_fault_in_it_changes_nothing, "arming.stop"),
)

SUBJECT = FORCE_ARM is not None
"""True where the vehicle can be armed; if not, these checks are left out."""

if __name__ == "__main__":
    main(CHECKS, SUBJECT)
