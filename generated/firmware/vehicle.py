# Generated from specs/board.yaml, specs/codegen.yaml, specs/parameters.yaml, specs/state.yaml,
#   specs/vehicle.yaml, dialect common: do not edit.
# Inputs: 1819130684940705
"""The vehicle: all that the program consists of, and the calls that the user's code overrides."""

import asyncio
import gc
from time import ticks_diff, ticks_ms, ticks_us

import machine
import watchdog
from board import Board
from connection import Connection
from failsafe import battery_failsafes
from guard import Guard
from micropython import const
from parameters import Parameters
from scheduler import AGAIN, Scheduler
from services import receivable
from state import SystemState
from storage import Storage
from streams import Streams, open_link
from texts import Texts

# Numbers of the dialect.
_MAV_STATE_ACTIVE = const(4)
_MAV_STATE_CRITICAL = const(5)
_MAV_STATE_STANDBY = const(3)

CONTROL_US = 2500  # 400 Hz (FR-00071)
LINKS_US = 10000  # 100 Hz
_JOBS = const(1)  # in a pass, at most
REPORT_US = 10000000  # between two texts about missed slots

STEP_LIMIT_US = 10000  # for a step of a save (NFR-00061)

_SAVE_MS = const(100)  # how often it is looked whether there is something to save
_UNSETTLED_MS = const(10000)  # settings that keep coming are saved meanwhile
_COST_MS = const(60000)  # of a save, for flash wears out: one in a minute,
_CREDIT_MS = const(600000)  # and as many at once as this is worth
_LEAVE_MS = const(2000)  # a restart waits no longer for settings that keep coming
_REMIND_S = const(30)  # between two reminders of lost settings and of what prevents arming
_FAREWELL_MS = const(500)  # what is on its way to ground stations leaves before a restart

# Where the state has what the main loop tells about the vehicle.
_VEHICLE_READY = const(1)
_VEHICLE_LOAD_DPCT = const(4)


class Vehicle:
    """The rover. Code of its own derives a class Rover from this one, in a module rover, and overrides the calls.

    `texts` is what everything logs to, `connections` are the links to ground stations; `restart_ms` is None, or the
    time.ticks_ms() when a restart was asked for. A board or ports that are given are used in place of the real ones.
    """

    FORCE_ARM = 21196  # in the command to arm: passes over the checks
    MESSAGES = 1  # that a link takes in or sends in a pass
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
        self._is_told = False
        self._guard = Guard()
        self.board = Board(self.texts, self.parameters) if board is None else board
        self.state = SystemState(self.parameters, self.texts)
        self.restart_ms = None
        self._reported = 0
        self._started = watchdog.reset_reason()
        self.texts(self._started)
        # The order within a pass (FR-00071): control, readings with their failsafes, arming checks, links.
        self.scheduler = Scheduler(CONTROL_US, self.control, self.texts, self.halt_motors, _JOBS)
        self.scheduler.every(100000, self._watch_battery, "battery")  # FR-00067.1
        self.scheduler.every(LINKS_US, self._communicate, "links")
        self.scheduler.every(REPORT_US, self._report, "report")
        self._quiet_s = _REMIND_S
        self.scheduler.every(1000000, self._remind, "reminder")  # FR-00070.12
        ports = self.board.open_ports() if ports is None else ports
        self.connections = [self._connect(port) for port in ports]
        self.battery_failsafes = battery_failsafes(self)
        self._reached = None  # the failsafe that has reached the highest level just now

    # What the user's code overrides.

    def control(self):
        """Drive: called at 400 Hz. What takes long makes the vehicle miss slots."""

    def check_arming(self):
        """Return why the vehicle must not be armed, as a text, or None."""

    def on_arm(self):
        """The vehicle is about to be armed; an exception keeps it disarmed."""

    def on_disarm(self):
        """The vehicle was disarmed."""

    def stop_motors(self):
        """Stop whatever moves: called when it is disarmed, when control() fails, and before the program ends."""

    def return_to_launch(self):
        """Drive back to where the vehicle was armed."""

    def hold(self):
        """Stop and stay."""

    def smart_return(self):
        """Drive back along the way that the vehicle came."""

    def smart_return_or_hold(self):
        """Drive back along the way that the vehicle came, or stop."""

    def terminate(self):
        """Stop the motors for good."""

    # What ground stations and the user's code ask for.

    @property
    def is_armed(self):
        """Return whether the motors may turn."""
        return self.state.vehicle.armed

    def arming_problem(self):
        """Return the first reason not to arm, as a text, or None; FR-00020.10."""
        if self._has_lost:
            return self._stored_problem
        for failsafe in self.battery_failsafes:
            problem = failsafe.problem()
            if problem is not None:
                return failsafe.title + " " + problem
        return self._own_problem()

    def _own_problem(self):
        """Return what check_arming() says, or that it failed: what cannot be asked speaks against arming."""
        with self._guard:
            return self.check_arming()
        return f"check_arming() failed: {self._guard.error!r}"

    def _is_ready(self):
        """Return whether nothing speaks against arming, without making a text of what does."""
        if self._has_lost:
            return False
        for failsafe in self.battery_failsafes:
            if failsafe.level or failsafe.is_against:
                return False
        try:
            return self.check_arming() is None
        except Exception:
            return False

    def arm(self, force=False):
        """Let the motors turn, unless a check says no; `force` passes over the checks. Return why not, or None."""
        if self.is_armed:
            return None
        if self.restart_ms is not None:
            return "PreArm: the vehicle is about to restart"
        problem = None if force else self.arming_problem()
        if problem is not None:
            return "PreArm: " + problem
        with self._guard:
            self.on_arm()
        if self._guard.error is not None:
            return f"Arm: on_arm() failed: {self._guard.error!r}"
        self.state.vehicle.armed = True
        self._set_status()
        self.texts("Armed")
        return None

    def disarm(self, force=False):  # noqa: ARG002  a vehicle can stop at any time
        """Stop the motors; nothing keeps it from that, so that it returns None."""
        if self.is_armed:
            self.state.vehicle.armed = False
            self._set_status()
            self.texts("Disarmed")
            self.halt_motors()
            with self._guard:
                self.on_disarm()
            if self._guard.error is not None:
                self.texts("error: on_disarm() failed:", repr(self._guard.error))

    def halt_motors(self):
        """Stop the motors; a fault of stop_motors() is told, and changes nothing else."""
        with self._guard:
            self.stop_motors()
        if self._guard.error is not None:
            self.texts("error: stop_motors() failed:", repr(self._guard.error))

    def reboot(self, force=False):
        """Save the parameters and start again soon; not while armed, but for `force`. Return why not, or None."""
        if self.is_armed and not force:
            return "Reboot: disarm first"
        self.disarm(force=True)
        if self.restart_ms is None:
            self.restart_ms = ticks_ms()
            self._failed_ms = None  # one more attempt to save
        return None

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
        self.halt_motors()
        machine.reset()

    # Jobs of the main loop.

    def _watch_battery(self):
        self.state.update_battery(self.board)
        self._check(self.battery_failsafes)
        words = self.state.vehicle.words
        words[_VEHICLE_READY] = 0  # a check that fails does not leave an old answer
        words[_VEHICLE_READY] = 1 if self._is_ready() else 0
        words[_VEHICLE_LOAD_DPCT] = self.scheduler.load

    def _check(self, failsafes):
        """Do what the highest level asks for that is reached just now, unless a higher one was reached before."""
        now_ms = ticks_ms()
        for failsafe in failsafes:
            if failsafe.update(now_ms):
                self._note_reached(failsafe)
        if self._reached is not None:
            self._follow_reached(failsafes)

    def _highest(self, failsafes):
        highest = 0
        for failsafe in failsafes:
            if failsafe.level > highest:  # noqa: PLR1730  max() takes longer
                highest = failsafe.level
        return highest

    def _note_reached(self, failsafe):
        if self._reached is None or failsafe.level > self._reached.level:
            self._reached = failsafe

    def _follow_reached(self, failsafes):
        acting = self._reached
        self._reached = None
        if acting.level >= self._highest(failsafes):
            self._set_status()
            self._act(acting.action())

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
        """Say again while disarmed what was lost and what speaks against arming."""
        self._quiet_s -= 1
        if self._quiet_s > 0 or self.is_armed:
            return
        self._quiet_s = _REMIND_S
        if self._stored_problem is not None:
            self.texts("warning:", self._stored_problem)
        problem = self.arming_problem()
        if problem is not None and not self._has_lost:
            self.texts("warning: PreArm:", problem)

    def _set_status(self):
        vehicle = self.state.vehicle
        vehicle.status = _MAV_STATE_ACTIVE if vehicle.armed else _MAV_STATE_STANDBY
        if self._highest(self.battery_failsafes):
            vehicle.status = _MAV_STATE_CRITICAL

    def _act(self, action):
        if action == 1:
            self.state.vehicle.mode_number = 11
            self.return_to_launch()
        elif action == 2:
            self.state.vehicle.mode_number = 4
            self.hold()
        elif action == 3:
            self.state.vehicle.mode_number = 12
            self.smart_return()
        elif action == 4:
            self.state.vehicle.mode_number = 12
            self.smart_return_or_hold()
        elif action == 5:
            try:
                self.terminate()
            finally:  # a fault in the user's code does not keep the motors turning
                self.disarm(force=True)

    # Links and parameters.

    def _connect(self, port):
        link = open_link(port, receivable(), self.parameters.sysid_thismav)
        connection = Connection(self, port, link, lambda budget: Streams(self.state, link, budget))
        connection.services.expect((43, 44, 45, 40, 51, 37, 38, 117, 11))
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
        """Save what changes, a step at a time, until a restart is due.

        Flash stands still for tens of milliseconds where it is erased: while the vehicle is armed, saving waits.
        """
        while not self._is_leaving():
            await asyncio.sleep_ms(_SAVE_MS)
            if self._is_due_to_save() and self._may_save():
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
            if self._may_save():
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

    def _may_save(self):
        if not self.is_armed:
            self._is_told = False
            return True
        if not self._is_told:
            self._is_told = True
            self.texts("notice: parameters are saved after disarming")
        return False

    def _is_leaving(self):
        if self.restart_ms is None:
            return False
        waited_ms = ticks_diff(ticks_ms(), self.restart_ms)
        is_saved = self.parameters.changes == self._saved or self._failed_ms is not None
        return waited_ms >= (_FAREWELL_MS if is_saved else _LEAVE_MS)
