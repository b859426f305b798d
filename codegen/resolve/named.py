"""Names that tables give to what the generated Python calls so."""

import keyword
import re


def is_name(text: str) -> bool:
    """Return whether Python can call something so: small letters, digits, underscores, and no keyword."""
    return re.fullmatch(r"[a-z][a-z0-9_]*", text) is not None and not keyword.iskeyword(text)
