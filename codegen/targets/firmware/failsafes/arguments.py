"""The arguments that only some failsafes give to their class: constants of the module where they agree."""

from collections.abc import Iterable, Sequence

from codegen.frozen import dataclass
from codegen.model.failsafe import Failsafe
from codegen.model.spec.failsafe import Watching
from codegen.targets.firmware.failsafes.table import inverted_rows, table_constant
from codegen.targets.firmware.words import Layout
from codegen.targets.naming import parameter_attribute, quoted


@dataclass(frozen=True, slots=True)
class Argument:
    """An argument: its value, as an expression, None where the failsafe does without; ``default`` stands for that.

    ``is_own``: each instance has one of its own, so that it is no constant.
    """

    name: str
    default: str
    value: str | None
    is_own: bool = False


@dataclass(frozen=True, slots=True)
class Settled:
    """The arguments that at least one failsafe needs; ``same`` has those that have one value in all failsafes."""

    names: tuple[str, ...]
    same: dict[str, str]
    defaults: dict[str, str]

    @staticmethod
    def of(given: Sequence[tuple[Argument, ...]]) -> "Settled":
        """Return what all failsafes together need."""
        by_name = {
            argument.name: [each for one in given for each in one if each.name == argument.name]
            for argument in given[0]
        }
        used = {name: found for name, found in by_name.items() if any(each.value is not None for each in found)}
        same = {
            name: found[0].value
            for name, found in used.items()
            if found[0].value is not None and len({each.value for each in found}) == 1 and not found[0].is_own
        }
        return Settled(tuple(used), same, {name: found[0].default for name, found in used.items()})

    def has(self, name: str) -> bool:
        """Return whether any failsafe needs it."""
        return name in self.names

    def is_same(self, name: str) -> bool:
        """Return whether all failsafes have the argument, with one value."""
        return name in self.same

    def only_some(self, name: str) -> bool:
        """Return whether some failsafes have the argument, but not all with one value: others may lack it."""
        return name in self.names and name not in self.same

    def __call__(self, name: str) -> str:
        """The expression for it within the class."""
        value = self.same.get(name)
        if value is None:
            return f"self._{name}"
        return f"_{name.upper()}" if value.isdigit() else value

    @property
    def constants(self) -> list[str]:
        """The lines with those numbers that all share."""
        return [f"_{name.upper()} = const({value})" for name, value in self.same.items() if value.isdigit()]

    @property
    def kept(self) -> list[str]:
        """The names of those that each failsafe has to be given."""
        return [name for name in self.names if name not in self.same]

    @property
    def parameters(self) -> list[str]:
        """The same as the parameters of __init__."""
        return [f"{name}={self.defaults[name]}" for name in self.kept]

    def arguments(self, given: Sequence[Argument]) -> list[str]:
        """Return what one failsafe gives for them."""
        kept = set(self.kept)
        return [
            f"{each.name}={each.value}"
            for each in given
            if each.name in kept and each.value not in (None, each.default)
        ]


def arguments_of(failsafe: Failsafe, layout: Layout) -> tuple[Argument, ...]:
    """Return what a failsafe gives."""
    component, quantity = failsafe.component, failsafe.quantity
    offsets = layout.blocks[component.name].offsets if component else {}
    switch = component.enabled if component and quantity else None
    conditions = (*failsafe.to_arm, *failsafe.conditions)
    aged = dict.fromkeys(each.quantity.attribute for each in conditions if each.quantity and each.quantity.ages)
    enabled = failsafe.enabled_by
    several = enabled is not None and bool(enabled.siblings)
    names = [quoted(parameter_attribute(name)) for name in (enabled.siblings or (enabled.name,))] if enabled else []
    return (
        Argument("text", "None", f"_{failsafe.name}_text"),
        Argument("names", "()", _tuple(level.name for level in failsafe.levels)),
        Argument("timed_from", "0", str(len(failsafe.to_arm)) if failsafe.to_arm else None),
        Argument("watched_at", "None", str(offsets[quantity.attribute]) if quantity else None),
        Argument("inverted", "()", f"{table_constant(failsafe)}_INVERTED" if inverted_rows(failsafe) else None),
        Argument("switch_at", "None", str(offsets[switch.attribute]) if switch else None),
        Argument("level_at", "None", str(offsets[failsafe.level.attribute]) if failsafe.level else None),
        Argument("health_at", "None", str(offsets[failsafe.health.attribute]) if failsafe.health else None),
        Argument("health_every_ms", "0", str(failsafe.health_every_ms) if failsafe.health else None),
        Argument(
            "enabled_by",
            "None",
            (f"({', '.join(names)})[instance]" if several else names[0]) if names else None,
            is_own=several,
        ),
        Argument("aging", "()", _tuple(aged) if aged else None),
        Argument("is_latched", "True", "False" if failsafe.recovers else None),
        Argument("is_always", "False", "True" if failsafe.spec.when is Watching.ALWAYS else None),
        Argument("listens", "False", "True" if quantity is None else None),
    )


def _tuple(texts: Iterable[str]) -> str:
    """The literal of a tuple of texts."""
    literals = [quoted(text) for text in texts]
    return f"({', '.join(literals)}{',' if len(literals) == 1 else ''})"
