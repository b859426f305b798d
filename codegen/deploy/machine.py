"""Compares a board with the kind that board.yaml names, by what its MicroPython says: ``PYBv1.1 with STM32F405RG``."""

import re
from collections.abc import Iterable

from codegen.model.board_model import BoardModelSpec

_ESP32 = re.compile(r"ESP32(?:-?([SCHPE][1-9]\d?))?", re.IGNORECASE)
"""The series, with or without its hyphen; modules, packages and memory follow: ESP32-PICO-D4, ESP32-S3R8."""


def is_other_board(known: BoardModelSpec, machine: str, shipped: Iterable[BoardModelSpec]) -> bool:
    """Return whether a board that calls itself ``machine`` is not of the kind ``known``.

    It has another chip, or it is one of those that come with codegen (``shipped``), and another of them. A board of
    somebody else with the same chip is none: its name says nothing about its pins.
    """
    name, _, chip = machine.rpartition(" with ")
    if not is_same_chip(known.mcu, chip):
        return True
    by_name = {_folded(each.name): each for each in shipped}
    told = by_name.get(_folded(name))
    if told is None:
        return False
    if _folded(known.name) in by_name:
        return told is not by_name[_folded(known.name)]
    return known.wifi and not told.wifi


def is_other_chip(known: BoardModelSpec, machine: str) -> bool:
    """Return whether a board that calls itself ``machine`` says that its chip is not that of the kind ``known``.

    A board file in which no chip is named, which would have a number, says nothing of it.
    """
    _, told, chip = machine.rpartition(" with ")
    is_named = any(each.isdigit() for each in known.mcu)
    return bool(told) and is_named and not is_same_chip(known.mcu, chip)


def is_same_chip(written: str, told: str) -> bool:
    """Return whether two names mean the same chip: one may have more to say of its package than the other."""
    ours, theirs = _ESP32.match(written.strip()), _ESP32.match(told.strip())
    if ours or theirs:
        return bool(ours and theirs) and _series(ours) == _series(theirs)
    first, second = sorted((_folded(written), _folded(told)), key=len)
    return bool(first) and second.startswith(first)


def _series(found: "re.Match[str] | None") -> str:
    return (found[1] or "").upper() if found else ""


def _folded(name: str) -> str:
    """Return the letters and figures of a name, which are all that two spellings have in common."""
    return "".join(each for each in name.lower() if each.isalnum())
