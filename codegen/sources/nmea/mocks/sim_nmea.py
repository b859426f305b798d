"""True values that a receiver of satellites says on a UART, in a simulation: lines of NMEA 0183, which the driver reads."""

import machine

LEAST_MS = 200  # between two sets of lines: more would not get through at 9600 bits per second
DAY = (1, 1, 26)  # on which the simulation begins, at midnight
_QUALITY = (0, 0, 1, 1, 2, 5, 4)  # of a fix as GPS_FIX_TYPE


def connect(courses, now_ms, start_ms):
    """Return what lets the lines of each receiver arrive when they are due."""
    found = {}
    for course in courses:
        found.setdefault(course.settings["uart"], {})[course.settings["output"]] = course
    receivers = [Receiver(machine.serial(uart), outputs, start_ms) for uart, outputs in found.items()]

    def turn(at_ms, vehicle):  # noqa: ARG001
        for receiver in receivers:
            receiver.speak(at_ms)

    return turn


class Receiver:
    """A receiver at a line: what it says of its outputs, in whole steps of these."""

    def __init__(self, line, outputs, start_ms):
        self._line = line
        self._outputs = outputs
        self._every_ms = max([LEAST_MS] + [course.every_ms for course in outputs.values()])
        self._due_ms = start_ms
        line.absent = self._has("absent", start_ms)

    def speak(self, at_ms):
        """Let lines arrive, if they are due and nothing keeps them."""
        self._line.absent = self._has("absent", at_ms)
        if at_ms < self._due_ms:
            return
        self._due_ms = at_ms + self._every_ms
        if self._has("fail", at_ms) or self._line.absent:
            return
        for text in self.lines(at_ms):
            said = checksum(text) ^ (1 if self._has("garbled", at_ms) else 0)
            self._line.arrives(f"${text}*{said:02X}\r\n".encode())

    def lines(self, at_ms):
        """Return what is said at a time, without dollar and checksum."""
        value = {name: self._steps(name, at_ms) for name in self._outputs}
        latitude, longitude = value.get("latitude"), value.get("longitude")
        has_fix = latitude is not None and longitude is not None
        fix = value.get("fix", 3)
        fix = 1 if fix is None or not has_fix else min(max(fix, 0), 6)
        place = f"{angle(latitude, 2, 'NS')},{angle(longitude, 3, 'EW')}" if fix > 1 else ",,,"
        seconds = at_ms // 1000
        clock = f"{seconds // 3600 % 24:02}{seconds // 60 % 60:02}{seconds % 60:02}.{at_ms % 1000:03}"
        date = f"{DAY[0] + seconds // 86400:02}{DAY[1]:02}{DAY[2]:02}"
        hdop, vdop = decimal(value.get("hdop"), 2), decimal(value.get("vdop"), 2)
        height = decimal(value.get("altitude"), 3)
        speed = value.get("speed")
        knots = "" if speed is None else decimal((speed * 9000 + 231) // 463, 3)
        course = decimal(value.get("course"), 2)
        count = value.get("satellites")
        seen = "" if count is None else f"{count:02}"
        mode = "A" if fix > 1 else "N"
        yield f"GPGSA,A,{min(fix, 3) if fix > 1 else 1},,,,,,,,,,,,,,{hdop},{vdop}"
        yield f"GPRMC,{clock},{'A' if fix > 1 else 'V'},{place},{knots},{course},{date},,,{mode}"
        yield f"GPGGA,{clock},{place},{_QUALITY[fix]},{seen},{hdop},{height},M,,M,,"
        yield f"GPVTG,{course},T,,M,{knots},N,,K,{mode}"

    def _steps(self, name, at_ms):
        course = self._outputs[name]
        value = course.seen(at_ms)
        return None if value is None else round(value * course.settings["steps"])

    def _has(self, kind, at_ms):
        return any(course.fault(kind, at_ms) is not None for course in self._outputs.values())


def angle(steps, digits, sides):
    """Return degrees and minutes with their side; a step is 1e-7 degrees, which minutes show exactly."""
    size = abs(steps)
    minutes = size % 10000000 * 60
    return f"{size // 10000000:0{digits}}{minutes // 10000000:02}.{minutes % 10000000:07},{sides[steps < 0]}"


def decimal(steps, digits):
    """Return steps as a decimal number, nothing for None."""
    if steps is None:
        return ""
    one = 10**digits
    return f"{'-' if steps < 0 else ''}{abs(steps) // one}.{abs(steps) % one:0{digits}}"


def checksum(text):
    """Return what stands behind the star: all characters, one over the other."""
    found = 0
    for byte in text.encode():
        found ^= byte
    return found
