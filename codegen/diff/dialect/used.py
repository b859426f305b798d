"""The part of a dialect that a project uses, so that changes elsewhere in it can be told apart."""

from collections.abc import Iterable

from codegen.diff.change import Change
from codegen.frozen import dataclass
from codegen.model.system import System


@dataclass(frozen=True, slots=True)
class Used:
    """The names of the messages that are sent, answered or read back, of enums of the state, and of single entries."""

    messages: frozenset[str]
    enums: frozenset[str]
    entries: frozenset[str]

    def is_concerned(self, change: Change) -> bool:
        """Return whether a change of the dialect touches the project: an entry of an
        enum only where it is used itself.
        """
        if change.enum is None:
            return not change.messages or bool(self.messages.intersection(change.messages))
        if change.entry is None:
            return change.enum in self.enums or bool(self.messages.intersection(change.messages))
        return change.enum in self.enums or not self.entries.isdisjoint((change.entry, change.old))


def used_of(systems: Iterable[System]) -> Used:
    """Return what several versions and programs use together."""
    messages: set[str] = set()
    enums: set[str] = set()
    entries: set[str] = set()
    for system in systems:
        messages.update(wire.name for wire in system.wires)
        if system.program is not None:
            entries.update(system.program.constants)
            entries.update(command.name for command in system.program.commands)
            enums.update(each.enum.name for command in system.program.commands for each in command.params if each.enum)
            entries.update(command.name for command in system.program.built_in)
        for component in system.components.values():
            enums.update(quantity.enum.name for quantity in component.quantities.values() if quantity.enum)
        for message in system.messages:
            for answer in message.answers:
                entries.update(answer.entries)
    return Used(frozenset(messages), frozenset(enums), frozenset(entries))
