"""The heap that the program takes on the board, for codegen explain."""

from textwrap import fill

from codegen.explain.text import columns
from codegen.memory.estimate import memory_estimate
from codegen.memory.words import COLUMNS, NOT_COUNTED, rows, source_words, whole_words
from codegen.model.system import System

_WIDTH = 100


def heap_story(system: System) -> str:
    """Return the estimate of a program as text; why there is none, where there is none."""
    estimate = memory_estimate(system)
    if estimate is None:
        return "heap: nothing is estimated; there is no program: vehicle.yaml is missing\n"
    lines = [fill(whole_words(estimate, system.board_name), _WIDTH), ""]
    lines += columns([COLUMNS, *rows(estimate)])
    lines += ["", *(fill(text, _WIDTH) for text in (*NOT_COUNTED, source_words(estimate)))]
    return "\n".join(lines) + "\n"
