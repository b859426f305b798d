# Generated from templates/mocks/sim_records.py: do not edit.
# Inputs: 0fbedb4cdc58686a
"""The file that gets what happens in a simulation, a line of JSON for each record; see sim.py."""

import json
import sys

IS_BUFFERED = sys.implementation.name != "micropython"
_SEVERITIES = (("error: ", 3), ("warning: ", 4), ("notice: ", 5))


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
        if IS_BUFFERED:
            self._file.flush()

    def hear(self, line):
        """Take a line of the firmware's texts, `error: ...` as it is printed on the board's console."""
        for prefix, severity in _SEVERITIES:
            if line.startswith(prefix):
                self.put("text", severity=severity, text=line[len(prefix) :])
                return
        self.put("text", severity=6, text=line)


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
    name = "CPython" if IS_BUFFERED else "MicroPython"
    return name + " " + ".".join(str(part) for part in sys.implementation.version[:3])
