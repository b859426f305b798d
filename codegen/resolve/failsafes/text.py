"""Texts of failsafes as they are written, with quantities in braces: ``{name} is {level}[ {voltage:.2}V]``."""

from codegen.diagnostics import Report, did_you_mean
from codegen.model.failsafe import Clause, FailsafeText, Shown
from codegen.model.vehicle import Component, Quantity
from codegen.pattern import pattern
from codegen.resolve.failsafes.finding import BAD_FAILSAFE
from codegen.resolve.failsafes.shown_unit import other_unit
from codegen.source import Place

NAME, LEVEL, VALUE = "name", "level", "value"

_CLAUSE = pattern(r"\[([^][]*)\]")
_FIELD = pattern(r"([^{}]*)\{([a-z_][a-z0-9_]*)(?: or ([^{}:]*?))?(?::\.([0-9])f?)?\}")


def read_text(
    written: str, place: Place, component: Component | None, watched: Quantity | None, report: Report
) -> FailsafeText | None:
    """The text; None, with a finding, where braces name nothing. ``{name}`` and ``{level}`` stay as they are."""
    if not written.strip():
        message = "an empty text goes to every ground station, and tells none what has happened"
        report.add(BAD_FAILSAFE, place, message, "leave it out: without it a text says what is watched and which level")
        return None
    found: list[str | Shown | Clause] = []
    for number, piece in enumerate(_CLAUSE.split(written)):
        parts = _parts(piece, place, component, watched, report)
        if parts is None:
            return None
        if not number % 2:
            found += parts
        elif any(isinstance(part, Shown) for part in parts):
            found.append(Clause(parts))
        elif not _names_a_quantity(piece, component):  # else what is wrong with that was reported
            report.add(
                BAD_FAILSAFE,
                place,
                f"[{piece}] shows no quantity, so that nothing leaves it out",
                hint=f"name a quantity in braces in it, or leave out the brackets: {piece.strip()}",
            )
            return None
    return FailsafeText(written, tuple(found))


def _names_a_quantity(piece: str, component: Component | None) -> bool:
    return component is not None and any(component.spec.is_written(field[2]) for field in _FIELD.finditer(piece))


def _parts(
    written: str, place: Place, component: Component | None, watched: Quantity | None, report: Report
) -> tuple[str | Shown, ...] | None:
    parts: list[str | Shown] = []
    end = 0
    for field in _FIELD.finditer(written):
        if field.start() != end:
            break
        end = field.end()
        before, name, unknown, decimals = field.groups()
        if before:
            parts.append(before)
        if name in (NAME, LEVEL):
            parts.append(f"{{{name}}}")
            continue
        quantity = watched if name == VALUE else component.quantities.get(name) if component else None
        if quantity is None and component and component.spec.is_written(name):
            continue  # what is wrong with it was reported
        if quantity is None or quantity.elements is not None:
            known = [NAME, LEVEL, *([VALUE] if watched else []), *(component.quantities if component else ())]
            message = f"a text has no {{{name}}} to show"
            report.add(BAD_FAILSAFE, place, message, did_you_mean(name, known) or f"it can show {', '.join(known)}")
            return None
        shown = other_unit(quantity, written[end:])
        if shown is not None:
            message = f"{quantity.path} is shown in {quantity.unit.name}, and the text goes on with {shown}"
            report.add(BAD_FAILSAFE, place, message, f"{field[0].removeprefix(before)} {quantity.unit.name}")
            return None
        instead = _apart(unknown or "unknown", written[end:])
        parts.append(Shown(quantity, int(decimals) if decimals else _decimals(quantity), instead))
    rest = written[end:]
    if (
        set("[]") & set(written)
        or set("{}") & set(rest)
        or '"' in written
        or "\\" in written
        or not written.isprintable()
    ):
        hint = "write {level}, {value:.2}, {QUANTITY or 0:.1}, [ with {QUANTITY}]"
        report.add(
            BAD_FAILSAFE, place, f"{written!r} has braces, brackets, quotes or characters that no text has", hint
        )
        return None
    return (*parts, rest) if rest else tuple(parts)


def _apart(word: str, rest: str) -> str:
    """Return a word that stands for a number, with a blank before a unit that is written right behind the number."""
    return f"{word} " if word[-1:].isalpha() and (rest[:1].isalpha() or rest[:1] in ("%", "\u00b0")) else word


def _decimals(quantity: Quantity) -> int:
    """Return as many decimals as the stored steps have, two at most."""
    decimals = 0
    while decimals < 2 and 10**decimals < quantity.steps:
        decimals += 1
    return decimals
