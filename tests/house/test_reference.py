"""docs/reference.md has every key that a file of the specification can have, in the words of the schemas."""

import json
from pathlib import Path

from codegen.targets.schemas.reference import FILES, reference_page
from codegen.targets.schemas.texts import SCHEMA_MODELS, schema_texts

ROOT = Path(__file__).resolve().parents[2]


def keys(schema: object) -> set[str]:
    """The names of all properties anywhere in a schema."""
    if isinstance(schema, list):
        return {key for each in schema for key in keys(each)}
    if not isinstance(schema, dict):
        return set()
    own = set(schema.get("properties", ()))
    return own | {key for each in schema.values() for key in keys(each)}


def test_page_is_what_the_schemas_say() -> None:
    """`make reference` writes it."""
    assert (ROOT / "docs" / "reference.md").read_text() == reference_page()


def test_page_has_each_key_of_each_file() -> None:
    assert FILES.keys() == SCHEMA_MODELS.keys()
    page = reference_page()
    for name, text in schema_texts().items():
        after = page.split(f"## {FILES[name]}\n", 1)[1]
        part = after.split("\n## ", 1)[0]
        for key in keys(json.loads(text)):
            assert f"`{key}`" in part, (name, key)
