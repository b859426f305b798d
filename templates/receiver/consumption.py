"""The rate at which charge is drawn: the mean current over the last while."""

from readings import elapsed

POINTS = 20  # how finely the time is divided that a mean is taken over


class _Rise:
    """The rate of a total over the last `window_ms`: from its value about that long ago to the newest one."""

    def __init__(self, window_ms):
        self._window_ms = window_ms
        self._spacing_ms = window_ms // POINTS
        self._points = []  # pairs of time and total, about POINTS of them however often something comes

    def forget(self):
        self._points = []

    def note(self, now_ms, total):
        points = self._points
        while len(points) > 1 and elapsed(now_ms, points[1][0]) >= self._window_ms:
            points.pop(0)
        if len(points) > 1 and elapsed(now_ms, points[-2][0]) < self._spacing_ms:
            points.pop()
        points.append((now_ms, total))

    def per_ms(self, shortest_ms):
        """Return the rise per millisecond, or None if it was not watched for so long."""
        if not self._points:
            return None
        span_ms = elapsed(self._points[-1][0], self._points[0][0])
        if span_ms < shortest_ms:
            return None
        return (self._points[-1][1] - self._points[0][1]) / span_ms


class Consumption:
    """The mean current over the last `window_ms`.

    Where the current is known it is what was drawn, the currents times their durations, over the time that it took.
    Where it is not, it is the rise of the charge that was consumed, once that was watched for half of the window.
    After a gap of more than `gap_ms` the mean begins anew.
    """

    def __init__(self, window_ms, gap_ms):
        self._half_ms = max(window_ms // 2, 1)
        self._gap_ms = gap_ms
        self._drawn = _Rise(window_ms)  # A ms, from the currents
        self._counted = _Rise(window_ms)  # Ah, as they are told
        self.forget()

    def forget(self):
        """Begin anew: it is another one."""
        self._drawn.forget()
        self._counted.forget()
        self._total = 0
        self._current_a = None
        self._consumed_ah = None
        self._last_ms = None

    def note(self, now_ms, current_a, consumed_ah):
        """Take in what is known now; None is unknown."""
        if self._last_ms is not None and elapsed(now_ms, self._last_ms) > self._gap_ms:
            self.forget()
        self._note_current(now_ms, current_a)
        self._note_consumed(now_ms, consumed_ah)
        self._last_ms = now_ms

    def _note_current(self, now_ms, current_a):
        if current_a is None:
            self._drawn.forget()
            self._total = 0
        else:
            if self._current_a is not None:
                self._total += (self._current_a + current_a) / 2 * elapsed(now_ms, self._last_ms)
            if self._total - self._total != 0:  # a current that nothing has: the floats of a board are small
                self._drawn.forget()
                self._total = 0
            self._drawn.note(now_ms, self._total)
        self._current_a = current_a

    def _note_consumed(self, now_ms, consumed_ah):
        if consumed_ah is None or (self._consumed_ah is not None and consumed_ah < self._consumed_ah):
            self._counted.forget()  # less than before: it counts anew, or it is being charged
        if consumed_ah is not None:
            self._counted.note(now_ms, consumed_ah)
        self._consumed_ah = consumed_ah

    def mean_a(self):
        """Return the mean current in A, or None while too little is known."""
        if self._current_a is not None:
            drawn = self._drawn.per_ms(1)
            return self._current_a if drawn is None else drawn
        counted = self._counted.per_ms(self._half_ms)
        return None if counted is None else counted * 3600000
