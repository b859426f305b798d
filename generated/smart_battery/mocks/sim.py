# Generated from templates/mocks/sim.py: do not edit.
# Inputs: 81bb8aabed9799bb
"""Runs the firmware on a host against a scenario: sim.py SETTINGS.json, as `codegen sim` does.

The settings: `scenario` (its data), `reference_mv` and `gpios` of the ADC, `start_ms` and `duration_ms` in the time of
the scenario (duration null: for ever), `speed` (1 real time, 0 as fast as it can), `records`: the file that gets a line
of JSON for whatever happens, with the scenario's time in ms:

    start      runtime, parameters         the firmware is about to run
    sample     true, reported, armed ...   ten times a second; `true` and `reported` are millivolts, null if unknown
    battery    millivolts                  a BATTERY_STATUS went out
    text       severity, text              the firmware said something
    event      name, text                  what the scenario did: armed, disarmed, refused, reboot
    messages   counts                      by name: frames and bytes that went out; also link statistics
    failed     traceback                   the firmware raised an exception that nobody caught (then this exits with 1)
    end        reason                      over, reset (then this exits with 3), returned, failed, stopped
"""

import json
import sys
import time as host_time  # the host's clock: the firmware gets the one that is moved by hand

import mock_time

mock_time.install()

import mock_asyncio  # noqa: E402  the clock has to be in place before anything looks at it

mock_asyncio.install()

import machine  # noqa: E402
from waveform import Waveform  # noqa: E402

EXIT_RESET = 3
SAMPLE_MS = 100
MESSAGES_MS = 1000
LATE_US = 2000000  # the host was asleep: go on from here instead of catching up
ARMED_FLAG = 128  # MAV_MODE_FLAG_SAFETY_ARMED
HEARTBEAT = 0
BATTERY_STATUS = 147
_IS_BUFFERED = sys.implementation.name != "micropython"
_SEVERITIES = (("error: ", 3), ("warning: ", 4), ("notice: ", 5))


class End(BaseException):
    """The scenario's time is over."""


class Records:
    """The file that gets the records."""

    def __init__(self, path, now_ms):
        self._file = open(path, "w")  # noqa: SIM115 - it stays open; MicroPython has no pathlib
        self._now_ms = now_ms

    def put(self, kind, **values):
        """Write one record."""
        values["kind"] = kind
        values["at"] = self._now_ms()
        self._file.write(json.dumps(values) + "\n")
        if _IS_BUFFERED:
            self._file.flush()

    def hear(self, line):
        """Take a line of the firmware's texts, `error: ...` as it is printed on the board's console."""
        for prefix, severity in _SEVERITIES:
            if line.startswith(prefix):
                self.put("text", severity=severity, text=line[len(prefix) :])
                return
        self.put("text", severity=6, text=line)


class Wire:
    """What goes out, taken from the frames that a port accepted."""

    def __init__(self, records):
        import messages  # noqa: PLC0415 - the firmware's own, after the clock
        from receiver import Receiver  # noqa: PLC0415

        classes = [getattr(messages, name) for name in dir(messages)]
        classes = [cls for cls in classes if isinstance(cls, type) and getattr(cls, "NAME", "")]
        self._names = {cls.ID: cls.NAME for cls in classes}
        self._receiver = Receiver([cls() for cls in classes if cls.ID in (HEARTBEAT, BATTERY_STATUS)])
        self._records = records
        self._next_sequence = {}
        self._port_class = None
        self.counts = {}
        self.frames = 0
        self.size = 0
        self.gaps = 0
        self.is_armed = False
        self.status = None
        self.millivolts = None

    def listen(self, port_class):
        """Take note of every frame that ports of this class accept."""
        self._port_class = port_class
        write = port_class.write

        def heard(port, frame):
            taken = write(port, frame)
            if taken:
                self.take(port, frame)
            return taken

        port_class.write = heard

    def take(self, port, frame):
        """Take note of one whole frame."""
        is_new = frame[0] == 0xFD
        number = frame[7] | frame[8] << 8 | frame[9] << 16 if is_new else frame[5]
        self._check_sequence(port, frame[4] if is_new else frame[2])
        count = self.counts.setdefault(self._names.get(number, str(number)), [0, 0])
        count[0] += 1
        count[1] += len(frame)
        self.frames += 1
        self.size += len(frame)
        if number in (HEARTBEAT, BATTERY_STATUS):
            self._receiver.put(bytes(frame))
            message = self._receiver.receive()
            while message is not None:
                self._read(message)
                message = self._receiver.receive()

    def _check_sequence(self, port, sequence):
        expected = self._next_sequence.get(id(port), sequence)
        self._next_sequence[id(port)] = (sequence + 1) & 0xFF
        self.gaps += (sequence - expected) & 0xFF

    def _read(self, message):
        if message.ID == HEARTBEAT:
            self.is_armed = bool(message.base_mode & ARMED_FLAG)
            self.status = message.system_status
        elif message.id == 0:
            cells = [cell for cell in message.voltages if cell is not None]
            self.millivolts = sum(cells) if cells else None
            self._records.put("battery", millivolts=self.millivolts)

    def status_of_links(self, vehicle):
        """Return the sums of the counters that the heard ports and their links keep."""
        connections = getattr(vehicle, "connections", None) or ()
        heard = [connection for connection in connections if isinstance(connection.port, self._port_class)]
        return {
            "dropped": sum(connection.port.dropped for connection in heard),
            "received": sum(connection.port.received for connection in heard),
            "crc_errors": sum(connection.link.crc_errors for connection in heard),
            "gaps": self.gaps,
        }


class SilentPort:
    """A port without anybody at its other end."""

    is_up = False
    dropped = sent = received = 0

    def __init__(self, name):
        self.name = name

    def readinto(self, buffer):  # noqa: ARG002 - nothing arrives
        """Read nothing."""
        return 0

    def write(self, frame):  # noqa: ARG002 - nobody takes it
        """Take nothing."""
        return 0

    def poll(self, now_ms):
        """Do nothing."""


class Pace:
    """Lets virtual time pass no faster than real time times `speed`; 0 for as fast as it can."""

    def __init__(self, speed):
        self._speed = speed
        self._start_us = host_us()
        self._virtual_us = mock_time.elapsed_us()

    def wait_until(self, virtual_us):
        """Return when virtual time may reach `virtual_us`."""
        if not self._speed:
            return
        due_us = self._start_us + int((virtual_us - self._virtual_us) / self._speed)
        ahead_us = due_us - host_us()
        if ahead_us > 0:
            host_time.sleep(ahead_us / 1000000)
        elif ahead_us < -LATE_US:
            self._start_us = host_us()
            self._virtual_us = virtual_us


class Simulation:
    """One run of the firmware, from its start to its end or to a reset."""

    def __init__(self, settings):
        scenario = settings["scenario"]
        self._start_ms = settings["start_ms"]
        self._duration_ms = settings["duration_ms"]
        self._events = [event for event in scenario["events"] if "adc" not in event and self._is_ahead(event)]
        self._faults = [event for event in scenario["events"] if "adc" in event]
        self._waveform = Waveform(scenario, settings["reference_mv"])
        self.records = Records(settings["records"], self.now_ms)
        self._wire = None
        self._main = None
        self._pace = None
        self._speed = settings["speed"]
        self._sample_ms = self._messages_ms = self._start_ms
        for gpio in settings["gpios"]:
            self._connect(machine.analog(gpio))

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
        self._replace_ports()
        import main  # noqa: PLC0415 - after everything that it must find replaced

        self._main = main
        self._pace = Pace(self._speed)
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

    def _connect(self, analog):
        analog.source = self._read
        analog.absent = any(self._holds(fault, "absent", self._start_ms) for fault in self._faults)

    def _read(self, _elapsed_us):
        now_ms = self.now_ms()
        for fault in self._faults:
            if self._holds(fault, "slow", now_ms):
                mock_time.advance_us(fault["delay_us"])
            elif self._holds(fault, "fail", now_ms) or self._holds(fault, "absent", now_ms):
                return None
        return self._waveform.count(now_ms)

    def _holds(self, fault, kind, at_ms):
        until_ms = fault["until_ms"]
        return fault["adc"] == kind and fault["at_ms"] <= at_ms and (until_ms is None or at_ms < until_ms)

    def _replace_ports(self):
        self._wire = Wire(self.records)
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
        self.records.put(
            "sample",
            true=self._waveform.millivolts(now_ms),
            reported=wire.millivolts,
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


def host_us():
    """Return microseconds of the host's clock, which only goes forward."""
    if hasattr(host_time, "monotonic_ns"):
        return host_time.monotonic_ns() // 1000
    return host_time.ticks_us()


def traceback_of(error):
    """Return the traceback of an exception as text."""
    if hasattr(sys, "print_exception"):
        import io  # noqa: PLC0415 - only where something went wrong

        text = io.StringIO()
        sys.print_exception(error, text)
        return text.getvalue()
    import traceback  # noqa: PLC0415 - MicroPython has none

    return "".join(traceback.format_exception(error))


def runtime():
    """Return the name and version of this interpreter."""
    name = "CPython" if _IS_BUFFERED else "MicroPython"
    return name + " " + ".".join(str(part) for part in sys.implementation.version[:3])


if __name__ == "__main__":
    with open(sys.argv[1]) as file:
        SETTINGS = json.load(file)
    sys.exit(Simulation(SETTINGS).run())
