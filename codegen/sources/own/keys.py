"""The keys that the driver of a project declares, and their values as the generated Python has them."""

import json
import keyword
from dataclasses import fields
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.spec.driver import DriverKeySpec, DriverSpec, KeyKind
from codegen.model.spec.source import OwnSourceSpec
from codegen.pattern import pattern
from codegen.source import Place
from codegen.sources.kind import BAD_SOURCE, Around

WHOLE = pattern(r"[-+]?(0x[0-9a-fA-F]{1,8}|[0-9]{1,10})")
_NUMBERS = (KeyKind.WHOLE, KeyKind.NUMBER, KeyKind.PIN)
_OF_SENSORS = frozenset(each.name for each in fields(OwnSourceSpec))
"""Keys that every sensor has: what stands there never comes to the driver."""


@dataclass(frozen=True, slots=True)
class KeyReader:
    """Reads the keys of the sensors of a driver; what is wrong in its own file is told there, once."""

    declared: DriverSpec
    around: Around

    def check(self) -> frozenset[str]:
        """Report what is wrong with the keys as the driver declares them; return the names of those."""
        return frozenset(name for name, key in self.declared.keys.items() if self._is_wrong(name, key))

    def _is_wrong(self, name: str, key: DriverKeySpec) -> bool:
        found = self._of_name(name, key) or self._of_ends(name, key) or self._of_default(name, key)
        if found is None:
            return False
        place, message, hint = found
        self.around.report.add(BAD_SOURCE, place, message, hint)
        self.around.failed = True
        return True

    def _of_name(self, name: str, key: DriverKeySpec) -> tuple[Place, str, str] | None:
        """Return what is wrong with a name, by which the class of the driver is given the value."""
        if not (name.isidentifier() and name.isascii()) or keyword.iskeyword(name) or name == "self":
            message = f"{name} cannot be the name of a key: {self.declared.class_name} is given it as an argument"
            return key.place, message, "use letters, digits and _, and no word of Python, such as field_of_view"
        if name in _OF_SENSORS:
            message = f"{name} cannot be the name of a key: every sensor has one of this name, which no driver is given"
            return key.place, message, f"call it otherwise: own_{name}"
        if name == "opened" and self.declared.bus is not None:
            message = "opened cannot be the name of a key: so the function is called that opens the bus"
            return key.place, message, "call it otherwise: is_opened"
        return None

    def _of_ends(self, name: str, key: DriverKeySpec) -> tuple[Place, str, str] | None:
        ends = {each: getattr(key, each) for each in ("min", "max") if getattr(key, each) is not None}
        for each, value in ends.items():
            if key.kind not in _NUMBERS:
                return key.at(each), f"{name} is a {key.kind}, which has no {each}", f"leave {each} out"
            if key.kind is not KeyKind.NUMBER and value.denominator != 1:
                message = f"{each} of {name} is {float(value):g}, and it takes whole numbers"
                return key.at(each), message, "write a whole number, or kind: number"
        if len(ends) == 2 and ends["min"] > ends["max"]:
            message = f"max of {name} is {_shown(ends['max'])}, less than min, {_shown(ends['min'])}"
            return key.at("max"), message, "swap them, or leave out one"
        return None

    def _of_default(self, name: str, key: DriverKeySpec) -> tuple[Place, str, str] | None:
        value = _default(key)
        if value is None:
            return None
        _, problem = read_value(value, key)
        if not problem:
            return None
        written = f"{float(key.default):g}" if isinstance(key.default, Fraction) else value
        return key.at("default"), f"the default of {name} is {written}, {problem}", f"default: {_example(key)}"

    def value(self, name: str, key: DriverKeySpec, written: str | None) -> str | None:
        """The value of a key as the generated Python has it; None after a finding."""
        around, driver = self.around, self.around.spec.driver
        given = _default(key) if written is None else written
        if given is None:
            around.bad("driver", f"{name} is missing, which the driver {driver} needs", f"{name}: {key.doc}")
            return None
        value, problem = read_value(given, key)
        if problem:
            around.bad(f"keys.{name}", f"{name} is {given}, {problem}", hint=f"{name}: {key.doc}")
        return value


def read_value(written: str, key: DriverKeySpec) -> tuple[str | None, str]:
    """Return a value as Python has it, and what is wrong with it, one of them empty."""
    match key.kind:
        case KeyKind.TEXT:
            return json.dumps(written), ""
        case KeyKind.BOOLEAN if written in ("true", "false"):
            return written.capitalize(), ""
        case KeyKind.WHOLE | KeyKind.PIN if WHOLE.fullmatch(written):
            return _limited(Fraction(int(written, 0)), key)
        case KeyKind.NUMBER if written.isascii():
            try:
                return _limited(Fraction(written), key)
            except (ValueError, ZeroDivisionError):
                pass
    return None, f"no {key.kind}"


def _limited(value: Fraction, key: DriverKeySpec) -> tuple[str | None, str]:
    if (key.min is not None and value < key.min) or (key.max is not None and value > key.max):
        return None, f"not {_shown(key.min)} to {_shown(key.max)}"
    return str(int(value)) if value.denominator == 1 else repr(float(value)), ""


def _default(key: DriverKeySpec) -> str | None:
    if key.default is None:
        return None
    return str(key.default).lower() if isinstance(key.default, bool) else str(key.default)


def _example(key: DriverKeySpec) -> str:
    """Return a value that the key takes."""
    if key.kind is KeyKind.BOOLEAN:
        return "false"
    low, high = key.min, key.max
    nearest = low if low is not None else high if high is not None and high < 0 else Fraction(0)
    return _shown(nearest)


def _shown(value: Fraction | None) -> str:
    return "..." if value is None else f"{float(value):.10g}"
