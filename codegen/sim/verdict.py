"""The result of a simulation, in sentences."""

from codegen.sim.amount import amount, digits_of, seconds
from codegen.sim.expected import unmet
from codegen.sim.line import Line
from codegen.sim.record import Recording
from codegen.sim.sample import Happening, Kind


def verdict(recording: Recording) -> list[str]:
    """The sentences, the most important one first; of all programs, where several run."""
    happenings = recording.happenings
    sentences = [
        *_endings(recording),
        *(f"It caught an exception: {each}." for each in caught(recording)),
        *unmet(recording),
        *_failsafe(recording, happenings),
    ]
    for record in recording.all:
        sentences += _faults(record, happenings)
    for record in recording.all:
        sentences += _differences(record)
    return sentences


def caught(recording: Recording) -> list[str]:
    """The exceptions that parts of the programs raised and these caught, each with its time and place."""
    return [
        f"{f'{each.program}: ' if each.program else ''}{each.text}, at {seconds(each.at_ms)}"
        for each in recording.happenings
        if each.kind is Kind.FAILED
    ]


def line_name(recording: Recording, line: Line) -> str:
    """``battery[1].voltage``, ``battery.voltage of smart_battery``."""
    return f"{line.label} of {recording.name}" if recording.name else line.label


def _endings(recording: Recording) -> list[str]:
    for record in recording.all:
        if record.problem:
            who = f"{record.name}: " if record.name else ""
            return [f"It failed at {seconds(record.at_ms)}: {who}{record.problem}."]
    if recording.was_interrupted:
        return [f"It was interrupted at {seconds(recording.at_ms)}."]
    return []


def _failsafe(recording: Recording, happenings: list[Happening]) -> list[str]:
    fired = [happening for happening in happenings if happening.kind is Kind.FAILSAFE]
    guards = [guard for record in recording.all for guard in record.program.guards]
    if not fired:
        return ["No failsafe fired." if len(guards) > 1 else "The failsafe did not fire."] if guards else []
    of = {each.of for each in fired}
    is_one = len(guards) == len(of) == 1 and not recording.beside and "[" not in fired[0].of
    told = ", ".join(f"{each.word if is_one else each.text} at {seconds(each.at_ms)}" for each in fired)
    return [f"The failsafe fired: {told}."]


def _faults(recording: Recording, happenings: list[Happening]) -> list[str]:
    sentences = []
    of = f" of {recording.name}" if recording.name else ""
    refused = [each for each in happenings if each.kind is Kind.REFUSED and each.program == recording.name]
    if refused:
        sentences.append(f"Arming was refused: {refused[0].text}.")
    if recording.boards > 1:
        sentences.append(f"The board{of} was swapped {_times(recording.boards - 1)}.")
    if recording.restarts:
        sentences.append(f"The board{of} restarted {_times(recording.restarts)}.")
    if recording.overruns:
        noun = "slot was" if recording.overruns == 1 else "slots were"
        sentences.append(f"{recording.overruns} control {noun} missed{' by ' + recording.name if of else ''}.")
    return sentences


def _times(number: int) -> str:
    return "once" if number == 1 else f"{number} times"


def _differences(recording: Recording) -> list[str]:
    """Return how far what was told of each quantity with a course was from what was true."""
    sentences, right, silent = [], [], []
    for line in recording.lines:
        if not recording.has_course(line.label):
            continue
        name = line_name(recording, line)
        difference = recording.largest_difference(line.label)
        if difference is None:
            silent += [name] if line.is_told else []
        elif difference[0] == 0:
            right.append(name)
        else:
            apart = amount(difference[0], line.unit, _digits(difference[0]))
            sentences.append(f"{name} was told at most {apart} from what was true, at {seconds(difference[1])}.")
    if right:
        sentences.append(f"{_listed(right)} told as {'it was' if len(right) == 1 else 'they were'}.")
    if silent:
        sentences.append(f"{_listed(silent)} never told.")
    return sentences


def _listed(names: list[str]) -> str:
    """``a, b and c were``, ``a was``."""
    *front, last = names
    return f"{', '.join(front)} and {last} were" if front else f"{last} was"


def _digits(difference: float) -> int:
    """Digits behind the point that show a difference with two that say something."""
    return min(12, digits_of(difference) + (difference < 1))
