"""Texts for the ground: the newest are kept, by number."""

import dialect

_PREFIXES = {
    "error: ": dialect.MAV_SEVERITY_ERROR,
    "warning: ": dialect.MAV_SEVERITY_WARNING,
    "notice: ": dialect.MAV_SEVERITY_NOTICE,
}


class Texts:
    """Keeps the last texts."""

    def __init__(self, capacity=16):
        self._texts = [None] * capacity
        self.last = 0

    def __call__(self, *words):
        text = " ".join([str(word) for word in words])
        for prefix, severity in _PREFIXES.items():
            if text.startswith(prefix):
                self.say(severity, text[len(prefix) :])
                return
        self.say(dialect.MAV_SEVERITY_INFO, text)

    def say(self, severity, text):
        """Keep a text."""
        self.last += 1
        self._texts[self.last % len(self._texts)] = (severity, text)

    def get(self, number):
        """Return (severity, text), None if it is gone or not there yet."""
        if not self.last - len(self._texts) < number <= self.last:
            return None
        return self._texts[number % len(self._texts)]
