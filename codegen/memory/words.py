"""The estimate in words: how much heap a program takes, what takes it, and what takes less."""

from codegen.memory.estimate import ACCURACY, SHARE, Estimate

COLUMNS = ("part", "heap")
NOT_COUNTED = (
    "Not counted: code of yours, and what running takes, up to a quarter more: frames, texts, modules that are loaded "
    "when somebody asks for them.",
)


def kilobytes(count: int) -> str:
    """``185 KB``, of 1024 bytes."""
    return f"{round(count / 1024) or 'less than 1'} KB"


def rows(estimate: Estimate) -> list[tuple[str, str]]:
    """Return what takes how much, the largest first."""
    return [(name, kilobytes(count)) for name, count in estimate.shares]


def whole_words(estimate: Estimate, board: str) -> str:
    """Return what the program takes, and of how much."""
    text = f"The program takes {kilobytes(estimate.bytes)} of the heap once it has started"
    if estimate.machine_code:
        text += f", {kilobytes(estimate.machine_code)} of it for machine code"
    if estimate.heap is None:
        return f"{text}. Nobody knows how much the board has."
    return f"{text}; the {board} has {kilobytes(estimate.heap)}."


def source_words(estimate: Estimate) -> str:
    """Return where the figures come from, and how well they fit."""
    return (
        f"Estimated from counts of what the specification has; {estimate.programs} programs were measured for it. "
        f"It may be off by {float(ACCURACY * 100):.0f} %."
    )


def found_words(estimate: Estimate, board: str) -> str:
    """Return what a finding says: how much is needed, and how much there is."""
    heap = kilobytes(estimate.heap or 0)
    return f"the program takes some {kilobytes(estimate.bytes)} of heap once it has started, and the {board} has {heap}"


def advice(estimate: Estimate) -> str:
    """Return what takes most of it, and what can be done."""
    most = ", ".join(f"{name} {kilobytes(count)}" for name, count in estimate.shares[:3])
    less = f"machine_code: false takes {kilobytes(estimate.machine_code)} less, " if estimate.machine_code else ""
    return (
        f"{most}; {less}fewer tables and fields take less, and so do modules that run in place, from a ROMFS or frozen "
        "into MicroPython (docs/deploy.md)"
    )


def share_words() -> str:
    """Return the share of the heap that a program may take."""
    return f"{float(SHARE * 100):.0f} %"
