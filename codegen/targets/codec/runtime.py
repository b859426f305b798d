"""The part of the codec that is the same for every dialect: links, messages and frames."""

from codegen.targets.origin import headed, origin_of_text
from codegen.template_files import copied

MODULES = ("checksum", "fields", "frames", "frames_plain", "mavlink", "message", "nearest", "receiver", "sender")
"""Modules that a link needs; signing.py comes with those that sign, frames_viper.py where machine code is wanted."""

MACHINE_CODE = "frames_viper"


def runtime_files(folder: str, *more: str) -> dict[str, str]:
    """The modules, and ``more`` of templates/codec, by path; ``folder`` is "" or ends in a slash."""
    files = {}
    for module in sorted((*MODULES, *more)):
        text = copied(f"codec/{module}.py")
        if module == "frames" and MACHINE_CODE not in more:
            text = _without_machine_code(text)
        files[f"{folder}{module}.py"] = headed(text, origin_of_text(f"templates/codec/{module}.py", text))
    return files


def _without_machine_code(text: str) -> str:
    """frames.py without its attempt to import machine code: a file that is left over must not be found."""
    before, _, rest = text.partition("try:\n")
    _, _, after = rest.partition("\n    from frames_plain")
    return f"{before}from frames_plain{after}"
