"""The time from which a new value of a parameter counts, which ``reboot`` says and what reads it decides."""

from codegen.diagnostics import Report, Rule
from codegen.model.vehicle import Parameter
from codegen.source import Place


def check_at_once(parameter: Parameter, reader: str, rule: Rule, place: Place, report: Report) -> None:
    """Report a parameter that says it waits for a restart, where a ``reader`` such as ``a stream`` follows it."""
    if parameter.spec.reboot:
        message = f"{parameter.name} is used only after a restart, but {reader} follows it at once"
        related = [(parameter.spec.at("reboot"), f"{parameter.name} is declared here")]
        report.add(rule, place, message, f"take reboot: true out at {parameter.name}", related)


def unsaid_start(parameter: Parameter) -> str:
    """Return what is wrong with a parameter that is read when the board starts and lacks ``reboot: true``.

    Whoever sets it is told that it counts, and nothing happens.
    """
    return f"{parameter.name} is looked at when the board starts"


def said_start(parameter: Parameter) -> str:
    """Return what says so."""
    return f"{parameter.name}: reboot: true"
