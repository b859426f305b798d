"""Judges changes of what a message is about, and of how often a stream of messages can be asked for."""

from dataclasses import replace

from codegen.diff.change import Change, Notice
from codegen.diff.system.judged import Sides, breaking, doubtful, table_of
from codegen.model.system import PopulatedMessage
from codegen.model.units.unit import decimal


def instances(change: Change, sides: Sides) -> Change:
    """A message that is no longer sent for each instance, or begins to be, or for those of something else."""
    old, new = (table_of(side, change.subject) for side in (sides.old, sides.new))
    if old is None or new is None or old.component is new.component:
        return change
    if old.component is None:
        return doubtful(change, "whether receivers tell the instances apart") if _several(new) else change
    if new.component is None:
        others = f"receivers hear nothing of any other {old.component.name}"
        return replace(breaking(change, others), notice=Notice.NONE) if _several(old) else change
    if old.component.name != new.component.name:
        what = f"the same numbers stand for {new.component.name} and no longer for {old.component.name}"
        return doubtful(change, f"whether {what}")
    return change


def _several(message: PopulatedMessage) -> bool:
    return message.component is not None and message.component.instances > 1


def asked(change: Change, sides: Sides) -> Change:
    """A stream that is asked for by another number or by none, or at most so often."""
    name = change.subject.removeprefix("stream ")
    old, new = (side.streams.get(name) for side in (sides.old, sides.new))
    if old is None:
        return change
    number = old.data_stream
    if number is not None and (new is None or new.data_stream != number):
        others = [each.name for each in sides.new.streams.values() if each.data_stream == number]
        if not others:
            return breaking(change, f"who asks for the data stream {number} gets no answer")
        change = doubtful(change, f"whether who asks for the data stream {number} means {others[0]}")
    if new is not None and new.fastest < old.fastest:
        change = doubtful(change, f"whether {decimal(new.fastest)} times a second is enough for who asks for more")
    return change
