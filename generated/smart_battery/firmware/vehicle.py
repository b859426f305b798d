# Generated from specs/smart_battery/board.yaml, specs/smart_battery/codegen.yaml,
#   specs/smart_battery/parameters.yaml, specs/smart_battery/state.yaml,
#   specs/smart_battery/vehicle.yaml, dialect common: do not edit.
# Inputs: 4c55958749ed583e
"""The vehicle: all that the program consists of, and the calls that the user's code overrides."""

import asyncio
import gc
from time import ticks_diff, ticks_ms, ticks_us

import machine
import messages
import watchdog
from board import Board
from connection import Connection
from guard import Guard
from micropython import const
from parameters import Parameters
from scheduler import AGAIN, Scheduler
from services import receivable
from state import SystemState
from storage import Storage
from streams import Streams, open_link
from texts import Texts
from twins import watch_twins

CONTROL_US = 50000  # 20 Hz (FR-00071)
LINKS_US = 50000  # 20 Hz
_JOBS = const(6)  # in a pass, at most
REPORT_US = 10000000  # between two texts about missed slots

STEP_LIMIT_US = 10000  # for a step of a save (NFR-00061)

_SAVE_MS = const(100)  # how often it is looked whether there is something to save
_UNSETTLED_MS = const(10000)  # settings that keep coming are saved meanwhile
_COST_MS = const(60000)  # of a save, for flash wears out: one in a minute,
_CREDIT_MS = const(600000)  # and as many at once as this is worth
_LEAVE_MS = const(2000)  # a restart waits no longer for settings that keep coming
_REMIND_S = const(30)  # between two reminders of lost settings
_FAREWELL_MS = const(500)  # what is on its way to ground stations leaves before a restart


class Vehicle:
    """The pack. Code of its own derives a class Pack from this one, in a module pack, and overrides the calls.

    `texts` is what everything logs to, `connections` are the links to ground stations; `restart_ms` is None, or the
    time.ticks_ms() when a restart was asked for. A board or ports that are given are used in place of the real ones.
    """

    MESSAGES = 8  # that a link takes in or sends in a pass
    SILENCE_MS = 10000  # without a HEARTBEAT: then a ground station is gone

    def __init__(self, board=None, ports=None, texts=None):
        self.texts = Texts() if texts is None else texts
        self.parameters = Parameters()
        self.storage = Storage(("parameters.0", "parameters.1"), 64)
        self._load_parameters()
        self._saved = self._seen = self.parameters.changes
        self._failed_ms = None  # when a save failed last
        self._unsettled_ms = 0  # for how long settings have been coming
        self._credit_ms = _CREDIT_MS
        self._is_limited = False
        self._guard = Guard()
        self.board = Board(self.texts, self.parameters) if board is None else board
        self.state = SystemState(self.parameters, self.texts)
        self.restart_ms = None
        self._reported = 0
        self._started = watchdog.reset_reason()
        self.texts(self._started)
        # The order within a pass (FR-00071): control, readings, links.
        self.scheduler = Scheduler(CONTROL_US, self.control, self.texts, None, _JOBS)
        self.scheduler.every(100000, self.measure, "measure")  # FR-00074.9
        self.scheduler.every(100000, self._watch_battery, "battery")  # FR-00067.1
        self.scheduler.every(LINKS_US, self._communicate, "links")
        self.scheduler.every(REPORT_US, self._report, "report")
        self._quiet_s = _REMIND_S
        self.scheduler.every(1000000, self._remind, "reminder")
        ports = self.board.open_ports() if ports is None else ports
        self.connections = [self._connect(port) for port in ports]

    # What the user's code overrides.

    def control(self):
        """Called at 20 Hz. What takes long makes the program miss slots."""

    def measure(self):
        """Read sensors of your own into `self.state`: called at 10 Hz, before the readings. What fails is logged."""

    # What ground stations and the user's code ask for.

    def reboot(self, force=False):  # noqa: ARG002  nothing here has to be forced
        """Save the parameters and start again soon. Nothing keeps it from that, so that it returns None."""
        if self.restart_ms is None:
            self.restart_ms = ticks_ms()
            self._failed_ms = None  # one more attempt to save

    def run_pass(self):
        """Do what is due now; return the microseconds until the next pass."""
        return self.scheduler.run_pass()

    async def run(self):
        """Run until somebody asks for a restart."""
        gc.collect()
        tasks = [asyncio.create_task(self.scheduler.run())]
        feed = watchdog.start(self.texts)
        if feed is not None:
            tasks.append(asyncio.create_task(watchdog.watch(self, feed)))
        await self._keep_parameters()
        for task in tasks:
            task.cancel()
        machine.reset()

    # Jobs of the main loop.

    def _watch_battery(self):
        self.state.update_battery(self.board)

    def _communicate(self):
        now_ms = ticks_ms()
        is_left = False
        for connection in self.connections:
            if connection.run(now_ms):
                is_left = True
        return AGAIN if is_left else None

    def _report(self):
        missed = self.scheduler.overruns
        if missed != self._reported:
            self.texts("warning: missed control slots:", missed - self._reported)
            self._reported = missed
        for connection in self.connections:
            connection.report()

    def remind(self):
        """Let what stands be said within a second: somebody has come who has not heard it."""
        self._quiet_s = 1
        self.texts(self._started)

    def _remind(self):
        """Say again what was lost."""
        self._quiet_s -= 1
        if self._quiet_s > 0:
            return
        self._quiet_s = _REMIND_S
        if self._stored_problem is not None:
            self.texts("warning:", self._stored_problem)

    # Links and parameters.

    def _connect(self, port):
        link = open_link(
            port,
            receivable(messages.SmartBatteryInfo, messages.BatteryInfo),
            self.parameters.sysid_thismav,
            self.parameters.compid_batt,
        )
        connection = Connection(self, port, link, lambda budget: Streams(self.state, link, budget))
        # Who uses the same ids is told (FR-00074.10).
        watch_twins(
            connection,
            self.texts,
            "COMPID_BATT",
            ((370, 21, 16, 18), (372, 58, 32, 44)),
            "BATT_ID",
            range(self.parameters.batt_id, self.parameters.batt_id + 1),
        )
        return connection

    def _load_parameters(self):
        stored = self.storage.load()
        self._stored_problem = self.storage.problem  # until parameters are saved anew
        self._has_lost = False
        if self._stored_problem is not None:
            self._has_lost = stored is None  # a power cut during a save leaves the ones before it
            what = "have their defaults" if self._has_lost else "are those of an earlier save"
            self._stored_problem = f"parameters {what}: {self._stored_problem}"
            self.texts("warning:", self._stored_problem)
        for problem in self.parameters.restore(stored or b""):
            self.texts("warning:", problem)

    async def _keep_parameters(self):
        """Save what changes, a step at a time, until a restart is due."""
        while not self._is_leaving():
            await asyncio.sleep_ms(_SAVE_MS)
            if self._is_due_to_save():
                await self._save()

    def _is_due_to_save(self):
        """Return whether there is something to save: settings that come in a burst are saved together."""
        changes = self.parameters.changes
        self._credit_ms = min(self._credit_ms + _SAVE_MS, _CREDIT_MS)
        self._unsettled_ms = 0 if changes == self._seen else self._unsettled_ms + _SAVE_MS
        self._seen = changes
        if self._failed_ms is not None:
            if ticks_diff(ticks_ms(), self._failed_ms) < REPORT_US // 1000:
                return False
            self._failed_ms = None
        if changes == self._saved:
            return False
        return self.restart_ms is not None or (self._has_credit() and not 0 < self._unsettled_ms < _UNSETTLED_MS)

    def _has_credit(self):
        """Return whether another save does not wear the flash; that there have been too many is told once."""
        if self._credit_ms == _CREDIT_MS:
            self._is_limited = False
        elif self._credit_ms < _COST_MS and not self._is_limited:
            self._is_limited = True
            self.texts("notice: parameters change so often: saved once a minute")
        return self._credit_ms >= _COST_MS

    async def _save(self):
        changes = self.parameters.changes
        self._unsettled_ms = longest_us = 0
        self._credit_ms -= _COST_MS
        with self._guard:
            self.storage.begin(self.parameters.dump())
        problem = self._guard.error  # others use the guard meanwhile
        while self.storage.is_saving:
            longest_us = max(longest_us, self._save_step())
            await asyncio.sleep_ms(1)
        problem = problem or self.storage.problem
        if problem is None:
            # What was damaged is written over as well: once more, for the saves take turns.
            self._saved = changes if self._stored_problem is None else None
            self._stored_problem = None
            self._has_lost = False
        else:
            self._failed_ms = ticks_ms()  # it is tried again
            self.texts("error: parameters are not saved:", problem)
        if longest_us > STEP_LIMIT_US:
            self.texts("warning: a step of a save took us:", longest_us)

    def _save_step(self):
        """Do one step of a save; return how many microseconds it took."""
        started_us = ticks_us()
        self.storage.step()
        return ticks_diff(ticks_us(), started_us)

    def _is_leaving(self):
        if self.restart_ms is None:
            return False
        waited_ms = ticks_diff(ticks_ms(), self.restart_ms)
        is_saved = self.parameters.changes == self._saved or self._failed_ms is not None
        return waited_ms >= (_FAREWELL_MS if is_saved else _LEAVE_MS)
