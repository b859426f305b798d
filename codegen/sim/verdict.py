"""What came of a simulation, in sentences."""

from codegen.sim.record import FAILSAFE_TEXT, Recording
from codegen.sim.sample import Happening, Kind


def seconds(milliseconds: float) -> str:
    """A time as people read it: ``12.3 s``."""
    return f"{milliseconds / 1000:.1f} s"


def volts(millivolts: float) -> str:
    """A voltage as people read it: ``12.34 V``."""
    return f"{millivolts / 1000:.2f} V"


def verdict(recording: Recording) -> list[str]:
    """The sentences, the most important one first; of all programs, where several run."""
    happenings = recording.happenings
    sentences = [*_endings(recording), *_failsafe(recording, happenings)]
    for record in recording.all:
        sentences += _faults(record, happenings)
    for record in recording.all:
        sentences += _voltages(record)
    return sentences


def battery_name(recording: Recording, instance: int) -> str:
    """``battery 2``, ``battery 1 of pico-trail``, or nothing where there is only one battery at all."""
    of = f" of {recording.name}" if recording.name else ""
    if len(recording.instances) > 1:
        return f"battery {instance + 1}{of}"
    return f"the battery{of}" if of else ""


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
    if not fired and not any(record.instances for record in recording.all):
        return []  # nothing is measured that one could watch
    if not fired:
        return ["The failsafe did not fire."]
    is_one = not recording.beside and len(recording.instances) == 1
    return [
        "The failsafe fired: " + ", ".join(f"{_level(f, is_one=is_one)} at {seconds(f.at_ms)}" for f in fired) + "."
    ]


def _level(happening: Happening, *, is_one: bool) -> str:
    match = FAILSAFE_TEXT.match(happening.text)
    if match is None:
        return happening.text
    return match[3] if is_one else f"{match[1]} {match[3]}"


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


def _voltages(recording: Recording) -> list[str]:
    sentences = []
    for instance in recording.instances:
        name = battery_name(recording, instance)
        of = f" of {name}" if name else ""
        difference = recording.largest_difference(instance)
        if difference is None:
            sentences.append(f"No voltage{of} was reported.")
            continue
        at = seconds(difference[1])
        sentences.append(f"The reported voltage{of} was at most {volts(difference[0])} from the true one, at {at}.")
    return sentences
