"""Families of parameters: one is written in parameters.yaml, each instance of a component has its own."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.frozen import dataclass
from codegen.model.spec.spec import ParameterSpec, Spec
from codegen.model.vehicle import Instance, Parameter
from codegen.resolve.instances import BAD_INSTANCES
from codegen.resolve.quantities.component import find_component
from codegen.source import Place

BAD_FAMILY = Rule(
    "bad-parameter-family",
    "A parameter that exists for each instance of a component begins with the prefix of the first instance. A default "
    "with per needs the fact that it names of each instance.",
    remedy="write for_each: and the name of a component of state.yaml",
)


@dataclass(frozen=True, slots=True)
class Member:
    """One parameter of a family, or a parameter that stands alone; ``spec`` has its own default."""

    name: str
    spec: ParameterSpec
    default_place: Place | None = None
    component: str | None = None
    instance: int = 0
    siblings: tuple[str, ...] = ()

    def at(self, key: str) -> Place:
        """Return where a key of it is written; a default may stand with the instance."""
        return self.default_place if key == "default" and self.default_place else self.spec.at(key)


def _was(spec: ParameterSpec, prefix: str, part: Instance) -> dict[str, Fraction]:
    """Return what the member of an instance was called: with its prefix, where the
    first one's had that of the first one.
    """
    return {
        part.prefix + old.removeprefix(prefix) if old.startswith(prefix) else old: factor
        for old, factor in spec.was.items()
        if old.startswith(prefix) or part.number == 0
    }


def is_single(parameter: Parameter, place: Place, report: Report) -> bool:
    """Return whether a parameter is one for the whole vehicle; a finding where each instance has its own."""
    if parameter.siblings:
        message = f"each {parameter.component} has its own {parameter.name}, and one is needed here"
        related = [(parameter.spec.at("for_each"), f"{parameter.name} is declared here")]
        report.add(BAD_FAMILY, place, message, related=related, hint="name a parameter without for_each")
    return not parameter.siblings


class ParameterFamilies:
    """Makes the members of each family."""

    def __init__(self, spec: Spec, instances: Mapping[str, tuple[Instance, ...]], report: Report) -> None:
        self._spec = spec
        self._instances = instances
        self._report = report

    def members(self, name: str, spec: ParameterSpec) -> Iterator[Member]:
        """The parameters that an entry of parameters.yaml stands for; none after a finding."""
        if spec.for_each is None:
            if spec.per is not None:
                message = f"{name} belongs to no component, whose {spec.per} could be counted"
                self._report.add(
                    BAD_FAMILY, spec.at("per"), message, hint="leave per out, or say whose it is: for_each: COMPONENT"
                )
            yield Member(name, spec)
            return
        state, at = self._spec.state, spec.at("for_each")
        parts = find_component(spec.for_each, self._instances, state, BAD_FAMILY, at, self._report)
        if parts is None:
            return
        prefix = parts[0].prefix
        if not name.startswith(prefix) or name == prefix:
            message = f"{name} does not begin with {prefix}, the prefix of the first {spec.for_each}"
            hint = f"call it {prefix}{name.rpartition('_')[2]}, or leave out for_each"
            if prefix and "_" in name:
                hint = f"prefix: {name.partition('_')[0]}_ of the first {spec.for_each}, or {hint}"
            self._report.add(BAD_FAMILY, spec.place, message, hint)
            return
        siblings = tuple(part.prefix + name.removeprefix(prefix) for part in parts)
        for part, own in zip(parts, siblings, strict=True):
            default, place = self._default(name, own, spec, part)
            yield Member(
                name=own,
                spec=replace(spec, default=default, was=_was(spec, prefix, part)),
                default_place=place,
                component=spec.for_each,
                instance=part.number,
                siblings=siblings if len(parts) > 1 else (),
            )

    def _default(self, name: str, own: str, spec: ParameterSpec, part: Instance) -> tuple[Fraction, Place | None]:
        assert spec.for_each is not None
        written = self._spec.board.instances.get(spec.for_each, ())
        if part.number < len(written) and own in written[part.number].defaults:
            each = written[part.number]
            return each.defaults[own], each.at(f"defaults.{own}")
        if spec.per is None:
            return spec.default, None
        count = part.count(spec.per)
        if count is None:
            owner = f"{spec.for_each} {part.number + 1}"
            message = f"the default of {name} is multiplied with {spec.per}, and {owner} has no number of {spec.per}"
            hint = did_you_mean(spec.per, part.facts) or f"state it in board.yaml: facts: {{{spec.per}: 3}}"
            self._report.add(BAD_FAMILY, spec.at("per"), message, hint)
            return spec.default, None
        return spec.default * count, None

    def check_defaults(self) -> None:
        """Report each default of board.yaml that is for a parameter of another instance."""
        families = self._spec.parameters.parameters
        for component, written in self._spec.board.instances.items():
            parts = self._instances.get(component, ())
            if not parts:  # no such component, which has been reported
                continue
            stems = [name.removeprefix(parts[0].prefix) for name in families if families[name].for_each == component]
            for each, part in zip(written, parts, strict=False):
                own = [part.prefix + stem for stem in stems]
                for name in each.defaults:
                    if name not in own:
                        place = each.at(f"defaults.{name}")
                        self._report.add(
                            BAD_INSTANCES, place, f"{name} is no parameter of this {component}", did_you_mean(name, own)
                        )
