"""A board without hardware: a raw REPL on a terminal, and a file system that is a littlefs.

The unix port of MicroPython runs it: `board.py IMAGE SETTINGS`, the terminal being its stdin and stdout. IMAGE keeps
the flash while the power is off. SETTINGS is JSON: `told`, what sys.implementation says in place of the host's own;
`writes`, after how many blocks written the power goes; `path`, folders of the host whose modules it has besides;
`deaf`, that it answers nothing; `modules`, what help("modules") lists, null where it lists none: by default what the
host's own has, and network.
`watchdog`: seconds after which the watchdog of an RP2350 that an earlier program started resets the board; it is
stopped as there, or fed. `fed`: seconds of one that nothing stops.
`roms`: how many partitions for a ROMFS it has.
`heap`: how many bytes of heap it says that it has.
`counts`: what ADC.read_u16() gives, one after the other, again and again; without it there is no ADC.
`starts`: that a restart runs main.py. With power it waits, as if Ctrl-C had come; what runs cannot be interrupted.
"""

import gc
import json
import os
import select
import struct
import sys
import time
import vfs

BLOCK = 4096
WINDOW = 16384


class Flash:
    """Blocks in a file, which survive the end of the process, as flash does."""

    def __init__(self, file, count, writes):
        self._file = file
        self._count = count
        self._writes = writes

    def readblocks(self, block, buffer, offset=0):
        self._file.seek(block * BLOCK + offset)
        self._file.readinto(buffer)

    def writeblocks(self, block, buffer, offset=0):
        if self._writes == 0:
            sys.exit(9)
        self._writes -= 1
        self._file.seek(block * BLOCK + offset)
        self._file.write(buffer)
        self._file.flush()

    def ioctl(self, operation, _argument):
        return {4: self._count, 5: BLOCK, 6: 0}.get(operation)


class Reset(Exception):
    """machine.reset() was called."""


class Adc:
    """An input of a converter."""

    def __init__(self, _pin):
        self._turn = 0

    def read_u16(self):
        counts = SETTINGS["counts"]
        self._turn += 1
        return counts[self._turn % len(counts)] << 4


class Watchdog:
    """The watchdog that runs on from an earlier program: without being stopped or fed, the power goes with it."""

    def __init__(self, seconds, stops):
        self._end_ms = time.ticks_add(time.ticks_ms(), int(seconds * 1000))
        self._stops = stops
        self._timer = None

    def __getitem__(self, _address):
        return 0

    def __setitem__(self, address, word):
        if self._stops and address == 0x400DB000 and word == 0x40000000:
            self._end_ms = None

    def wdt(self, timeout):
        """machine.WDT()."""
        self._timeout_ms = timeout
        return self

    def feed(self):
        self._end_ms = time.ticks_add(time.ticks_ms(), self._timeout_ms)

    def timer(self, _number):
        """machine.Timer()."""
        return self

    def init(self, period, callback):
        self._timer = [period, time.ticks_ms(), callback]

    def soft_reset(self):
        """Timers end with it."""
        self._timer = None

    def look(self):
        now_ms = time.ticks_ms()
        if self._timer is not None and time.ticks_diff(now_ms, self._timer[1]) >= self._timer[0]:
            self._timer[1] = now_ms
            self._timer[2](self)
        if self._end_ms is not None and time.ticks_diff(now_ms, self._end_ms) > 0:
            sys.exit(9)


class Machine:
    """The parts of `machine` that the unix port lacks."""

    Pin = int
    WDT_RESET = 3
    mem32 = {0x400D801C: 0}  # noqa: RUF012

    @staticmethod
    def reset_cause():
        return 1

    @staticmethod
    def WDT(timeout):  # noqa: N802
        return WATCHDOG.wdt(timeout) if WATCHDOG is not None else Watchdog(timeout / 1000, True)

    def __getattr__(self, name):
        if name == "ADC" and "counts" in SETTINGS:
            return Adc
        if name == "Timer" and WATCHDOG is not None:
            return WATCHDOG.timer
        return getattr(MACHINE, name)

    @staticmethod
    def reset():
        raise Reset


class Heap:
    """A module gc that says of a heap of so many bytes that a quarter is taken."""

    def __getattr__(self, name):
        return getattr(gc, name)

    def mem_alloc(self):
        return SETTINGS["heap"] // 4

    def mem_free(self):
        return SETTINGS["heap"] - SETTINGS["heap"] // 4


class Vfs:
    """vfs of a MicroPython with partitions for a ROMFS."""

    @staticmethod
    def rom_ioctl(operation):
        return SETTINGS["roms"] if operation == 1 else -22

    def __getattr__(self, name):
        return getattr(vfs, name)


class Told:
    """sys.implementation of another board."""

    def __init__(self, told):
        self.name = "micropython"
        for name, value in told.items():
            setattr(self, name, tuple(value) if isinstance(value, list) else value)


class Sys:
    """sys with that in it."""

    def __init__(self, told):
        self.implementation = Told(told)

    def __getattr__(self, name):
        return getattr(sys, name)


def say(text):
    OUT.write(text)


def take(count=1):
    while WATCHDOG is not None and not POLL.poll(10):
        WATCHDOG.look()
    data = IN.read(count)
    if not data:
        sys.exit(0)
    return data


def pasted():
    """The code that raw-paste mode brings, which tells how much more may come."""
    say(b"R\x01" + struct.pack("<H", WINDOW) + b"\x01")
    code = bytearray()
    told = 0
    while True:
        byte = take()
        if byte == b"\x04":
            say(b"\x04")
            return code
        code += byte
        if len(code) - told >= WINDOW // 2:
            told = len(code)
            say(b"\x01")


def run(code, names):
    """Run code as the raw REPL does; its output goes out by itself."""
    try:
        exec(compile(bytes(code).decode(), "<stdin>", "exec"), names)
    except (Reset, SystemExit):
        raise
    except BaseException as fault:
        say(b"\x04")
        sys.print_exception(fault, OUT)
    else:
        say(b"\x04")
    say(b"\x04")


def start():
    """Start main.py, if there is one, as a board with power does."""
    if not SETTINGS.get("starts"):
        return
    for name in list(sys.modules):
        if name not in KEPT:
            del sys.modules[name]
    try:
        with open("main.py") as file:
            text = file.read()
    except OSError:
        return
    try:
        exec(compile(text, "main.py", "exec"), {"__name__": "__main__"})
    except Exception as fault:
        sys.print_exception(fault, OUT)


def begun_anew():
    """The names of a board after a soft reset, which ends timers and no watchdog."""
    if WATCHDOG is not None:
        WATCHDOG.soft_reset()
    return {"__name__": "__main__", "help": list_modules}


def list_modules(_about):
    """help("modules")."""
    if SETTINGS.get("modules", "") is None:
        say("object modules is of type str\r\n")
        return
    if "modules" in SETTINGS:
        say("".join(name + "\r\n" for name in SETTINGS["modules"]) + "Plus any modules on the filesystem\r\n")
        return
    say("network\r\n")
    help("modules")


def serve():
    """The REPL, until the power goes."""
    is_raw = False
    code = bytearray()
    names = begun_anew()
    while True:
        byte = take()
        if SETTINGS.get("deaf"):
            pass
        elif byte == b"\x01":
            is_raw = True
            code = bytearray()
            say(b"raw REPL; CTRL-B to exit\r\n>")
        elif byte == b"\x02":
            is_raw = False
            code = bytearray()
            say(b"MicroPython\r\n>>> ")
        elif is_raw and byte == b"\x05":
            mode = take(2)
            if mode == b"A\x01":
                execute(pasted(), names)
                say(b">")
        elif byte == b"\x04" and is_raw and code:
            say(b"OK")
            execute(code, names)
            say(b">")
            code = bytearray()
        elif byte == b"\x04":
            say(b"OK\r\nMPY: soft reboot\r\n" if is_raw else b"\r\nMPY: soft reboot\r\n")
            names = begun_anew()
            if is_raw:
                say(b"raw REPL; CTRL-B to exit\r\n>")
            else:
                start()
        elif byte == b"\x03":
            code = bytearray()
        elif is_raw:
            code += byte


def execute(code, names):
    try:
        run(code, names)
    except Reset:
        start()


image, SETTINGS = sys.argv[1], json.loads(sys.argv[2])
IN, OUT = sys.stdin.buffer, sys.stdout.buffer
POLL = select.poll()
POLL.register(sys.stdin, select.POLLIN)
WATCHDOG = None
if "watchdog" in SETTINGS or "fed" in SETTINGS:
    WATCHDOG = Machine.mem32 = Watchdog(SETTINGS.get("watchdog") or SETTINGS["fed"], "watchdog" in SETTINGS)
MACHINE = __import__("machine")
size = os.stat(image)[6]
flash = Flash(open(image, "r+b"), size // BLOCK, SETTINGS.get("writes", -1))
sys.path[:] = ["", ".frozen", "/lib"]
paths = SETTINGS.get("path", [])
mounts = [vfs.VfsPosix(path) for path in paths]
vfs.umount("/")
try:
    vfs.mount(flash, "/")
except OSError:
    vfs.VfsLfs2.mkfs(flash)
    vfs.mount(flash, "/")
for number, mount in enumerate(mounts):
    vfs.mount(mount, f"/host{number}")
    sys.path.append(f"/host{number}")
sys.modules["machine"] = Machine()
if "heap" in SETTINGS:
    sys.modules["gc"] = Heap()
if "roms" in SETTINGS:
    sys.modules["vfs"] = Vfs()
if SETTINGS.get("told"):
    own = sys.implementation
    told = {"version": own.version, "_machine": own._machine, "_mpy": own._mpy}
    told.update(SETTINGS["told"])
    sys.modules["sys"] = Sys(told)
KEPT = set(sys.modules)
sys.stderr.write("+")
serve()
