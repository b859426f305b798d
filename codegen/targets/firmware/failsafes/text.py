"""Texts of failsafes: the lines of the function that makes them."""

from collections.abc import Iterator

from codegen.model.failsafe import Clause, Failsafe, FailsafeLevel, FailsafeText, Sense, Shown
from codegen.targets.naming import quoted

ZERO = "0"
"""The text for unknown where nothing has counted yet."""


def text_lines(failsafe: Failsafe, variable: str) -> Iterator[str]:
    """The body of the function with the texts: ``level`` is the word of the level, None once it is over."""
    if failsafe.over is not None:
        yield "if level is None:"
        yield from (f"    {line}" for line in _said(failsafe.over, None, failsafe, variable))
    *others, last = failsafe.levels
    same = all(level.text.written == last.text.written for level in others)
    for level in () if same else others:
        yield f"if level == {quoted(level.name)}:"
        yield from (f"    {line}" for line in _said(level.text, level, failsafe, variable))
    yield from _said(last.text, max(failsafe.levels, key=_can_be_unknown) if same else last, failsafe, variable)


def shows(failsafe: Failsafe) -> bool:
    """Return whether a text of it has a quantity that can be unknown then."""
    texts: list[tuple[FailsafeText | None, FailsafeLevel | None]] = [(level.text, level) for level in failsafe.levels]
    same = len({level.text.written for level in failsafe.levels}) == 1
    if same:
        texts = [(failsafe.levels[0].text, max(failsafe.levels, key=_can_be_unknown))]
    texts.append((failsafe.over, None))
    return any(
        not _is_known(part, level, failsafe)
        for text, level in texts
        if text is not None
        for part in text.parts
        if isinstance(part, Shown) and part.unknown != ZERO
    )


def _can_be_unknown(level: FailsafeLevel) -> bool:
    return len(level.conditions) > 1 or any(each.sense is Sense.UNKNOWN for each in level.conditions)


def _is_known(part: Shown, level: FailsafeLevel | None, failsafe: Failsafe) -> bool:
    """Return whether a quantity cannot be unknown where it is shown: it is what was compared."""
    if part.quantity.initial is not None:
        return True
    if part.quantity is not failsafe.quantity or level is None or _can_be_unknown(level):
        return False
    return not failsafe.recovers or not any(len(worse.conditions) > 1 for worse in _worse(level, failsafe))


def _worse(level: FailsafeLevel, failsafe: Failsafe) -> tuple[FailsafeLevel, ...]:
    """Return the levels from which it may fall back to this one, whatever the value is meanwhile."""
    return failsafe.levels[failsafe.levels.index(level) + 1 :]


def _said(text: FailsafeText, level: FailsafeLevel | None, failsafe: Failsafe, variable: str) -> Iterator[str]:
    said, begun = "", False
    for part in text.parts:
        if isinstance(part, Clause):
            if said or not begun:
                yield f"said {'+=' if begun else '='} {_quoted(said)}"
            begun, said = True, ""
            yield from _clause(part, level, failsafe, variable)
            continue
        if not isinstance(part, Shown):
            said += part.replace("{name}", "{title}")
            continue
        name = part.quantity.name
        if _is_known(part, level, failsafe):
            said += f"{{{variable}.{name}:.{part.decimals}f}}"
            continue
        if part.unknown == ZERO:
            yield f"{name} = {variable}.{name} or 0"
            said += f"{{{name}:.{part.decimals}f}}"
            continue
        yield f"{name} = _shown({variable}.{name}, {part.decimals}, {quoted(part.unknown)})"
        said += f"{{{name}}}"
    before = "said" if begun else ""
    yield f"return {' + '.join(filter(None, (before, _quoted(said) if said or not before else '')))}"


def _clause(clause: Clause, level: FailsafeLevel | None, failsafe: Failsafe, variable: str) -> Iterator[str]:
    """The statements that add a part to ``said`` where all of it is known."""
    doubtful = [f"{variable}.{each.quantity.name}" for each in clause.shown if not _is_known(each, level, failsafe)]
    said = "".join(
        f"{{{variable}.{part.quantity.name}:.{part.decimals}f}}" if isinstance(part, Shown) else part
        for part in clause.parts
    ).replace("{name}", "{title}")
    add = f"said += {_quoted(said)}"
    if not doubtful:
        yield add
        return
    yield f"if {' and '.join(f'{each} is not None' for each in doubtful)}:"
    yield f"    {add}"


def _quoted(said: str) -> str:
    return f'{"f" if "{" in said else ""}"{said}"'
