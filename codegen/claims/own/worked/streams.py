"""Statements about messages: frames, what streams take at their rates, lists of parameters."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import product

from codegen.claims.own.worked.amount import Amount, of_unit
from codegen.claims.own.worked.examples import Examples, Statement
from codegen.claims.own.worked.sizes import Frame, is_v1, possible_frames, stated_frames
from codegen.claims.reading import Mention
from codegen.diagnostics import Diagnostic
from codegen.frozen import dataclass
from codegen.model.price import BITS_OF_A_BYTE, HEAD_V1, HEAD_V2, frame_size
from codegen.model.units.unit import unit_named
from codegen.pattern import pattern

BYTES, PER_SECOND, HERTZ, SECOND = (unit_named(name) for name in ("bytes", "bytes/s", "Hz", "s"))
_PARAMETERS = pattern(r"\b(?:all|list of(?: the)?) (?P<count>\d{1,4}) parameters\b", re.IGNORECASE)
_BAUD = pattern(r"\b(?P<baud>[1-9]\d{2,6}) baud\b")
_BITS = pattern(r"\b(?P<bits>[1-9]\d?) bits per byte\b")
_SAME = pattern(r"(?:^|: )the same\b", re.IGNORECASE)
_FRAME, _PAYLOAD = pattern(r"\bframe\b", re.IGNORECASE), pattern(r"\bpayload\b", re.IGNORECASE)
_WHOLE = pattern(r"\b(?:whole|largest|extended|with extensions)\b", re.IGNORECASE)
_OTHER = pattern(r"\bdraft|\bthat text\b|\bof the\b|\bsigned\b", re.IGNORECASE)
_SIGNED = pattern(r"\bsigned\b", re.IGNORECASE)
_INSTANCE = pattern(r"\bfor (?P<component>[a-z][a-z_]*) (?P<number>\d{1,3})\b")
_MOST = 8
"""Messages that a statement adds up."""
_LISTED = "PARAM_VALUE"


_Stated = Mapping[str, tuple[Frame, ...]]


@dataclass(frozen=True, slots=True)
class _Said:
    """Messages with rates in Hz, or without any, and the version of MAVLink."""

    names: tuple[str, ...]
    rates: tuple[Fraction, ...]
    is_v1: bool


def check(examples: Examples) -> Iterator[Diagnostic]:
    """Every statement about the bytes of messages, of streams and of all parameters; "the same" is the one before."""
    before: _Said | None = None
    stated = stated_frames(examples)
    for statement in examples.statements:
        label, value = statement.label, statement.value.alone
        if value is None:
            continue
        said = _said(examples, statement)
        if said is None and before is not None and _SAME.search(label.text):
            yield from _instance(examples, statement, value, before)
            said = replace(before, is_v1=is_v1(label.text)) if is_v1(label.text) else None
        if said is not None and said.rates:
            yield from _stream(examples, stated, statement, value, said)
        elif said is not None and len(said.names) == 1 and value.like(BYTES):
            yield from _size(examples, stated, statement, value, said)
        yield from _parameters(examples, statement, value)
        before = said or before


def _said(examples: Examples, statement: Statement) -> _Said | None:
    """The messages of a label: each has the rate that follows it."""
    start, end = statement.label.start, statement.label.start + len(statement.label.text)
    mentions = [each for each in examples.reading.mentioned(statement.passage) if start <= each.start < end]
    if not 0 < len(mentions) <= _MOST:
        return None
    rates = of_unit(statement.label.amounts, HERTZ)
    following = [_behind(mention, rates) for mention in mentions]
    if (rates and None in following) or _SIGNED.search(statement.label.text):
        return None
    names = tuple(mention.name for mention in mentions)
    found = tuple(each.value for each in following if each is not None)
    return _Said(names, found, is_v1(statement.label.text))


def _behind(mention: Mention, rates: Sequence[Amount]) -> Amount | None:
    return next((rate for rate in rates if rate.start > mention.end), None)


def _frames(examples: Examples, stated: _Stated, name: str, *, of_v1: bool) -> tuple[Fraction, ...]:
    """The bytes that a frame of a message may have: what the document says, the layout, or what the project sends."""
    message, sent = examples.reading.messages[name], examples.reading.reference.sent.get(name)
    if of_v1:
        return (Fraction(HEAD_V1 + message.base_length),)
    said = dict.fromkeys(frame.v2 for frame in stated.get(name, ()))
    said.pop(None, None)
    if said:
        return tuple(each for each in said if each is not None)
    if sent is not None and sent.low != sent.high:
        return tuple(Fraction(each) for each in range(int(sent.low), int(sent.high) + 1))
    return possible_frames(examples, message) if sent is None else (sent.low,)


def _stream(
    examples: Examples, stated: _Stated, statement: Statement, value: Amount, said: _Said
) -> Iterator[Diagnostic]:
    """ "A at 2 Hz with B and C at 1 Hz, v2 | 160 bytes/s"."""
    if not value.like(PER_SECOND):
        return
    choices = [_frames(examples, stated, name, of_v1=said.is_v1) for name in said.names]
    if len(said.names) > 1 and any(len(each) > 2 for each in choices):
        return
    unit = value.unit
    sums = (sum(size * rate for size, rate in zip(sizes, said.rates, strict=True)) for sizes in product(*choices))
    factor = PER_SECOND.scale / unit.scale
    expected = sorted({each * factor for each in sums})
    named = " and ".join(f"{name} at {float(rate):g} Hz" for name, rate in zip(said.names, said.rates, strict=True))
    yield from examples.judged(statement.passage, value, _few(value, expected), named)


def _few(value: Amount, expected: Sequence[Fraction]) -> Sequence[Fraction]:
    """Return the expected numbers; where there are four or more and none is the stated one, only the nearest."""
    if len(expected) < 4 or any(value.shows(each) for each in expected):
        return expected
    return [min(expected, key=lambda each: abs(each - value.value))]


def _size(
    examples: Examples, stated: _Stated, statement: Statement, value: Amount, said: _Said
) -> Iterator[Diagnostic]:
    """ "NAME, frame (v2) | 37 bytes", "Largest unsigned NAME frame, v2 | 66 bytes"; what a draft has is left alone."""
    label, (name,) = statement.label.text, said.names
    message = examples.reading.messages[name]
    if _OTHER.search(label):
        return
    expected: tuple[Fraction, ...] = ()
    if _FRAME.search(label):
        whole = (Fraction(HEAD_V2 + message.length),)
        is_whole = _WHOLE.search(label) and not said.is_v1
        expected = whole if is_whole else _frames(examples, stated, name, of_v1=said.is_v1)
    elif _PAYLOAD.search(label):
        expected = (Fraction(message.length if _WHOLE.search(label) else message.base_length),)
    words = f"{name}, {label.partition(',')[2].strip() or label}"
    yield from examples.judged(statement.passage, value, _few(value, expected), words)


def _instance(examples: Examples, statement: Statement, value: Amount, before: _Said) -> Iterator[Diagnostic]:
    """ "The same for COMPONENT 0": a frame of the message before, about one instance."""
    named = _INSTANCE.search(statement.label.text)
    if named is None or len(before.names) != 1 or not value.like(BYTES):
        return
    expected = []
    for system in examples.systems:
        for message in system.tables(before.names[0]):
            number = int(named["number"])
            part = message.component
            if part and part.name == named["component"] and part.first_number is None and number < message.instances:
                expected.append(frame_size(message, number, 2).high)
    yield from examples.judged(statement.passage, value, expected, f"{before.names[0]} of {named[0][4:]}")


def _parameters(examples: Examples, statement: Statement, value: Amount) -> Iterator[Diagnostic]:
    """ "All 39 parameters, v2 | 1443 bytes": each is one message; over a UART it takes a time."""
    label = statement.label.text
    counted, message = _PARAMETERS.search(label), examples.reading.messages.get(_LISTED)
    if counted is None or message is None or _SIGNED.search(label):
        return
    head = HEAD_V1 if is_v1(label) else HEAD_V2
    size = Fraction(int(counted["count"]) * (head + message.base_length))
    baud, bits = _BAUD.search(label), _BITS.search(label)
    words = f"the list of {counted['count']} parameters"
    if value.like(BYTES):
        yield from examples.judged(statement.passage, value, [size * BYTES.scale / value.unit.scale], words)
    elif baud is not None and value.like(SECOND):
        seconds = size * (int(bits["bits"]) if bits else BITS_OF_A_BYTE) / int(baud["baud"])
        yield from examples.judged(statement.passage, value, [seconds * SECOND.scale / value.unit.scale], words)
