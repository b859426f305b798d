"""A vehicle with the outside of the generated one, as far as a simulation sees it: it tries that, not the firmware."""

import asyncio
import time

import messages
from board import Board
from parameters import Parameters
from serial_port import open_usb
from state import SystemState
from streams import Streams, open_link
from texts import Texts
from udp_port import UdpPort

vehicle = None

LEVELS = {"BATT_LOW_VOLT": 10.5, "BATT_CRT_VOLT": 9.9}
TIMER_MS = 10000


class Levels(Parameters):
    """The parameters, and the thresholds of the failsafe."""

    def names(self):
        return sorted(Parameters.names(self) + list(LEVELS))

    def get(self, name):
        return LEVELS[name] if name in LEVELS else Parameters.get(self, name)


class Failsafe:
    """A failsafe as far as a simulation sees it."""

    title = "Battery 1"
    level = 0


class Scheduler:
    overruns = 0


class Connection:
    def __init__(self, port, state):
        self.port = port
        self.link = open_link(port)
        self.streams = Streams(state, self.link)

    def run(self, now_ms):
        data = self.port.read()
        if data:
            self.link.put(data)
            while self.link.receive():
                pass
        self.streams.run(now_ms)
        self.port.poll(now_ms)


class Vehicle:
    def __init__(self):
        self.texts = Texts()
        self.parameters = Levels()
        self.board = Board(self.texts)
        self.state = SystemState(self.parameters, self.texts)
        self.scheduler = Scheduler()
        open_usb("usb", 256)
        self.connections = [Connection(UdpPort("wifi", None, 14550, 0, "wifi.json", 5000, self.texts), self.state)]
        self.is_armed = False
        self._below = {}
        self.battery_failsafes = [Failsafe()]
        self._update_ms = 0

    def arm(self, force=False):
        if not self._first().healthy and not force:
            self.texts("error: PreArm: Battery 1 unhealthy")
            return "PreArm: Battery 1 unhealthy"
        self.is_armed = self.state.vehicle.armed = True
        self.state.vehicle.status = 4
        return None

    def disarm(self, force=False):
        self.is_armed = self.state.vehicle.armed = False
        self.state.vehicle.status = 3

    def _first(self):
        battery = self.state.battery
        return battery[0] if isinstance(battery, list) else battery

    def control(self):
        pass

    def run_pass(self):
        self.control()
        now_ms = time.ticks_ms()
        if now_ms >= self._update_ms:
            self._update_ms += 100
            self.state.update_battery(self.board)
            self._watch(now_ms)
        for connection in self.connections:
            connection.run(now_ms)

    def _watch(self, now_ms):
        voltage = self._first().voltage
        failsafe = self.battery_failsafes[0]
        for number, (name, level) in enumerate((("low", 10.5), ("critical", 9.9)), 1):
            if not self.is_armed or (voltage and voltage >= level):
                self._below.pop(name, None)
            elif voltage and now_ms - self._below.setdefault(name, now_ms) >= TIMER_MS and failsafe.level < number:
                failsafe.level = number
                self.state.vehicle.status = 5
                self.texts(f"warning: Battery 1 is {name} {voltage:.2f}V used 0 mAh")

    async def run(self):
        while True:
            self.run_pass()
            await asyncio.sleep_ms(10)


def main():
    global vehicle
    try:
        from rover import Rover
    except ImportError:
        Rover = Vehicle
    vehicle = Rover()
    vehicle.texts(messages.Heartbeat.NAME, "follows")
    asyncio.run(vehicle.run())
