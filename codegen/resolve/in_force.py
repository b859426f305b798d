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


def check_at_start(parameter: Parameter, rule: Rule, place: Place, report: Report) -> None:
    """Report a parameter that is read when the board starts, and does not say so: whoever sets it is told."""
    if not parameter.spec.reboot:
        message = f"{parameter.name} is looked at when the board starts"
        related = [(parameter.spec.place, f"{parameter.name} is declared here")]
        report.add(rule, place, message, f"{parameter.name}: reboot: true", related)
