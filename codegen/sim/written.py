"""A file that is replaced whole, or left as it was."""

import os
import tempfile


def write_whole(path: str, text: str) -> None:
    """Write a text; what UTF-8 cannot carry becomes a question mark. OSError: it cannot be written."""
    folder = os.path.dirname(os.path.abspath(path))
    handle, temporary = tempfile.mkstemp(dir=folder, prefix=".codegen-sim-")
    try:
        with open(handle, "w", encoding="utf-8", errors="replace") as file:
            file.write(text)
        os.chmod(temporary, 0o644)
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise
