"""A model of received messages, by the tables alone: exact arithmetic, and nothing of the firmware."""

import math
import struct
from fractions import Fraction

GROUND_STATION = 6  # MAV_TYPE_GCS
QUIET_MS = 10000  # between two texts about numbers of one table that are not plausible
AS_IT_WAS = object()  # what the outcome is of a number that leaves the quantity alone
FLOATS = {"float": "<f", "double": "<d"}


class Model:
    """A vehicle that knows what was received: `known` by component and attribute, `taken` and `refused` by table.

    `told` has the fields of which it says that their numbers are not plausible.
    """

    def __init__(self, facts):
        self._facts = facts
        self._now_ms = 0
        self._heard = set()
        self._until_ms = {}
        self._told_ms = {}
        self.known = {}
        self.told = []
        self.taken = {table["name"]: 0 for table in facts["tables"]}
        self.refused = {table["name"]: {} for table in facts["tables"]}
        for table in facts["tables"]:
            for field in table["fields"]:
                self.known[_path(field)] = False if field["kind"] == "boolean" else field["initial"]

    def passes(self, duration_ms):
        """Let time pass: what is older than it may be is forgotten."""
        self._now_ms += duration_ms
        for path, until_ms in self._until_ms.items():
            if self._now_ms > until_ms:
                self.known[path] = None

    def receives(self, message, values, sender, version, types):
        """Take a message; `values` are by field, those of arrays as lists, `types` of the wire by field."""
        if sender == self._facts["own"]:
            return
        if message == "HEARTBEAT" and values["type"] == GROUND_STATION:
            self._heard.add(sender[0])
        for table in self._facts["tables"]:
            if table["message"] == message and self._is_for(table, values, sender):
                self.taken[table["name"]] += 1
                refused = None
                for field in table["fields"]:
                    if self._take(table["name"], field, values, version, types) is Ellipsis:
                        refused = field["label"]
                if refused is not None:
                    self._tell(table["name"], refused)

    def _tell(self, table, label):
        """Say of the last field of a message that it is not plausible, unless something like it was just said."""
        if self._now_ms - self._told_ms.get(table, -QUIET_MS) >= QUIET_MS:
            self._told_ms[table] = self._now_ms
            self.told.append(f"{table}.{label}")

    def _is_for(self, table, values, sender):
        # MAVLink 1 has no extensions: one that is not there is 0.
        for name, own in zip(table["target"], self._facts["own"], strict=True):
            if name is not None and values.get(name, 0) not in (0, own):
                return False
        if any(values.get(name, 0) != number for name, number in table["where"].items()):
            return False
        if table["sender"] == "ground_station":
            return sender[0] in self._heard
        return table["sender"] == "any" or sender[0] == self._facts["own"][0]

    def _take(self, table, field, values, version, types):
        path = _path(field)
        if version == 1 and field["is_extension"]:
            outcome = AS_IT_WAS if 0 in field["unchanged"] else None
        elif not all(_holds(each, values.get(each["field"], 0)) for each in field["provisos"]):
            outcome = AS_IT_WAS if field["otherwise"] == "unchanged" else None
        elif field["kind"] == "text":
            outcome = _text(field, values[field["field"]])
        else:
            outcome = _number(field, values[field["field"]], types[field["field"]])
        if outcome is AS_IT_WAS:
            return outcome
        if outcome is None:
            self.known[path] = self.known[path] if field["kind"] == "boolean" else field["initial"]
        elif outcome is Ellipsis:
            refused = self.refused[table]
            refused[field["label"]] = refused.get(field["label"], 0) + 1
        else:
            self.known[path] = outcome
            if field["stale_ms"] is not None:
                self._until_ms[path] = self._now_ms + field["stale_ms"]
        return outcome


def _path(field):
    return field["component"] + "." + field["attribute"]


def _holds(proviso, number):
    """Return whether another field says with its number that this one is a value."""
    met = [number & each == each if proviso["is_of_flags"] else number == each for each in proviso["numbers"]]
    if proviso["is_denied"]:
        return not any(met)
    return all(met) if proviso["is_of_flags"] else any(met)


def _text(field, value):
    """The text, None for unknown, or Ellipsis: it is not taken."""
    value = value.split("\0")[0]
    if not value.isascii():
        return Ellipsis
    return None if value == "" and field["sentinel"] is not None else value


def _number(field, value, kind):
    """Return the value kept of a number on the wire, None for unknown, Ellipsis: it is not taken, or AS_IT_WAS."""
    speaking = [value] if field["element"] is None else [value[each] for each in field["speaking"]]
    value = value if field["element"] is None else value[field["element"]]
    if kind in FLOATS:
        value, *speaking = (
            struct.unpack(FLOATS[kind], struct.pack(FLOATS[kind], each))[0] for each in (value, *speaking)
        )
        if not math.isfinite(value):
            return AS_IT_WAS if "nan" in field["unchanged"] else None
    if value in field["unchanged"]:
        return AS_IT_WAS
    if value in field["unknown"]:
        return None
    if all(each == field["sentinel"] for each in speaking):
        return None
    if not field["low"] <= value <= field["high"]:
        return Ellipsis
    if field["kind"] == "boolean":
        return value != 0
    if field["kind"] == "float":
        return value
    return _rounded(Fraction(value) * Fraction(field["factor"]), field["rounding"])


def _rounded(value, rounding):
    if rounding == "down":
        return math.floor(value)
    if rounding == "up":
        return math.ceil(value)
    if rounding == "toward_zero":
        return math.trunc(value)
    whole = math.floor(abs(value) + Fraction(1, 2))
    return whole if value >= 0 else -whole
