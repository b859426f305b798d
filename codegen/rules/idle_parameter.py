"""Parameters that are called like those of a further instance, and that its quantities do not look at."""

from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.findings.fingerprint import fingerprint
from codegen.model.system import System

RULE = Rule(
    "idle-parameter",
    "A quantity names a parameter that all instances of its component share, and another parameter is called as if it "
    "were that of a further instance: PACK2_CAPACITY beside PACK_CAPACITY. Setting it changes nothing of that "
    "instance, which goes by the first one's. With for_each one entry of parameters.yaml makes one for each instance.",
    Severity.WARNING,
    remedy="write for_each at the first one's parameter and leave out the other, or call it otherwise",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every parameter that is written by itself, with the prefix of an instance but the first."""
    written = system.spec.parameters.parameters
    alone = {name for name, spec in written.items() if spec.for_each is None}
    for name, component in system.components.items():
        spec = system.spec.state.components.get(name)
        if spec is None or len(component.parts) < 2:
            continue
        named = set(_texts(spec.quantities)) & alone
        first = component.parts[0].prefix
        for part in component.parts[1:]:
            for shared in sorted(each for each in named if part.prefix and each.startswith(first)):
                own = part.prefix + shared.removeprefix(first)
                if own in alone and own != shared and own not in named:
                    place = written[own].place
                    message = f"{own} is no parameter of {name} {part.number + 1}, which goes by {shared}"
                    hint = f"write for_each: {name} at {shared}, and leave {own} out, or call it otherwise"
                    found = fingerprint(RULE.id, place.file, f"{system.spec.program} {own}")
                    yield Diagnostic(place, RULE, message, hint, fingerprint=found)


def _texts(value: object) -> Iterator[str]:
    """Yield the texts of what is written of quantities, keys as well."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, Mapping):
        for key, each in value.items():
            yield from _texts(key)
            yield from _texts(each)
    elif isinstance(value, (tuple, list)):
        for each in value:
            yield from _texts(each)
    elif is_dataclass(value):
        for field in fields(value):
            if field.name not in ("place", "places"):
                yield from _texts(getattr(value, field.name))
