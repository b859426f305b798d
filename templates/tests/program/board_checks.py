"""The board under a program: inputs that raise, a meter, the start, files, and saves that take long."""

import errno
import struct

from program_bench import (
    IS_MICROPYTHON,
    MOST_STEPS,
    Flash,
    main,
    mock_time,
    needs,
    new_craft,
)
from program_facts import MEASURED, PARAMETERS, STEP_LIMIT_US

import asyncio
import storage
import vehicle as vehicle_module
from stand_ins import Thing

try:
    import made_floats
except ImportError:  # all floats are made without the heap
    made_floats = None

NAN = float("nan")


def _measured_board(craft, measured, raised):
    """Return a board of which the reading of a component raises what is first in `raised`, None for nothing."""
    name = "read_" + measured["component"] + "_adc"

    def reading(*about):
        error = raised.pop(0) if raised else None
        if error is not None:
            raise error
        return getattr(craft.board, name)(*about)

    return Thing(**{name: reading})


def boards_that_raise_are_survived():
    """A reading that raises has failed: it is told at the first of several, and the next one is taken as ever."""
    needs(MEASURED, "something that is measured")
    for measured in MEASURED:
        craft = new_craft()
        craft.texts, told = None, []
        component = getattr(craft.state, measured["component"])[0]
        update = getattr(craft.state, "update_" + measured["component"])
        craft.state._log = lambda *parts: told.append(" ".join([str(part) for part in parts]))  # noqa: B023
        raised = []
        board = _measured_board(craft, measured, raised)

        def turns(*errors):
            for error in errors:
                raised.append(error)  # noqa: B023
                getattr(craft.state, "update_" + measured["component"])(board)  # noqa: B023
                mock_time.advance_us(measured["period_us"])  # noqa: B023

        turns(None)
        known = getattr(component, measured["attribute"])
        assert known is not None, measured["component"]
        limit = measured["invalid_after"] or 0
        turns(*[ValueError("bus") for _ in range(max(limit - 1, 1))])
        assert limit < 2 or getattr(component, measured["attribute"]) == known, "it fails too seldom yet"
        found = [text for text in told if "cannot read" in text]
        assert len(found) == 1, told
        assert found[0].endswith(": bus"), found
        if limit:
            turns(OSError())
            assert getattr(component, measured["attribute"]) is None, limit
        turns(None, RuntimeError(), None)
        assert getattr(component, measured["attribute"]) == known
        found = [text for text in told if "cannot read" in text]
        assert len(found) == 2, told
        assert found[1].endswith(": RuntimeError"), found
        for stop in (KeyboardInterrupt, SystemExit):
            try:
                turns(stop())
            except stop:
                pass
            else:
                raise AssertionError("it is not stopped")
            assert getattr(craft.state, "update_" + measured["component"]) is not update
            turns(None)
            assert getattr(component, measured["attribute"]) == known


def a_meter_calibrates():
    """A calibration sets the multiplier with which the reading is that of the meter; nothing without a reading."""
    needs(MEASURED, "something that is measured")
    for measured in MEASURED:
        needs(measured["multiplier_name"], "a parameter that is calibrated")
        craft = new_craft()
        component, name = getattr(craft.state, measured["component"])[0], measured["multiplier_name"]
        calibrate = getattr(craft.state, "calibrate_" + measured["component"])
        if measured["instances"] > 1:
            several = calibrate
            calibrate = lambda meter: several(meter, 0)  # noqa: B023, E731
        getattr(craft.state, "update_" + measured["component"])(craft.board)
        reading, old = getattr(component, measured["name"]), craft.parameters.get(name)
        for meter in (reading * 1.125, reading * 0.875, reading):
            assert calibrate(meter) is True, meter
            found = craft.parameters.get(name)
            assert abs(found / old - meter / reading) < 2e-3, (meter, found, old)
            if measured["latched"]:
                continue
            craft.parameters.set(name, old)
        before = craft.parameters.get(name)
        for meter in (None, 1e9, -1e9, NAN):
            assert calibrate(meter) is False, meter
            assert craft.parameters.get(name) == before
        setattr(component, measured["attribute"], None)
        assert calibrate(reading) is False
        assert craft.parameters.get(name) == before


class Level:
    """Stands in for the module micropython: a level that can be set."""

    def __init__(self):
        self.level = 1

    def opt_level(self, *level):
        """Return the level, or set it."""
        if not level:
            return self.level
        (self.level,) = level
        return None


def the_board_is_prepared():
    """Garbage is collected often while the vehicle is made, and modules are compiled at the level that is set."""
    import main as program  # noqa: PLC0415  it is about to be looked at

    heap, compiler, thresholds = program.gc, program.micropython, []
    program.gc = Thing(threshold=thresholds.append, mem_free=lambda: 6400)
    program.micropython = Level()
    try:
        program.collect_often(True)
        program.collect_often(False)
        assert thresholds == [200, -1], thresholds
        assert (program.compile_at(3), program.micropython.level) == (1, 3)
        assert (program.compile_at(0), program.micropython.level) == (3, 0)
        program.gc = program.micropython = Thing()
        program.collect_often(True)
        assert program.compile_at(2) == 2, "there is no level"
    finally:
        program.gc, program.micropython = heap, compiler


def floats_are_made():
    """Those that a machine has to make, with their factor, in both sizes and at any place."""
    needs(made_floats, "a float that is made")
    for code, size in (("<f", 4), ("<d", 8)):
        for value, numerator, denominator in ((3, 1, 2), (-7, 5, 4), (0, 1, 3), (123456, 1, 64)):
            wire = bytearray(b"\x5a" * 20)
            made_floats.make_float(code, wire, 5, value, numerator, denominator)
            assert struct.unpack_from(code, wire, 5)[0] == value * numerator / denominator
            assert bytes(wire[:5] + wire[5 + size :]) == b"\x5a" * (20 - size)


def the_vehicle_runs_until_it_is_stopped():
    """It is made while garbage is collected often, and runs; its motors stop, whatever ends it."""
    import main as program  # noqa: PLC0415  it is about to be looked at

    kept = program.collect_often, program.new_vehicle, program.asyncio
    try:
        for error in (None, ValueError, SystemExit):
            noted = []

            def run(told):
                noted.append(told)  # noqa: B023
                if error is not None:  # noqa: B023
                    raise error  # noqa: B023

            made = Thing(run=lambda: "it runs", halt_motors=lambda: noted.append("it is stopped"))  # noqa: B023
            program.collect_often = noted.append
            program.new_vehicle = lambda: noted.append("it is made") or made  # noqa: B023
            program.asyncio = Thing(run=run)
            try:
                program.main()
                ended = None
            except (ValueError, SystemExit) as raised:
                ended = type(raised)
            assert ended is error
            stops = ["it is stopped"] * hasattr(vehicle_module.Vehicle, "halt_motors")
            assert noted == [True, "it is made", False, "it runs"] + stops, noted  # noqa: RUF005  MicroPython
    finally:
        program.collect_often, program.new_vehicle, program.asyncio = kept


def slow_steps_of_saves_are_told():
    """The longest one, if it takes longer than it may; as long as that is no matter."""
    needs(PARAMETERS, "parameters")
    for took, count in ((STEP_LIMIT_US - 1, 0), (STEP_LIMIT_US, 0), (STEP_LIMIT_US + 1, 1)):
        craft = new_craft()
        step, times = craft.storage.step, [1, took, 5]

        def save_step():
            step()  # noqa: B023
            return times.pop(0) if times else 0  # noqa: B023

        craft._save_step = save_step
        if IS_MICROPYTHON:
            asyncio.new_event_loop()
        asyncio.run(craft._save())
        told = craft.said("a step of a save took us")
        assert [text for _, text in told] == [f"a step of a save took us: {took}"] * count, told


class Counted:
    """Opens files of a flash in memory, and counts those that are open; writing may fail."""

    def __init__(self, fails):
        self.flash = Flash()
        self.flash.files = {}
        self.fails = fails
        self.is_open = 0
        self.opened = 0

    def open(self, path, mode):
        """Open a file."""
        file = self.flash.open(path, mode)
        self.opened += 1
        self.is_open += 1
        return Open(self, file)


class Open:
    """A file that is open until it is closed."""

    def __init__(self, counted, file):
        self._counted = counted
        self.read = file.read
        self._write = file.write

    def __enter__(self):
        return self

    def __exit__(self, *_raised):
        self.close()

    def write(self, data):
        """Write, or fail."""
        if self._counted.fails:
            raise OSError(errno.EIO, "broken")
        return self._write(data)

    def close(self):
        """Be open no more."""
        self._counted.is_open -= 1


def files_are_closed():
    """Whatever becomes of a save: what it has opened counts only once it is closed, and there are few at a time."""
    for fails in (False, True):
        counted = Counted(fails)
        storage.open = counted.open
        own = storage.Storage(("a", "b"), 8)
        own.load()
        assert counted.is_open == 0
        own.begin(b"a payload of several pieces")
        for _ in range(MOST_STEPS):
            if not own.step():
                break
            assert counted.is_open in (0, 1)
        assert not own.is_saving
        assert counted.is_open == 0, fails
        assert counted.opened > 0
        assert (own.problem is not None) == fails
        assert (own.load() is None) == fails
        assert counted.is_open == 0
    Flash()


CHECKS = (
    (boards_that_raise_are_survived,),
    (a_meter_calibrates,),
    (the_board_is_prepared,),
    (floats_are_made,),
    (the_vehicle_runs_until_it_is_stopped,),
    (slow_steps_of_saves_are_told, "storage.set"),
    (files_are_closed,),
)

if __name__ == "__main__":
    main(CHECKS)
