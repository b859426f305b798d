"""Lines of generated modules: what they import, as their views have turned out to need it, and long statements."""

from collections.abc import Iterable

LINE_LENGTH = 120

STANDARD = frozenset({"array", "asyncio", "binascii", "gc", "select", "struct", "time"})
"""Modules of Python's own library that MicroPython has, too: they come first."""


def import_lines(modules: Iterable[str] = (), names: Iterable[tuple[str, str]] = ()) -> tuple[str, ...]:
    """``import machine`` for each module and ``from time import ticks_ms`` for each name of one, in ruff's order.

    An empty line parts Python's own modules from the others.
    """
    by_module: dict[str, set[str]] = {}
    for module, name in names:
        by_module.setdefault(module, set()).add(name)
    groups = []
    for is_standard in (True, False):
        whole = [f"import {module}" for module in sorted(set(modules)) if (module in STANDARD) is is_standard]
        parts = [
            line
            for module, found in sorted(by_module.items())
            if (module in STANDARD) is is_standard
            for line in _from(module, sorted(found, key=order))
        ]
        groups.append([*whole, *parts])
    return tuple("\n\n".join("\n".join(group) for group in groups if group).split("\n"))


_LACKING = "AttributeError, ImportError, NotImplementedError, SyntaxError, TypeError, ValueError"
"""The exceptions of interpreters that cannot run a module in machine code, or a part of it."""


def _from(module: str, names: list[str], indent: int = 0) -> list[str]:
    line = f"from {module} import {', '.join(names)}"
    if indent + len(line) <= LINE_LENGTH:
        return [line]
    return [f"from {module} import (", *(f"    {name}," for name in names), ")"]


def either_import(name: str, names: list[str], *, machine_code: bool) -> tuple[str, ...]:
    """The import of a module in the fastest form that an interpreter runs: ``name_viper``, or else ``name_plain``."""
    plain = _from(f"{name}_plain", names)
    if not machine_code:
        return tuple(plain)
    return (
        "try:",
        *(f"    {line}" for line in _from(f"{name}_viper", names, indent=4)),
        f"except ({_LACKING}):  # as in frames",
        *(f"    {line}" for line in _from(f"{name}_plain", names, indent=4)),
    )


def in_brackets(before: str, inside: str, after: str) -> str:
    """A statement with brackets, as the formatter prints it: where it is too long, what they hold has its own line."""
    line = f"{before}({inside}){after}"
    if len(line) <= LINE_LENGTH:
        return line
    indent = " " * (len(before) - len(before.lstrip()))
    return f"{before}(\n{indent}    {inside}\n{indent}){after}"


def one_by_one(before: str, items: Iterable[str], after: str = "", brackets: str = "()") -> list[str]:
    """A statement with items in brackets, as the formatter prints it: what they hold, or each, has its own line."""
    listed, opened, closed = list(items), brackets[0], brackets[1]
    line = f"{before}{opened}{', '.join(listed)}{closed}{after}"
    if len(line) <= LINE_LENGTH:
        return [line]
    indent = " " * (len(before) - len(before.lstrip()))
    within = f"{indent}    {', '.join(listed)}"
    if len(within) <= LINE_LENGTH:
        return [f"{before}{opened}", within, f"{indent}{closed}{after}"]
    return [f"{before}{opened}", *(f"{indent}    {item}," for item in listed), f"{indent}{closed}{after}"]


def text_literals(words: Iterable[object], indent: int) -> tuple[str, ...]:
    """Words with blanks between them as literals that are one text, each in a line that begins with so many blanks."""
    parts = [""]
    for at, word in enumerate(words):
        text = f" {word}" if at else str(word)
        if indent + len(f'"{parts[-1]}{text}"  # uint32') > LINE_LENGTH:
            parts.append("")
        parts[-1] += text
    return tuple(f'"{part}"' for part in parts)


def order(name: str) -> tuple[bool, str]:
    """Constants, then classes, which a capital letter sorts before functions: so does ruff."""
    return (not name.isupper(), name)


def tuple_text(items: Iterable[object]) -> str:
    """``("wifi", 0)``: a tuple of texts, numbers and tuples as the formatter writes it."""
    shown = [tuple_text(each) if isinstance(each, tuple) else _literal(each) for each in items]
    return f"({', '.join(shown)}{',' if len(shown) == 1 else ''})"


def _literal(item: object) -> str:
    return f'"{item}"' if isinstance(item, str) else str(item)
