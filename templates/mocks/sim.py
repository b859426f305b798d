"""Runs the firmware on a host against a scenario: sim.py SETTINGS.json, as `codegen sim` does.

The settings: `courses` (what is true of quantities, and the kind of input that each reaches the firmware through),
`events`, `start_ms` and `duration_ms` in the time of the scenario (duration null: for ever), `speed` (1 real time, 0 as
fast as it can), `unique_id` of the board in hex, `told`: the numbers of the messages whose
frames are recorded, `watched`: quantities of the state, see sim_watch, `actions`: methods of the vehicle, `mocked`:
modules that stand in for what sensors are connected to, `store`:
parameters to be stored before the start, with `files` and `chunk` of the storage, or null, `turns`: the file that says
how far time may go and `until_ms` where the first turn ends (null: the program is alone), and `records`: the file that
gets a line of JSON for whatever happens, with the scenario's time in ms:

    start      runtime                     the firmware is about to run
    sample     frames, bytes, overruns     ten times a second: what is counted
    state      label, value                a quantity that is watched has changed
    failsafe   name, index, level ...      a failsafe has another level
    action     name                        a method that acts for a failsafe was called
    frame      data                        a message that tells of quantities went out, in hex
    text       severity, text              the firmware said something
    event      name, text                  what the scenario did: refused, reboot
    messages   counts                      by number: frames and bytes that went out; also parameters, link statistics
    turn                                   the end of the turn is reached: a line is waited for
    caught     name, traceback             the firmware caught an exception of a part of the program, and goes on
    failed     traceback                   the firmware raised an exception that nobody caught, or the watchdog was
                                           not fed (then this exits with 1)
    stood      traceback                   where the firmware was when this was interrupted
    end        reason                      over, reset (then this exits with 3), returned, failed, stopped
"""

import json
import sys

import mock_time
import sim_pace  # before the clock of the host is replaced

mock_time.install()

import mock_asyncio  # noqa: E402  the clock has to be in place before anything looks at it

mock_asyncio.install()

import machine  # noqa: E402
import sim_machine  # noqa: E402
from sim_course import Course  # noqa: E402
from sim_failures import Failures  # noqa: E402
from sim_ground import Ground  # noqa: E402
from sim_records import Records, runtime, traceback_of  # noqa: E402
from sim_watch import Watch  # noqa: E402
from sim_wire import SilentPort, SpokenPort, Wire  # noqa: E402

sim_machine.install()

EXIT_RESET = 3
SAMPLE_MS = 100
MESSAGES_MS = 1000
NEVER_MS = 1 << 40


class End(BaseException):
    """The scenario's time is over."""


class LeftOut:
    """Stands for a module with a sensor of the user's in a scenario without code of the user.

    The class of the user's vehicle, if it is there that it would be, is the vehicle without code of the user.
    """

    def __init__(self, vehicle):
        self._vehicle = vehicle

    def __getattr__(self, name):
        if name == self._vehicle:
            from vehicle import Vehicle  # noqa: PLC0415  once the program runs

            return Vehicle
        raise ImportError("it has no course, and code is left out")


def leave_out(name, vehicle):
    """Let a module that is not there say why; `vehicle` is the class of the vehicle that it would have, or None."""
    try:
        __import__(name)
    except ImportError:
        sys.modules[name] = LeftOut(vehicle)


class Simulation:
    """One run of the firmware, from its start to its end or to a reset."""

    def __init__(self, settings):
        self._start_ms = settings["start_ms"]
        self._duration_ms = settings["duration_ms"]
        events = settings["events"]
        happening = [event for event in events if "arm" in event or "reboot" in event]
        self._events = [event for event in happening if self._is_ahead(event)]
        sendings = [event for event in events if "send" in event]
        self._ground = Ground(sendings, self._start_ms)
        self._settings = settings
        self.records = Records(settings["records"], self.now_ms)
        self._turns = sim_pace.Turns(settings["turns"], settings["until_ms"], self.records)
        self._store = settings["store"]
        if settings["reset_cause"] is not None:
            machine.set_reset_cause(settings["reset_cause"])
        self._wire = Wire(self.records, settings["told"], self._sum_up)
        self._watch = Watch(self.records, settings["watched"], settings["actions"])
        self._watched = None
        self._main = None
        self._pace = None
        self._inputs_ms = 0
        self._due_us = 0  # when there is something to do again, but for looking at what the vehicle has done
        self._changes = None  # of parameters, when they were recorded last
        self._speed = settings["speed"]
        self._sample_ms = self._messages_ms = self._start_ms
        unique_id = bytes([int(settings["unique_id"][at : at + 2], 16) for at in range(0, 16, 2)])
        machine.unique_id = lambda: unique_id
        for name in settings["mocked"]:
            __import__(name)
        for name, vehicle in settings["left_out"]:
            leave_out(name, vehicle)
        faults = [event for event in events if "fault" in event]
        self._inputs = self._connect([(data["kind"], Course(data, faults)) for data in settings["courses"]])

    def run(self):
        """Run the firmware until its time is over, and return the exit code."""
        machine.reset = self._reset
        self.records.put("start", runtime=runtime())
        reason = "stopped"
        code = 0
        try:
            reason = self._run_main()
        except machine.WatchdogReset as error:
            reason = "failed"
            code = 1
            self.records.put("failed", traceback=traceback_of(error))
        except SystemExit as leaving:
            reason = "reset" if EXIT_RESET in leaving.args else "returned"
            code = EXIT_RESET if reason == "reset" else 0
        except KeyboardInterrupt as error:  # whoever started this ends it, and may want to know where it stood
            self.records.put("stood", traceback=traceback_of(error))
        except Exception as error:
            reason = "failed"
            code = 1
            self.records.put("failed", traceback=traceback_of(error))
        finally:
            self._changes = None
            self._sum_up()
            self.records.put("end", reason=reason)
        return code

    def _run_main(self):
        if self._store:
            store_parameters(self._store)
        self._replace_ports()
        import main  # noqa: PLC0415 - after everything that it must find replaced

        def new_vehicle():
            """Let faulty code end the simulation, which says where."""
            return main.vehicle_class()()

        main.new_vehicle = new_vehicle
        Failures(self.records).listen()
        main.compile_at = lambda level: level  # there is room for the numbers of lines
        self._main = main
        self._pace = sim_pace.Pace(self._speed)
        mock_asyncio.on_wait(self._on_wait)
        try:
            main.main()
        except End:
            return "over"
        return "returned"

    def now_ms(self):
        """Return the scenario's time."""
        return self._start_ms + mock_time.elapsed_us() // 1000

    def _is_ahead(self, event):
        # An event at the very time of a restart, as the restart itself, is not done again.
        return event["at_ms"] > self._start_ms or self._start_ms == 0

    def _connect(self, courses):
        """Connect each course to its kind of input; return what has to be called again and again."""
        turns = []
        for kind in sorted({kind for kind, _ in courses}):
            module = __import__("sim_" + kind)
            turn = module.connect([course for of, course in courses if of == kind], self.now_ms, self._start_ms)
            if turn is not None:
                turns.append(turn)
        return turns

    def _replace_ports(self):
        self._is_bridged = False
        # The firmware's own modules, before its board takes names out of them.
        import serial_port  # noqa: PLC0415
        import udp_port  # noqa: PLC0415

        hear = self.records.hear

        def open_serial(name, *_, **__):
            """Open nothing, or UDP in place of a cable of a board that has no UDP: the first that is not signed.

            Where the network takes nothing of what the scenario says, that arrives by a cable.
            """
            import board  # noqa: PLC0415

            if hasattr(board, "UdpPort") and name == self._settings["spoken"]:
                return SpokenPort(name, self._ground)
            if hasattr(board, "UdpPort") or self._is_bridged or (self._settings["bridge"] or name) != name:
                return SilentPort(name)
            self._is_bridged = True

            def say(*words):
                """Tell what the stand-in for a cable says, but for its Wi-Fi: the vehicle has none."""
                said = " ".join(map(str, words))
                if "Wi-Fi" not in said:
                    hear(said)

            return udp_port.UdpPort(name, None, 0, 0, "wifi.json", 1000, log=say)

        serial_port.open_uart = serial_port.open_usb = open_serial
        for port_class in tcp_ports() + (udp_port.UdpPort,):  # noqa: RUF005 - MicroPython has no other way
            self._wire.listen(port_class)
            self._ground.speak_to(port_class, self._settings["deaf"])
        import texts  # noqa: PLC0415

        plain = texts.Texts

        class HeardTexts(plain):
            """Texts whose echo goes to the records instead of the console."""

            def __init__(self, _echo=None, capacity=16):
                plain.__init__(self, hear, capacity)

        texts.Texts = HeardTexts

    def _vehicle(self):
        return getattr(self._main, "vehicle", None)

    def _on_wait(self, wait_us):
        vehicle = self._watched
        if vehicle is not None:
            self._watch.look(vehicle)
        if mock_time.elapsed_us() + wait_us >= self._due_us:
            self._turn(wait_us)

    def _turn(self, wait_us):
        now_ms = self.now_ms()
        vehicle = self._vehicle()
        if vehicle is not None:
            self._look(vehicle, now_ms)
        while vehicle is not None and self._events and self._events[0]["at_ms"] <= now_ms:
            self._happen(self._events.pop(0), vehicle)
        self._ground.turn(now_ms)
        if now_ms >= self._sample_ms:
            self._sample(vehicle, now_ms)
        if now_ms >= self._messages_ms:
            self._messages_ms = now_ms + MESSAGES_MS
            self._sum_up()
        if self._duration_ms is not None and now_ms >= self._duration_ms:
            raise End
        if not self._turns.wait_until(now_ms + wait_us // 1000):
            raise KeyboardInterrupt
        self._pace.wait_until(mock_time.elapsed_us() + wait_us)
        self._due_us = 1000 * (self._next_ms() - self._start_ms)
        mock_asyncio.leave_out_until(self._due_us)

    def _next_ms(self):
        """Return when _turn() is to be called again, in the scenario's time."""
        if self._speed or self._watched is None:
            return self._start_ms  # there is a clock to wait for, or a vehicle to come
        next_ms = min(self._sample_ms, self._messages_ms, self._ground.next_ms(), self._inputs_ms)
        if self._turns.until_ms is not None:
            next_ms = min(next_ms, self._turns.until_ms)
        if self._events:
            next_ms = min(next_ms, self._events[0]["at_ms"])
        if self._duration_ms is not None:
            next_ms = min(next_ms, self._duration_ms)
        return next_ms

    def _look(self, vehicle, now_ms):
        """Let the inputs follow their courses, and record what the vehicle has done."""
        if self._watched is not vehicle:
            self._watched = vehicle
            self._watch.begin(vehicle)
        self._inputs_ms = NEVER_MS
        for turn in self._inputs:
            self._inputs_ms = min(self._inputs_ms, turn(now_ms, vehicle) or 0)
        self._watch.look(vehicle)

    def _happen(self, event, vehicle):
        if event.get("reboot"):
            self.records.put("event", name="reboot", text="")
            self._reset()
        problem = vehicle.arm() if event["arm"] else vehicle.disarm()
        if problem:
            self.records.put("event", name="refused", text=problem)
        self._watch.look(vehicle)

    def _sample(self, vehicle, now_ms):
        self._sample_ms += SAMPLE_MS * ((now_ms - self._sample_ms) // SAMPLE_MS + 1)
        for number in range(2) if hasattr(machine, "serial") else ():
            machine.serial(number).sent = bytearray()  # the mock keeps what nobody reads
        wire = self._wire
        scheduler = getattr(vehicle, "scheduler", None)
        self.records.put(
            "sample",
            frames=wire.frames,
            bytes=wire.size,
            overruns=getattr(scheduler, "overruns", 0),
        )

    def _sum_up(self):
        vehicle = self._vehicle()
        statistics = self._wire.status_of_links(vehicle)
        self.records.put("messages", counts=self._wire.counts, parameters=self._parameters(), **statistics)

    def _parameters(self):
        """Return all parameters by their names where one has changed since the last time, else none."""
        parameters = getattr(self._vehicle(), "parameters", None)
        if parameters is None or parameters.changes == self._changes:
            return {}
        self._changes = parameters.changes
        return {name: parameters.get(name) for name in parameters.names()}

    def _reset(self):
        raise SystemExit(EXIT_RESET)


def tcp_ports():
    """Return the class of ports over TCP, in a tuple, if the firmware has one."""
    try:
        import tcp_port  # noqa: PLC0415 - the firmware's own
    except ImportError:
        return ()
    return (tcp_port.TcpPort,)


def store_parameters(store):
    """Put parameters into the storage, beside those that are there, as if they had been set before."""
    from parameters import Parameters  # noqa: PLC0415 - the firmware's own, after the clock
    from storage import Storage  # noqa: PLC0415

    parameters = Parameters()
    storage = Storage(tuple(store["files"]), store["chunk"])
    parameters.restore(storage.load() or b"")
    for name, value in store["parameters"].items():
        if not parameters.set(name, value):
            raise ValueError(f"{name} = {value} is not accepted")
    storage.begin(parameters.dump())
    while storage.step():
        pass
    if storage.problem:
        raise OSError(storage.problem)


def interrupted(_number, _frame):
    """Let Ctrl-C end whatever runs: asyncio of CPython would wait for its tasks."""
    raise KeyboardInterrupt


if __name__ == "__main__":
    if sys.implementation.name != "micropython":
        import signal

        signal.signal(signal.SIGINT, interrupted)
    with open(sys.argv[1]) as file:
        SETTINGS = json.load(file)
    sys.exit(Simulation(SETTINGS).run())
