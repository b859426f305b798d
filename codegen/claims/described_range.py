"""The range of a field that the dialect gives: by its attributes, or else in the words of its description."""

import re

from codegen.model.dialect.dialect import WireField
from codegen.pattern import pattern

_NUMBER = r"-?\d{1,6}(?:\.\d{1,3})?"
_WORDS = (
    pattern(rf"\[\s*(?P<low>{_NUMBER})\s*(?:,|\.\.+|-|to)\s*(?P<high>{_NUMBER})\s*\]"),
    pattern(rf"\((?P<low>{_NUMBER})\s*(?:\.\.+|-|to)\s*(?P<high>{_NUMBER})[^)\d]{{0,12}}\)"),
    pattern(rf"(?<![\w.-])(?P<low>{_NUMBER})\s?(?:\.\.+|to|-)\s?(?P<high>{_NUMBER})(?![\w]|\.\d)"),
    pattern(
        r"(?<![\w.-])(?P<low>0)(?::| =| means)[^.;]{2,24}[,;] (?P<high>255|100|254)(?::| =| means) (?:max|best|good"
        r"|full)",
        needs="100|254|255",
    ),
)


def range_of(field: WireField) -> tuple[float, float] | None:
    """Return the smallest and the greatest number of a field; None where the dialect says none, or several."""
    stated = (field.definition.minimum, field.definition.maximum)
    if all(text is not None and re.fullmatch(_NUMBER, text) for text in stated):
        return float(stated[0] or 0), float(stated[1] or 0)
    for form in _WORDS:
        found = list(form.finditer(field.definition.description))
        if found:
            low, high = float(found[0]["low"]), float(found[0]["high"])
            return (low, high) if len(found) == 1 and low < high else None
    return None
