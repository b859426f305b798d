"""Records exceptions that the firmware catches itself: a board goes on after one, and a simulation has to tell it."""

from sim_records import traceback_of

_MOST = 20  # different ones: one that comes again and again is told once


class Failures:
    """The exceptions of the main loop and its jobs, and of the connections, each with where it was raised."""

    def __init__(self, records):
        self._records = records
        self._known = set()

    def listen(self):
        """Hear of what the firmware's own modules catch from now on."""
        from connection import Connection  # noqa: PLC0415 - the firmware's own, after what it must find replaced
        from scheduler import Scheduler  # noqa: PLC0415

        note, report = Connection._note, Scheduler._report

        def noted(connection, error, now_ms):
            self._take(connection.port.name, error)
            note(connection, error, now_ms)

        def reported(scheduler, slot, error):
            self._take(slot.name, error)
            report(scheduler, slot, error)

        Connection._note, Scheduler._report = noted, reported

    def _take(self, name, error):
        what = (name, repr(error))
        if what not in self._known and len(self._known) < _MOST:
            self._known.add(what)
            self._records.put("caught", name=name, traceback=traceback_of(error))
