"""Writes a project that answers the fields of some messages, and tells which line is about which of them."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from population.answer import Answer

FILES = {
    "codegen.yaml": "project: population\ndialect: {dialect}\n",
    "board.yaml": "board: pico_2\n",
    "parameters.yaml": "parameters: {{}}\n",
    "streams.yaml": "streams:\n  ALL: {{doc: All messages., rate: 1 Hz}}\n",
    "requirements/FR-1.md": (
        "# FR-1 | Everything is sent\n\n## Metadata\n\n- Status: Draft\n\n## Acceptance Criteria\n\n"
        "1. Every field is what was set.\n"
    ),
}

Places = Mapping[tuple[str, int], Answer]
"""The answer that a line of a file is about."""


def write_project(folder: Path, dialect: str, tables: Mapping[str, Sequence[Answer]]) -> Places:
    """Write the specification of messages by name, and tell which lines are about which answer."""
    specs = folder / "specs"
    (specs / "messages").mkdir(parents=True, exist_ok=True)
    (specs / "requirements").mkdir(exist_ok=True)
    for name, text in FILES.items():
        (specs / name).write_text(text.format(dialect=dialect))
    places: dict[tuple[str, int], Answer] = {}
    _write(specs / "state.yaml", "state.yaml", _state(tables), places)
    for name, answers in tables.items():
        path = f"messages/{name.lower()}.yaml"
        _write(specs / path, path, _table(name, answers), places)
    return places


def _write(
    path: Path, name: str, lines: Iterator[tuple[str, Answer | None]], places: dict[tuple[str, int], Answer]
) -> None:
    texts = []
    for number, (line, about) in enumerate(lines, 1):
        texts.append(line)
        if about is not None:
            places[name, number] = about
    path.write_text("\n".join([*texts, ""]))


def _state(tables: Mapping[str, Sequence[Answer]]) -> Iterator[tuple[str, Answer | None]]:
    yield "components:", None
    for message, answers in tables.items():
        lines = [line for each in answers if each.is_first for line in _quantities(each)]
        if lines:
            yield f"  {message.lower()}:", None
            yield f"    doc: What {message} tells.", None
            yield "    quantities:", None
            yield from lines


def _quantities(found: Answer) -> Iterator[tuple[str, Answer]]:
    if found.kind == "flags":
        for name, value in found.flags:
            if name:
                yield f"      {name}: {{doc: Flag {value}., boolean: true, initial: false}}", found
    elif found.kind in ("number", "enum") or found.quantity:
        keys = "".join(f", {key}: {_quoted(value)}" for key, value in found.quantity)
        yield f'      {found.name}: {{doc: "{found.key}."{keys}}}', found


def _quoted(value: str) -> str:
    return f'"{value}"' if "%" in value or "*" in value else value


def _table(message: str, answers: Sequence[Answer]) -> Iterator[tuple[str, Answer | None]]:
    yield f"message: {message}", None
    yield "requirement: FR-1.1", None
    yield "stream: ALL", None
    if any(each.withholds for each in answers):
        yield "send: while_known", None
    yield "fields:", None
    yield from ((f"  {each.key}: {each.written}", each) for each in answers if each.is_first)
