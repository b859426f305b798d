"""Messages that the dialect calls unfinished or outdated."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.system import System

RULE = Rule(
    "unstable-message",
    "A populated message is work in progress, deprecated or superseded in the dialect: it can still change, or "
    "receivers are moving away from it.",
    Severity.WARNING,
    remedy="keep it only where receivers know it: it can still change",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every populated message."""
    for message in system.messages:
        lifecycle = message.wire.definition.lifecycle
        if lifecycle.wip:
            state = "work in progress"
        elif lifecycle.deprecated_since is not None:
            state = f"deprecated since {lifecycle.deprecated_since}"
        elif lifecycle.superseded_since is not None:
            state = f"superseded since {lifecycle.superseded_since}"
        else:
            continue
        yield Diagnostic(
            message.population.at("message"),
            RULE,
            f"{message.name} is {state}",
            f"replaced by {lifecycle.replaced_by}" if lifecycle.replaced_by else None,
            ((message.wire.definition.place, "it is declared here"),),
        )
