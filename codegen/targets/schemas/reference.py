"""The page about every key of the specification, made from the schemas that editors read."""

import json
from collections.abc import Iterator, Mapping
from typing import Any

from codegen.targets.schemas.texts import schema_texts

FILES = {
    "codegen.schema.json": "codegen.yaml",
    "program.schema.json": "codegen.yaml of a further program",
    "state.schema.json": "state.yaml",
    "board.schema.json": "board.yaml",
    "board_model.schema.json": "boards/*.yaml",
    "driver.schema.json": "drivers/*.yaml",
    "parameters.schema.json": "parameters.yaml",
    "streams.schema.json": "streams.yaml",
    "message.schema.json": "messages/*.yaml",
    "receive.schema.json": "receives/*.yaml",
    "vehicle.schema.json": "vehicle.yaml",
    "commands.schema.json": "commands.yaml",
    "receiver.schema.json": "receiver.yaml",
    "scenarios.schema.json": "scenarios.yaml",
    "corrections.schema.json": "dialects/*.yaml",
    "waivers.schema.json": "waivers.yaml",
    "trace_lock.schema.json": "trace.lock.yaml",
}
"""The schemas in the order of the page, with what their files are called."""

_HEAD = """\
# Every key of the specification

Made from the schemas by `make reference`. A key in bold has to be written; without a key counts what stands behind `=`.
"""

_Schema = Mapping[str, Any]


def reference_page() -> str:
    """The page, in Markdown."""
    texts = schema_texts()
    return "\n".join([_HEAD, *(line for name in FILES for line in _file(name, json.loads(texts[name])))]) + "\n"


def _file(name: str, schema: _Schema) -> Iterator[str]:
    yield from (f"## {FILES[name]}", "", *_record(schema))
    for record, inner in sorted(schema.get("$defs", {}).items()):
        yield from (f"### {FILES[name]}: {_called(record)}", "", *_record(inner))


def _record(schema: _Schema) -> Iterator[str]:
    """Yield what a record is, and its keys; a short form stands for it in one word."""
    forms = [each for each in schema.get("anyOf", ()) if "enum" in each]
    full = next((each for each in schema.get("anyOf", ()) if "properties" in each), schema)
    yield from (_text(schema.get("description", "")), "")
    for form in forms:
        yield from (f"In one word: {_words(form['enum'])}.", "")
    if "oneOf" in full:
        chosen = [key for choice in full["oneOf"] for key in choice["required"]]
        yield from (f"Exactly one of {_words(chosen)}.", "")
    yield from ("| key | is | meaning |", "| --- | --- | --- |")
    required = full.get("required", ())
    for key, value in full.get("properties", {}).items():
        shown = f"**`{key}`**" if key in required else f"`{key}`"
        has_default = value.get("default", []) != []
        default = f" = `{json.dumps(value['default'], ensure_ascii=False)}`" if has_default else ""
        yield f"| {shown} | {_shape(value)}{default} | {_text(value['description'])} |"
    yield ""


def _shape(schema: _Schema) -> str:
    if "$ref" in schema:
        return _called(schema["$ref"].rpartition("/")[2])
    if "anyOf" in schema:
        return " or ".join(_shape(each) for each in schema["anyOf"])
    if "enum" in schema:
        return _words(schema["enum"])
    if "const" in schema:
        return f"`{json.dumps(schema['const'])}`"
    kind = schema.get("type")
    if kind == "array":
        return f"list of {_shape(schema['items'])}"
    if kind == "object":
        return f"by name: {_shape(schema['additionalProperties'])}"
    return "text, number or boolean" if isinstance(kind, list) else {"string": "text"}.get(str(kind), str(kind))


def _called(record: str) -> str:
    """``QuantitySpec`` as people read it: quantity."""
    words = record.removesuffix("Spec")
    return "".join(f" {letter.lower()}" if letter.isupper() else letter for letter in words).strip()


def _words(words: Any) -> str:
    return ", ".join(f"`{word}`" for word in words)


def _text(text: str) -> str:
    return text.replace("|", "\\|").replace("<", "&lt;").replace("*", "\\*")
