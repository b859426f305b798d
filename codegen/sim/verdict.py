"""What came of a simulation, in sentences."""

from codegen.sim.record import FAILSAFE_TEXT, Kind, Recording


def seconds(milliseconds: float) -> str:
    """A time as people read it: ``12.3 s``."""
    return f"{milliseconds / 1000:.1f} s"


def volts(millivolts: float) -> str:
    """A voltage as people read it: ``12.34 V``."""
    return f"{millivolts / 1000:.2f} V"


def verdict(recording: Recording) -> list[str]:
    """The sentences, the most important one first."""
    return [*_endings(recording), _failsafe(recording), *_faults(recording), _voltage(recording)]


def _endings(recording: Recording) -> list[str]:
    if recording.problem:
        return [f"It failed at {seconds(recording.at_ms)}: {recording.problem}."]
    if recording.was_interrupted:
        return [f"It was interrupted at {seconds(recording.at_ms)}."]
    return []


def _failsafe(recording: Recording) -> str:
    fired = [happening for happening in recording.happenings if happening.kind is Kind.FAILSAFE]
    if not fired:
        return "The failsafe did not fire."
    return "The failsafe fired: " + ", ".join(f"{_level(f.text)} at {seconds(f.at_ms)}" for f in fired) + "."


def _level(text: str) -> str:
    match = FAILSAFE_TEXT.match(text)
    return match[1] if match else text


def _faults(recording: Recording) -> list[str]:
    sentences = []
    refused = [happening for happening in recording.happenings if happening.kind is Kind.REFUSED]
    if refused:
        sentences.append(f"Arming was refused: {refused[0].text}.")
    if recording.starts > 1:
        times = "once" if recording.starts == 2 else f"{recording.starts - 1} times"
        sentences.append(f"The board restarted {times}.")
    if recording.overruns:
        noun = "slot was" if recording.overruns == 1 else "slots were"
        sentences.append(f"{recording.overruns} control {noun} missed.")
    return sentences


def _voltage(recording: Recording) -> str:
    difference = recording.largest_difference()
    if difference is None:
        return "No voltage was reported."
    return f"The reported voltage was at most {volts(difference[0])} from the true one, at {seconds(difference[1])}."
