"""The measurements of ``codegen bench`` on a board, as its file states them."""

from collections.abc import Mapping

from codegen.frozen import dataclass
from codegen.source import Place

MEASURES: Mapping[str, str] = {
    "update.mean_us": "one reading of a component into the state, the mean",
    "update.longest_us": "the longest of these",
    "set.mean_us": "setting a quantity by its attribute, the mean",
    "set.longest_us": "the longest of these",
    "frame.mean_us": "making one message, from the state to the frame, the mean of the slowest message",
    "frame.longest_us": "the longest of these",
    "receive.mean_us": "taking in a frame, from its bytes to the message, the mean",
    "receive.longest_us": "the longest of these",
    "adc.mean_us": "one reading of the converter, the mean of its slowest input",
    "adc.longest_us": "the longest of these",
    "adc.noise_counts": "standard deviation of readings, of the noisiest input",
    "adc.span_counts": "between the smallest reading and the largest, of the input where that is most",
    "adc.failed": "readings that failed, of the input with most",
    "heap.free_bytes": "free once the program is made; the self-test itself takes some 10 KB of it",
    "heap.used_bytes": "what the program takes by then: modules and objects",
    "heap.steady_bytes": "taken while the program ran on",
    "loop.missed_slots": "control slots that were missed meanwhile",
    "loop.load_percent": "of the time that the main loop worked",
    "loop.seconds": "how long the program ran",
}
"""Their names and what each is; of several (messages, inputs) it is the worst."""


@dataclass(frozen=True, slots=True)
class BenchRecord:
    """One run on one board.

    ``inputs`` is the hash of the specification, as the generated suite has it, ``firmware`` that of the files on the
    board; ``program`` is empty for the project itself. ``ports`` says whether the real ones were open (``own``).
    """

    project: str
    program: str
    codegen: str
    inputs: str
    firmware: str
    board: str
    version: str
    taken: str
    ports: str
    measures: Mapping[str, float]
    details: Mapping[str, Mapping[str, float]]
    told: tuple[str, ...]
    place: Place
