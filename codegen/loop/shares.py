"""The shares of a slot's time: its parts, grouped under a few names that mean something to people."""

from codegen.loop.budget import LoopBudget, Slot, Took
from codegen.loop.parts import Part, Work

GROUPS: dict[str, tuple[Part, ...]] = {
    "the pass and its jobs": (Part.PASS, Part.JOBS, Part.JOB, Part.CALL),
    "serving links": (Part.LINK, Part.STATION),
    "streams, to find what is due": (Part.STREAMS, Part.TABLE, Part.MESSAGE, Part.ENDING),
    "frames, from the state to the port": (Part.FRAME, Part.BYTE, Part.VALUE),
    "messages that arrive": (Part.HEARD,),
    "readings, with conversions": (Part.COMPONENT, Part.READING, Part.SAMPLE, Part.CONVERSION),
    "failsafes and readiness": (Part.WATCH, Part.FAILSAFE, Part.CONDITION),
    "sensors": (Part.SENSORS, Part.SENSOR, Part.TURN),
    "reports and reminders": (Part.REPORT, Part.REMINDER),
}
"""The parts of the work by the names that the report groups them under; every part is in one group."""


def shares(slot: Slot, budget: LoopBudget) -> list[tuple[str, Took, str]]:
    """Return what takes a slot with all messages due: what it is, how long it takes, and its share in words."""
    whole = slot.busy.likely_us or slot.busy.instructions
    found = []
    for name, parts in GROUPS.items():
        work = Work({part: slot.work[part] for part in parts if slot.work[part]})
        if work:
            took = budget.took(work)
            part = took.likely_us if took.likely_us is not None else took.instructions
            found.append((name, took, f"{float(100 * part / whole):.0f} %"))
    return found
