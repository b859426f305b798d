# Generated from templates/firmware/program/texts.py, dialect common: do not edit.
# Inputs: a0cf4c0d5f1a062b
"""Texts for people: printed on the board, and kept until every link has sent them as STATUSTEXT."""

from guard import Guard
from micropython import const

# Numbers of the dialect.
_MAV_SEVERITY_ERROR = const(3)
_MAV_SEVERITY_INFO = const(6)
_MAV_SEVERITY_NOTICE = const(5)
_MAV_SEVERITY_WARNING = const(4)

_CAPACITY = const(16)
_SEVERITIES = {
    "error: ": _MAV_SEVERITY_ERROR,
    "warning: ": _MAV_SEVERITY_WARNING,
    "notice: ": _MAV_SEVERITY_NOTICE,
}
_PREFIXES = {severity: prefix for prefix, severity in _SEVERITIES.items()}


class Texts:
    """The newest `capacity` texts. An instance is what the firmware calls as `log`; it never raises.

    `echo` gets each text at once, with its severity in front where that is more than information. `last` is the
    number of the newest text, 0 before the first: a link that remembers the number it has sent knows what is missing.
    """

    def __init__(self, echo=print, capacity=_CAPACITY):
        self.last = 0
        self._echo = echo
        self._guard = Guard()
        self._ring = [None] * capacity

    def __call__(self, *words):
        """Keep what print() would show of `words`; "error: ", "warning: " or "notice: " in front is the severity."""
        text = self._joined(words)
        for prefix, severity in _SEVERITIES.items():
            if text.startswith(prefix):
                self.say(severity, text[len(prefix) :])
                return
        self.say(_MAV_SEVERITY_INFO, text)

    def say(self, severity, text):
        """Keep a text with its MAV_SEVERITY; what is worse than an error is echoed as one."""
        self.last += 1
        self._ring[self.last % len(self._ring)] = (severity, text)
        prefix = _PREFIXES.get(max(severity, _MAV_SEVERITY_ERROR), "")
        with self._guard:  # nobody may be there to read it, which is no reason to stop
            self._echo(prefix + text)

    def get(self, number):
        """Return severity and text of a number up to `last`; None where it is overwritten, or not there yet."""
        if not max(0, self.last - len(self._ring)) < number <= self.last:
            return None
        return self._ring[number % len(self._ring)]

    def _joined(self, words):
        with self._guard:
            return " ".join([str(word) for word in words])
        return f"error: a text cannot be shown: {type(self._guard.error).__name__}"
