# Generated from templates/mocks/sim.py: do not edit.
# Inputs: e9a11d0086cdd63f
"""Runs the firmware on a host against a scenario: sim.py SETTINGS.json, as `codegen sim` does.

The settings: `batteries` by instance (their true voltage and current, and the GPIO of the ADC input of each), `events`,
`start_ms` and `duration_ms` in the time of the scenario (duration null: for ever), `speed` (1 real time, 0 as fast as
it can), `unique_id` of the board in hex, `instances`: how many batteries the firmware has, `first_number`: the
parameter with the id of the first one or null, `store`: parameters to be stored before the start, with `files` and
`chunk` of the storage, or null, `turns`: the file that says how far time may go and `until_ms` where the first turn
ends (null: the program is alone), and `records`: the file that gets a line of JSON for whatever happens, with the
scenario's time in ms:

    start      runtime                     the firmware is about to run
    sample     true, reported, armed ...   ten times a second; `true` and `reported` are millivolts by instance
    battery    instance, millivolts ...    a message about the state of a battery went out
    text       severity, text              the firmware said something
    event      name, text                  what the scenario did: armed, disarmed, refused, reboot
    messages   counts                      by name: frames and bytes that went out; also link statistics
    turn                                   the end of the turn is reached: a line is waited for
    failed     traceback                   the firmware raised an exception that nobody caught (then this exits with 1)
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
from sim_records import Records, runtime, traceback_of  # noqa: E402
from sim_wire import SilentPort, Wire  # noqa: E402
from waveform import Waveform  # noqa: E402

EXIT_RESET = 3
SAMPLE_MS = 100
MESSAGES_MS = 1000


class End(BaseException):
    """The scenario's time is over."""


class Simulation:
    """One run of the firmware, from its start to its end or to a reset."""

    def __init__(self, settings):
        self._start_ms = settings["start_ms"]
        self._duration_ms = settings["duration_ms"]
        self._events = [event for event in settings["events"] if "adc" not in event and self._is_ahead(event)]
        self._faults = [event for event in settings["events"] if "adc" in event]
        self.records = Records(settings["records"], self.now_ms)
        self._turns = sim_pace.Turns(settings["turns"], settings["until_ms"], self.records)
        self._store = settings["store"]
        self._first_parameter = settings["first_number"]
        self._first_number = None
        self._instances = settings["instances"]
        self._wire = None
        self._main = None
        self._pace = None
        self._speed = settings["speed"]
        self._sample_ms = self._messages_ms = self._start_ms
        unique_id = bytes([int(settings["unique_id"][at : at + 2], 16) for at in range(0, 16, 2)])
        machine.unique_id = lambda: unique_id
        self._waveforms = [self._connect(index, battery) for index, battery in enumerate(settings["batteries"])]

    def run(self):
        """Run the firmware until its time is over, and return the exit code."""
        machine.reset = self._reset
        self.records.put("start", runtime=runtime())
        reason = "stopped"
        code = 0
        try:
            reason = self._run_main()
        except SystemExit as leaving:
            reason = "reset" if EXIT_RESET in leaving.args else "returned"
            code = EXIT_RESET if reason == "reset" else 0
        except KeyboardInterrupt:
            pass  # whoever started this ends it
        except Exception as error:
            reason = "failed"
            code = 1
            self.records.put("failed", traceback=traceback_of(error))
        finally:
            self._sum_up()
            self.records.put("end", reason=reason)
        return code

    def _run_main(self):
        if self._store:
            store_parameters(self._store)
        self._replace_ports()
        import main  # noqa: PLC0415 - after everything that it must find replaced

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
        # What happened at the very time of a restart, as the restart itself, is not done again.
        return event["at_ms"] > self._start_ms or self._start_ms == 0

    def _connect(self, instance, battery):
        waveform = Waveform(battery, battery["reference_mv"])
        absent = any(self._holds(fault, instance, "absent", self._start_ms) for fault in self._faults)
        for gpio, count in ((battery["gpio"], waveform.count), (battery["current_gpio"], waveform.current_count)):
            if gpio is not None:
                analog = machine.analog(gpio)
                analog.source = self._reader(instance, count)
                analog.absent = absent
        return waveform

    def _reader(self, instance, count):
        def read(_elapsed_us):
            now_ms = self.now_ms()
            for fault in self._faults:
                if self._holds(fault, instance, "slow", now_ms):
                    mock_time.advance_us(fault["delay_us"])
                elif self._holds(fault, instance, "fail", now_ms) or self._holds(fault, instance, "absent", now_ms):
                    return None
            return count(now_ms)

        return read

    def _holds(self, fault, instance, kind, at_ms):
        until_ms = fault["until_ms"]
        is_meant = fault["adc"] == kind and fault["instance"] == instance
        return is_meant and fault["at_ms"] <= at_ms and (until_ms is None or at_ms < until_ms)

    def _number_of_first(self):
        """Return the id of the first battery: what it is when the first message about one goes out."""
        if self._first_number is None:
            parameters = self._parameters() if self._first_parameter else {}
            self._first_number = int(parameters.get(self._first_parameter, 0))
        return self._first_number

    def _replace_ports(self):
        self._wire = Wire(self.records, self._instances, self._number_of_first)
        self._is_bridged = False
        # The firmware's own modules, before its board takes names out of them.
        import serial_port  # noqa: PLC0415
        import udp_port  # noqa: PLC0415

        def open_serial(name, *_, **__):
            """Open nothing, or UDP in place of the first UART or USB of a board that has no UDP."""
            import board  # noqa: PLC0415

            if hasattr(board, "UdpPort") or self._is_bridged:
                return SilentPort(name)
            self._is_bridged = True
            return udp_port.UdpPort(name, None, 0, 0, "wifi.json", 1000, log=print)

        serial_port.open_uart = serial_port.open_usb = open_serial
        self._wire.listen(udp_port.UdpPort)
        import texts  # noqa: PLC0415

        hear = self.records.hear
        plain = texts.Texts

        class HeardTexts(plain):
            """Texts whose echo goes to the records instead of the console."""

            def __init__(self, _echo=None, capacity=16):
                plain.__init__(self, hear, capacity)

        texts.Texts = HeardTexts

    def _vehicle(self):
        return getattr(self._main, "vehicle", None)

    def _on_wait(self, wait_us):
        now_ms = self.now_ms()
        vehicle = self._vehicle()
        while vehicle is not None and self._events and self._events[0]["at_ms"] <= now_ms:
            self._happen(self._events.pop(0), vehicle)
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

    def _happen(self, event, vehicle):
        if event.get("reboot"):
            self.records.put("event", name="reboot", text="")
            self._reset()
        problem = vehicle.arm() if event["arm"] else vehicle.disarm()
        done = "armed" if event["arm"] else "disarmed"
        self.records.put("event", name="refused" if problem else done, text=problem or "")

    def _sample(self, vehicle, now_ms):
        self._sample_ms += SAMPLE_MS * ((now_ms - self._sample_ms) // SAMPLE_MS + 1)
        for number in range(2) if hasattr(machine, "serial") else ():
            machine.serial(number).sent = bytearray()  # the mock keeps what nobody reads
        wire = self._wire
        scheduler = getattr(vehicle, "scheduler", None)
        instances = range(len(self._waveforms))
        self.records.put(
            "sample",
            true=[waveform.millivolts(now_ms) for waveform in self._waveforms],
            reported=[wire.millivolts.get(instance) for instance in instances],
            armed=wire.is_armed,
            state=wire.status,
            frames=wire.frames,
            bytes=wire.size,
            overruns=getattr(scheduler, "overruns", 0),
            load=getattr(scheduler, "load", 0),
        )

    def _sum_up(self):
        if self._wire is None:  # the firmware has not got so far
            return
        self.records.put("messages", counts=self._wire.counts, parameters=self._parameters(), **self._statistics())

    def _statistics(self):
        return self._wire.status_of_links(self._vehicle())

    def _parameters(self):
        parameters = getattr(self._vehicle(), "parameters", None)
        return {name: parameters.get(name) for name in parameters.names()} if parameters else {}

    def _reset(self):
        raise SystemExit(EXIT_RESET)


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


if __name__ == "__main__":
    with open(sys.argv[1]) as file:
        SETTINGS = json.load(file)
    sys.exit(Simulation(SETTINGS).run())
