"""Texts are kept with their severity, numbered, and echoed."""

from checks import run
from texts import Texts


class Echo:
    """Keeps what it is given."""

    def __init__(self):
        self.lines = []

    def __call__(self, line):
        self.lines.append(line)


class Unspeakable:
    """Cannot be shown."""

    def __str__(self):
        raise ValueError("no")

    __repr__ = __str__


def fresh(capacity=16):
    echo = Echo()
    return Texts(echo, capacity), echo.lines


def words_become_a_text():
    texts, lines = fresh()
    texts("the count is", 3, "of", None)
    assert texts.get(1) == (6, "the count is 3 of None")
    assert lines == ["the count is 3 of None"]


def prefix_is_the_severity():
    texts, lines = fresh()
    texts("error: it", "broke")
    texts("warning: it may")
    texts("notice:", "it does")
    texts("an error: not in front")
    texts("Error: capital letters")
    kept = [texts.get(number) for number in range(1, 6)]
    assert kept[:3] == [(3, "it broke"), (4, "it may"), (5, "it does")], kept
    assert kept[3:] == [(6, "an error: not in front"), (6, "Error: capital letters")], kept
    assert lines[:3] == ["error: it broke", "warning: it may", "notice: it does"], lines
    assert lines[3:] == ["an error: not in front", "Error: capital letters"], lines


def severity_is_said():
    texts, lines = fresh()
    for severity in (0, 2, 3, 4, 5, 6, 7):
        texts.say(severity, "this")
    assert [texts.get(number)[0] for number in range(1, 8)] == [0, 2, 3, 4, 5, 6, 7]
    assert lines == ["error: this"] * 3 + ["warning: this", "notice: this", "this", "this"], lines


def ring_keeps_the_newest():
    texts, _ = fresh(3)
    assert texts.last == 0
    for number in (-1, 0, 1, 3):
        assert texts.get(number) is None
    for number in range(1, 8):
        texts(number)
        assert texts.last == number
        kept = [text for text in [texts.get(other) for other in range(-3, 12)] if text is not None]
        assert kept == [(6, str(other)) for other in range(max(1, number - 2), number + 1)], kept
        assert texts.get(number) == (6, str(number))
        assert texts.get(number + 1) is None
        assert texts.get(number - 3) is None


def broken_echo_is_no_reason_to_stop():
    def broken(_line):
        raise OSError(5)

    texts = Texts(broken)
    texts("warning: heard by nobody")
    assert texts.get(1) == (4, "heard by nobody")


def broken_words_are_no_reason_to_stop():
    texts, lines = fresh()
    texts("it is", Unspeakable())
    assert texts.get(1) == (3, "a text cannot be shown: ValueError"), texts.get(1)
    texts()
    assert texts.get(2) == (6, "")
    assert lines == ["error: a text cannot be shown: ValueError", ""]


def exception_is_shown():
    texts, _ = fresh()
    texts("error: no ADC:", OSError(19))
    assert "19" in texts.get(1)[1]


run(
    words_become_a_text,
    prefix_is_the_severity,
    severity_is_said,
    ring_keeps_the_newest,
    broken_echo_is_no_reason_to_stop,
    broken_words_are_no_reason_to_stop,
    exception_is_shown,
)
