"""Numbers of the dialect in the program's modules, which are written with `dialect.MAV_RESULT_FAILED` and the like.

`dialect.PING_SEQ_AT` is where the payload of PING has its field seq: who writes it there needs no names of fields,
which take heap.

What is generated has a constant for each number in the module that uses it: MicroPython's compiler puts it where it is
used, while names that modules share stay on the heap.
"""

import re
from collections.abc import Iterable, Mapping

from codegen.model.dialect.dialect import WireMessage

_USE = re.compile(r"\bdialect\.([A-Z][A-Z0-9_]*)")
_IMPORTS = re.compile(r"^(?:(?:import|from) [^(\n]*(?:\([^)]*\))?\n|\n(?=import|from))+", re.MULTILINE)


def with_numbers(text: str, numbers: Mapping[str, int]) -> str:
    """Return a module with numbers in place of what it takes from the module dialect; it has to import const().

    One that takes nothing comes back as it is. KeyError: there is no such number.
    """
    names = sorted(set(_USE.findall(text)))
    if not names:
        return text
    constants = "".join(f"_{name} = const({numbers[name]})\n" for name in names)
    text = _USE.sub(r"_\1", text.replace("import dialect\n", "", 1))
    return _IMPORTS.sub(lambda imports: f"{imports[0]}\n# Numbers of the dialect.\n{constants}", text, count=1)


def places(wires: Iterable[WireMessage]) -> dict[str, int]:
    """Return where the payloads of messages have their fields, as offsets by names such as PING_SEQ_AT."""
    return {f"{wire.name}_{field.name}_AT".upper(): field.offset for wire in wires for field in wire.fields}
