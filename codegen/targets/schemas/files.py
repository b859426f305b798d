"""The JSON Schemas of the specification files, for editors."""

from typing import cast

from codegen.model.system import System
from codegen.targets.schemas.texts import schema_texts
from codegen.tool.cache import entry, keep_object, kept_object
from codegen.tool.digest import tool_digest


def render_schemas(_system: System) -> dict[str, str]:
    """The files below ``schemas/``; they follow from the models alone."""
    name = entry("schemas", tool_digest())
    texts = kept_object(name)
    if texts is None:
        texts = schema_texts()
        keep_object(name, texts)
    return {f"schemas/{name}": text for name, text in cast(dict[str, str], texts).items()}
