"""The class of a sensor beside what the firmware calls of it, as far as its source shows it."""

from collections.abc import Mapping, Sequence
from dataclasses import field
from difflib import get_close_matches

from codegen.diagnostics import Rule
from codegen.frozen import dataclass
from codegen.model.spec.driver import DriverModule
from codegen.model.spec.python_class import PythonClass
from codegen.source import Place
from codegen.sources.kind import Around

UNFIT_DRIVER_CLASS = Rule(
    "unfit-driver-class",
    "The class of a sensor cannot be used as the firmware uses it: its constructor does not take what it is made with, "
    "a method that is called is missing or takes other arguments, nothing sets its values, or these are more or fewer "
    "than its outputs take. The board would find that out at the start, or at the first turn of the sensor. A class "
    "that inherits from another module, or of which the source does not show all, is not looked at.",
    remedy="write the class as the firmware uses it: docs/sources.md has one",
)


@dataclass(frozen=True, slots=True)
class Use:
    """The use of a class: it is made with ``first`` by their places and ``names`` by name, then ``calls`` are called.

    These have so many arguments by their places. ``attributes`` are read; a line shows what sets each. ``lengths`` are
    how many elements some of these have to have.
    """

    first: tuple[str, ...]
    names: tuple[str, ...]
    calls: dict[str, tuple[str, ...]]
    attributes: dict[str, str]
    lengths: Mapping[str, int] = field(default_factory=dict)

    @property
    def made(self) -> str:
        """The head of a constructor that takes all of it."""
        return f"def __init__({', '.join(('self', *self.first, *self.names))}):"


def check_use(name: str, module: DriverModule | None, place: Place, use: Use, around: Around) -> None:
    """Report what the class does not take, or does not have."""
    shape = module.shapes.get(name) if module is not None and module.names is not None else None
    if module is None or shape is None:
        return
    file = module.path.rpartition("/")[2]
    for message, hint in (*_making(shape, use), *_calling(shape, use), *_reading(shape, use)):
        at = (Place(module.path, shape.line), "the class is here")
        around.report.add(UNFIT_DRIVER_CLASS, place, f"{name} of {file} {message}", hint, [at])
        around.failed = True


def _making(shape: PythonClass, use: Use) -> Sequence[tuple[str, str]]:
    signature = shape.methods.get("__init__")
    if "__init__" in shape.methods and signature is None:
        return ()
    given = [*use.first, *use.names]
    if signature is None:  # it has no constructor of its own
        if shape.is_open or not given:
            return ()
        return ((f"has no constructor, and is made with {', '.join(given)}", use.made),)
    why = signature.refusal(len(use.first), use.names)
    words = ", ".join(given) or "nothing"
    return ((f"cannot be made with {words}: __init__ {why}", use.made),) if why else ()


def _calling(shape: PythonClass, use: Use) -> Sequence[tuple[str, str]]:
    found = []
    for method, arguments in use.calls.items():
        head = f"def {method}({', '.join(('self', *arguments))}):"
        signature = shape.methods.get(method)
        if method not in shape.attributes:
            near = get_close_matches(method, shape.methods, n=1)
            hint = f"did you mean {near[0]}? {head}" if near else head
            found += [] if shape.is_open else [(f"has no {method}(), which is called", hint)]
        elif signature is not None:
            why = signature.refusal(len(arguments), ())
            found += [(f"cannot be asked: {method} {why}", head)] if why else []
    return found


def _reading(shape: PythonClass, use: Use) -> Sequence[tuple[str, str]]:
    lacking = [] if shape.is_open else [name for name in use.attributes if name not in shape.attributes]
    found = [(f"has no {name}, which is read", use.attributes[name]) for name in lacking]
    for name, length in use.lengths.items():
        shown = shape.lengths.get(name, length)
        if shown != length:
            found.append((f"makes {name} with {shown}, and {length} are read", use.attributes[name]))
    return found
