"""The JSON Schemas of the specification files, for editors."""

from codegen.model.system import System
from codegen.schemas import schema_texts


def render_schemas(_system: System) -> dict[str, str]:
    """The files below ``schemas/``; they follow from the models alone."""
    return {f"schemas/{name}": text for name, text in schema_texts().items()}
