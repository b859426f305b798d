"""Files of a specification that nothing reads: what may have been meant by each."""

import os
from collections.abc import Sequence

from codegen.decode.board_model import OWN
from codegen.decode.scenario import SCENARIOS
from codegen.decode.trace_lock import TRACE_LOCK
from codegen.decode.waivers import WAIVERS
from codegen.diagnostics import did_you_mean

READ_BY_OTHERS = (SCENARIOS, WAIVERS, TRACE_LOCK)
"""Files beside the project file that are no part of the specification."""
DRIVERS = "drivers"
"""The folder beside it with drivers of the project's own."""


def hint_for_unread(folder: str, name: str, absent: Sequence[str], *, in_program: bool) -> str | None:
    """Return what may have been meant by a file of a folder; ``absent`` are the
    files that could be there and are not.
    """
    hints = {
        "messages": "the program does not list its message"
        if in_program and name.endswith(".yaml")
        else "population tables end in .yaml",
        "receives": "tables of received messages end in .yaml",
        "dialects": "name it under corrections in codegen.yaml",
        DRIVERS: f"name it in board.yaml: driver: {os.path.splitext(name)[0]}",
        OWN: f"name it in board.yaml: board: {os.path.splitext(name)[0]}",
    }
    if folder:
        return hints.get(folder)
    if name in READ_BY_OTHERS:
        return f"{name} lies beside the project file that lists the program"
    return did_you_mean(name, absent)
