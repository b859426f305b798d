"""Names that tables give to what the generated Python calls so."""

import keyword

from codegen.pattern import pattern


def is_name(text: str) -> bool:
    """Return whether Python can call something so: small letters, digits, underscores, and no keyword."""
    return pattern(r"[a-z][a-z0-9_]*").fullmatch(text) is not None and not keyword.iskeyword(text)
