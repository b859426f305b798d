# Generated from templates/tests/program/invented.py: do not edit.
# Inputs: 62b75a01622228ad
"""Messages that no dialect has, with a field of every kind, and a stream for their frames."""

from message import Message


class Invented(Message):
    """A message with fields of every kind, and every way to state what is unknown."""

    NAME = "INVENTED"
    ID = 201
    CRC_EXTRA = 7
    BASE_LENGTH = 62
    LENGTH = 93
    FIELDS = (
        "wide:q=-1 exact:d big:I=4294967295 real:f=nan ratio:2f=nan many:2I parts:3H=65535 first:3h=32767: "
        "mixed:3B=255,,0 small:b=-1 flag:B wire:B word:4s name:4s=0 late:2b letter:s row:12B "
        "under:h over:H deep:i high:I"
    )
    DEFAULTS = {"flag": 3}  # noqa: RUF012  as in messages.py


def error_of(kind, function, *arguments, **values):
    """Return the text of the error of a kind that a call raises."""
    try:
        function(*arguments, **values)
    except kind as error:
        return error.args[0]
    raise AssertionError((arguments, values, "is accepted"))


class Tiny(Message):
    """A message that is read at a glance."""

    NAME = "TINY"
    ID = 202
    LENGTH = BASE_LENGTH = 8
    FIELDS = "a:B b:2h=-1 c:3s"


class Wire:
    """A stream that keeps frames; `takes` is what its next writes say, or raise."""

    def __init__(self, *takes):
        self.takes = list(takes)
        self.frames = []

    def write(self, frame):
        """Take all, or what is told."""
        self.frames.append(bytes(frame))
        told = self.takes.pop(0) if self.takes else len(frame)
        if isinstance(told, Exception):
            raise told
        return told
