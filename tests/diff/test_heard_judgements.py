"""Which changes of a program break who listens, which need a person, and which alter nothing for anybody."""

from dataclasses import dataclass
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.diff.change import Change, ChangeRule, changed
from codegen.diff.system import behaviour_rules as rules
from codegen.diff.system import heard_otherwise as judging
from codegen.source import Place

FIELDS = {
    "adc.volts": ("M.a",),
    "MULT": ("M.a", "M.b"),
    "RAW": ("M.c",),
    "MANY": ("M.a", "M.b", "M.c", "M.d"),
    "adc.many": ("M.a", "M.b", "M.c", "M.d"),
    "battery": (),
}
LINK = {"uart": 0, "baud": 9600, "udp": None, "tcp_server": None, "tcp_client": None, "to": None, "local_port": 0}
_NOBODY: dict[str, Any] = {"program": None, "system_parameter": None, "component_parameter": None}
_TOLD = {"told": ("M.d",), "many": FIELDS["MANY"]}
LATER = "whether it is heard often enough: 1 times a second and no longer 2"
SILENT = "who does not ask for it hears nothing"
UNASKED = "who asks for the data stream 10 gets no answer"
TAKEN = "R.a, received"
WIRED = "whether the board was changed with it"


@pytest.fixture(autouse=True)
def fields(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where numbers go in both versions of the program."""
    monkeypatch.setattr(judging, "fields_by_source", lambda _: FIELDS)
    monkeypatch.setattr(judging, "scaling_parameters", lambda _: {"MULT": ("q",)})
    monkeypatch.setattr(judging, "told_of_fact", lambda _, __, fact: _TOLD.get(fact, ()))
    monkeypatch.setattr(judging, "default_rate", lambda message: message.rate)


@dataclass(frozen=True)
class Generations:
    """Those of a message of which one is chosen."""

    default: str

    def names(self, choice: str) -> tuple[str, ...]:
        return {"old": ("V1",), "both": ("V1", "V2"), "new": ("V2",)}[choice]


def program(**parts: Any) -> Any:
    """A program with little in it."""
    nothing: dict[str, Any] = {"messages": (), "streams": {}, "channels": {}, "links": (), "components": {}}
    return SimpleNamespace(**{**nothing, "parameters": {}, "generations": (), **_NOBODY, **parts})


def sent(rate: int, stream: str | None = "S", *, unknown: int = 0, by: str = "") -> Any:
    """A program with one message; ``by`` is the key that sends it, or nothing."""
    table = {"name": "M", "rate": Fraction(rate), "stream": stream, "withheld_for": (None,) * unknown}
    own = {
        "on_connection": by == "on_connection",
        "on_change": SimpleNamespace(path="a.b") if by == "on_change" else None,
    }
    return program(messages=(SimpleNamespace(**table, **own),))


def stream(rate: int, fastest: int = 50, number: int | None = 10, name: str = "S") -> Any:
    told = {"default_rate": Fraction(rate), "fastest": Fraction(fastest), "data_stream": number}
    return program(streams={name: SimpleNamespace(name=name, **told)})


def parameter(name: str, default: int, step: int = 1) -> Any:
    found = SimpleNamespace(name=name, default=default, step=Fraction(step), siblings=())
    told = program(parameters={name: found})
    if name == "RATE":  # which the stream is told by
        told.streams["S"] = SimpleNamespace(parameter=found)
    return told


def channel(name: str = "volts", gpio: int = 26, pin: str | None = None, reference: int = 3, scale: int = 4095) -> Any:
    named = None if pin is None else SimpleNamespace(name=pin)
    found = SimpleNamespace(gpio=gpio, pin=named, reference=Fraction(reference), full_scale=scale)
    return program(channels={name: found})


def link(kind: str = "uart", *, name: str = "radio", **changes: Any) -> Any:
    spec = SimpleNamespace(**{**LINK, "tx": 0, "rx": 1, "credentials": None, **changes})
    return program(links=(SimpleNamespace(name=name, kind=kind, spec=spec),))


def instances(number: int, name: str = "battery") -> Any:
    return program(components={name: SimpleNamespace(parts=(None,) * number)})


def taken(factor: int, low: int = 0, high: int = 9, scale: int = 1) -> Any:
    """A program that takes one field of a message."""
    quantity = SimpleNamespace(stored=SimpleNamespace(scale=Fraction(scale)))
    own = {"factor": Fraction(factor), "low": Fraction(low), "high": Fraction(high), "quantity": quantity}
    field = SimpleNamespace(label="a", spec=SimpleNamespace(rounding="nearest"), **own)
    return program(receptions=(SimpleNamespace(name="R", fields=(field,)),))


def generations(choice: str) -> Any:
    return program(generations=(Generations(choice),))


def judged(rule: ChangeRule, subject: str, old: Any, new: Any, texts: tuple[str | None, str | None]) -> Change:
    place = Place("specs/state.yaml", 1, 1)
    (found,) = judging.heard_otherwise([changed(rule, subject, *texts, (place, place))], old, new)
    return found


@pytest.mark.parametrize(
    ("rule", "subject", "old", "new", "breaks", "said"),
    [
        (rules.MESSAGE_STREAM, "M", sent(2), sent(0, None), True, SILENT),
        (rules.MESSAGE_STREAM, "M", sent(2), sent(0), True, SILENT),
        (rules.MESSAGE_STREAM, "M", sent(2), sent(1), False, LATER),
        (rules.MESSAGE_STREAM, "M", sent(2), sent(2), False, ""),
        (rules.MESSAGE_STREAM, "M", sent(1), sent(2), False, ""),
        (rules.MESSAGE_STREAM, "M", sent(0, None), sent(0, None), False, ""),
        (rules.MESSAGE_STREAM, "M", sent(0, None), sent(2), False, ""),
        (
            *(rules.MESSAGE_STREAM, "M", sent(2), sent(2, unknown=1), False),
            "whether receivers take its silence for a lost link while something is unknown",
        ),
        (rules.MESSAGE_STREAM, "M", sent(2, unknown=1), sent(2, unknown=1), False, ""),
        (rules.MESSAGE_STREAM, "M", sent(2, unknown=2), sent(2, unknown=1), False, ""),
        (rules.MESSAGE_STREAM, "gone", sent(2), sent(1), False, ""),
        (rules.MESSAGE_STREAM, "M", sent(2), program(), False, ""),
        (rules.MESSAGE_STREAM, "M", program(), sent(1), False, ""),
        (rules.MESSAGE_STREAM, "M", sent(2), sent(0, None, unknown=1), True, SILENT),
        (rules.STREAM_RATE, "stream S", stream(2), stream(1), False, LATER),
        (rules.STREAM_RATE, "stream S", stream(2), stream(0), True, SILENT),
        (rules.STREAM_RATE, "stream S", stream(2), stream(2), False, ""),
        (rules.STREAM_RATE, "stream S", stream(2, number=None), program(), False, ""),
        (rules.STREAM_REMOVED, "stream S", stream(2), program(), True, UNASKED),
        (rules.STREAM_REMOVED, "stream S", stream(2, number=None), program(), False, ""),
        (
            *(rules.STREAM_REMOVED, "stream S", stream(2), stream(2, name="T"), False),
            "whether who asks for the data stream 10 means T",
        ),
        (rules.STREAM_RATE, "stream S", stream(2), stream(2, number=11), True, UNASKED),
        (rules.STREAM_RATE, "stream S", stream(2, number=None), stream(2), False, ""),
        (
            *(rules.STREAM_RATE, "stream S", stream(2), stream(2, 20), False),
            "whether 20 times a second is enough for who asks for more",
        ),
        (rules.STREAM_RATE, "stream S", stream(2, 20), stream(2), False, ""),
        (rules.STREAM_RATE, "stream S", program(), stream(2), False, ""),
        (
            *(rules.PARAMETER_DEFAULT, "MULT", parameter("MULT", 4, 3), parameter("MULT", 5, 2), False),
            "the same reading is 5/6 times what it was in M.a, M.b, where no value is stored",
        ),
        (
            *(rules.PARAMETER_DEFAULT, "MULT", parameter("MULT", 0), parameter("MULT", 5), False),
            "whether other numbers in M.a, M.b are meant, where no value is stored",
        ),
        (
            *(rules.PARAMETER_DEFAULT, "RAW", parameter("RAW", 4), parameter("RAW", 5), False),
            "whether other numbers in M.c are meant, where no value is stored",
        ),
        (
            *(rules.PARAMETER_DEFAULT, "MANY", parameter("MANY", 4), parameter("MANY", 5), False),
            "whether other numbers in M.a, M.b, M.c and 1 more are meant, where no value is stored",
        ),
        (
            *(rules.CHANNEL, "adc.many", channel("many"), program(), True),
            "nothing is measured for M.a, M.b, M.c and 1 more",
        ),
        (
            *(rules.FACT, "board.battery.many", program(), program(), False),
            "whether 4 is what receivers are to be told in M.a, M.b, M.c and 1 more",
        ),
        (rules.FACT, "board.battery.other.one", program(), program(), False, ""),
        (
            *(rules.PARAMETER_DEFAULT, "NOWHERE", parameter("NOWHERE", 4), parameter("NOWHERE", 5), False),
            "whether what it decides is meant, where no value is stored",
        ),
        (rules.PARAMETER_DEFAULT, "RATE", parameter("RATE", 4), parameter("RATE", 5), False, ""),
        (rules.CHANNEL, "adc.volts", channel(), program(), True, "nothing is measured for M.a"),
        (rules.CHANNEL, "adc.none", channel("none"), program(), False, ""),
        (rules.CHANNEL, "adc.volts", program(), channel(), False, ""),
        (rules.CHANNEL, "adc.none", channel("none"), channel("none", reference=2), False, ""),
        (
            *(rules.CHANNEL, "adc.volts", channel(), channel(reference=2), False),
            "the same count is 2/3 times what it was in M.a",
        ),
        (
            *(rules.CHANNEL, "adc.volts", channel(), channel(scale=1365), False),
            "the same count is 3 times what it was in M.a",
        ),
        (rules.CHANNEL, "adc.volts", channel(), channel(gpio=27), False, "M.a are measured at another pin"),
        (rules.CHANNEL, "adc.volts", channel(pin="A"), channel(pin="B"), False, "M.a are measured at another pin"),
        (rules.CHANNEL, "adc.volts", channel(pin="A"), channel(pin="A"), False, ""),
        (rules.LINK, "link.radio", link(), program(), True, "who listens on it hears nothing"),
        (rules.LINK, "link.radio", link(), link("udp"), True, "who listens on it hears nothing"),
        (rules.LINK, "link.radio", program(), link(), False, ""),
        (rules.LINK, "link.radio", link(name="other"), link(), False, ""),
        *(
            (rules.LINK, "link.radio", link(), link(**{key: 7}), True, "who listens as before hears nothing")
            for key in LINK
        ),
        (rules.LINK, "link.radio", link(), link(tx=7), False, "whether the wiring was changed with it"),
        (rules.LINK, "link.radio", link(), link(rx=7), False, "whether the wiring was changed with it"),
        (rules.LINK, "link.radio", link(), link(), False, ""),
        (rules.INSTANCES, "battery", instances(3), instances(1), True, "nothing is told of 2 of them"),
        (rules.INSTANCES, "battery", instances(2), instances(2), False, ""),
        (rules.INSTANCES, "battery", instances(1), instances(2), False, ""),
        (rules.INSTANCES, "battery", instances(2, "other"), instances(1), False, ""),
        (rules.INSTANCES, "battery", instances(2), instances(1, "other"), False, ""),
        (
            *(rules.FACT, "board.battery.told", program(), program(), False),
            "whether 4 is what receivers are to be told in M.d",
        ),
        (rules.FACT, "board.battery.other", program(), program(), False, ""),
        (
            *(rules.GENERATIONS, "generations", generations("both"), generations("new"), False),
            "whether anybody still needs V1, not sent by default",
        ),
        (rules.GENERATIONS, "generations", generations("old"), generations("both"), False, ""),
        (rules.QUANTITY_UNIT, "battery.voltage", program(), program(), False, ""),
        (rules.TAKEN_AS, TAKEN, taken(1), taken(2), False, "whether who sends it means the other amount"),
        (rules.TAKEN_AS, TAKEN, taken(2), taken(1, scale=2), False, ""),
        (rules.TAKEN_AS, TAKEN, taken(1), program(receptions=()), False, ""),
        (rules.TAKEN_AS, TAKEN, program(receptions=()), taken(1), False, ""),
        (
            *(rules.TAKEN_RANGE, TAKEN, taken(1), taken(1, 1), False),
            "whether what is ignored now is sent, which nothing tells",
        ),
        (rules.TAKEN_RANGE, TAKEN, taken(1), taken(1, -1), False, ""),
        (rules.TAKEN_RANGE, TAKEN, taken(1), taken(2, 1), False, ""),
        (rules.TAKEN_RANGE, TAKEN, taken(1), program(receptions=()), False, ""),
    ],
)  # fmt: skip
def test_a_change_is_judged(rule: ChangeRule, subject: str, old: Any, new: Any, breaks: bool, said: str) -> None:
    """By what an old ground station hears of the new vehicle."""
    fact = subject.rpartition(".")[2]
    found = judged(rule, subject, old, new, (f"{fact} 3", f"{fact} 4"))
    assert (found.effect or found.doubt) == said
    assert found.is_breaking is breaks
    assert bool(found.doubt) is bool(said and not breaks)


@pytest.mark.parametrize("key", ["on_connection", "on_change"])
def test_what_is_sent_by_itself_is_heard_without_a_stream(key: str) -> None:
    """Less often than before, which a person has to judge where nothing else is known."""
    old, new = sent(2), sent(1, None, by=key)
    assert judged(rules.MESSAGE_STREAM, "M", old, new, ("S", "on request")).doubt == LATER
    assert judged(rules.MESSAGE_STREAM, "M", old, sent(0, "T", by=key), ("S", "T")).effect == SILENT
    unsure = judged(rules.MESSAGE_STREAM, "M", old, sent(0, None, unknown=1, by=key), ("S", "on request"))
    assert "take its silence" in unsure.doubt
    on_a_stream = judged(rules.MESSAGE_STREAM, "M", old, sent(0, "T", unknown=1), ("S", "T"))
    assert "take its silence" in on_a_stream.doubt


@pytest.mark.parametrize("texts", [(None, "told 4"), ("told 3", None)])
def test_a_fact_that_comes_or_goes_is_no_other_number(texts: tuple[str | None, str | None]) -> None:
    assert not judged(rules.FACT, "board.battery.told", program(), program(), texts).doubt


def test_what_was_said_before_is_said_as_well() -> None:
    """An effect that is known already stands behind the new one, and a break leaves no doubt."""
    place = Place("specs/board.yaml", 1, 1)
    before = changed(rules.LINK, "link.radio", "a", "b", (place, place), "it is slower", doubt="whether it fits")
    (found,) = judging.heard_otherwise([before], link(), program())
    assert (found.effect, found.doubt) == ("who listens on it hears nothing; it is slower", "")
