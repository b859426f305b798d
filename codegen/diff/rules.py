"""The rules of ``codegen diff``, by their ids."""

from collections.abc import Mapping

from codegen.diff.change import ChangeRule
from codegen.diff.dialect import wire_rules
from codegen.diff.system import behaviour_rules, trace_rules

CHANGE_RULES: Mapping[str, ChangeRule] = {
    rule.id: rule
    for module in (wire_rules, behaviour_rules, trace_rules)
    for rule in vars(module).values()
    if isinstance(rule, ChangeRule)
}
