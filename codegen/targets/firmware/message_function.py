"""Views of the functions that go from the words of the state to a message: in machine code, and in plain Python."""

from collections.abc import Iterable
from textwrap import wrap

from codegen.frozen import dataclass
from codegen.model.system import Policy, PopulatedMessage, Representation, System
from codegen.model.vehicle import Component
from codegen.targets.firmware.payload import SpelledCode
from codegen.targets.firmware.payload_machine import MachineCode
from codegen.targets.firmware.payload_plain import PlainCode
from codegen.targets.firmware.reading import expires, expiry
from codegen.targets.firmware.words import ConstantView, Layout
from codegen.targets.imports import import_lines, in_brackets
from codegen.targets.naming import writer_name


@dataclass(frozen=True, slots=True)
class FunctionView:
    """One message: the head of its function and the statements, and what its frame needs.

    ``takes_object``: the payload is given as an object. ``last_word`` is the
    place of its last four bytes.
    """

    name: str
    message: str
    citation: str
    head: str
    takes_object: bool
    values: tuple[str, ...]
    parameters: tuple[str, ...]
    lines: tuple[str, ...]
    id_bytes: tuple[int, int, int]
    crc_extra: int
    length: int
    last_word: int


@dataclass(frozen=True, slots=True)
class FunctionsView:
    """The module: constants of the state's words, texts, and a function for each message in the order of their ids."""

    imports: tuple[str, ...]
    constants: tuple[ConstantView, ...]
    texts: tuple[tuple[str, str], ...]
    functions: tuple[FunctionView, ...]
    puts_floats: bool


def chosen(message: PopulatedMessage) -> tuple[Representation, ...]:
    """The components of several instances for which it is chosen at each call which one the message is about."""
    choices = message.represents.values()
    return tuple(choice for choice in choices if choice.policy is not Policy.FIRST and choice.component.instances > 1)


def _values(message: PopulatedMessage, parameters: Iterable[str]) -> tuple[str, ...]:
    """The arguments behind the words: the instance, what is chosen, the page, and the parameters by attribute."""
    each = ["instance"] if message.component else []
    page = ["page"] if message.population.pages else []
    return (*each, *(f"{choice.component.name}_instance" for choice in chosen(message)), *page, *parameters)


def functions_view(system: System, layout: Layout, *, machine_code: bool) -> FunctionsView:
    """The view of telemetry_viper.py, or of telemetry_plain.py."""
    words: dict[str, set[str]] = {}
    uses: set[str] = set()
    texts: dict[str, str] = {}
    functions = []
    for message in system.messages:
        code: SpelledCode = (MachineCode if machine_code else PlainCode)(layout, message.name.lower())
        functions.append(_function(message, system, code))
        uses |= code.uses
        texts |= code.texts
        for component, names in code.words.items():
            words.setdefault(component, set()).update(names)
    constants = [
        constant
        for component in layout.blocks
        if component in words
        for constant in layout.constants(component, words[component], in_array=True)
    ]
    return FunctionsView(
        imports=_imports(uses, machine_code=machine_code),
        constants=tuple(constants),
        texts=tuple(texts.items()),
        functions=tuple(functions),
        puts_floats="put_float" in uses,
    )


def _imports(uses: set[str], *, machine_code: bool) -> tuple[str, ...]:
    modules = {"micropython"} if machine_code else set()
    names = {("micropython", "const")}
    if machine_code:
        names |= {("time", "ticks_ms"), ("checksum", "TABLE")}
    if "chip" in uses:
        modules.add("machine")
        names.add(("binascii", "hexlify"))
    if "put_float" in uses:
        names.add(("floats_viper" if machine_code else "floats_plain", "put_float"))
    if "make_float" in uses:
        names.add(("conversion", "make_float"))
    return import_lines(modules, names)


def _function(message: PopulatedMessage, system: System, code: SpelledCode) -> FunctionView:
    body: list[str] = []
    for answer in message.answers:
        body += ["", *answer.statements(code)]
    expired = [component for component in _read(message, system) if expires(component)]
    age = "value" if len(expired) == 1 else "age"  # the time is needed no more: boards have room for few variables
    before = [line for component in expired for line in ["", *expiry(component, code, "value", age)]]
    cleared = code.cleared(message.wire.length)
    lines = [*_prologue(message, code), *(["", *cleared] if cleared else []), *before, *body]
    while lines and not lines[0]:
        lines.pop(0)
    wire = message.wire
    values = _values(message, code.parameters)
    return FunctionView(
        name=writer_name(message),
        message=f"{message.name} ({wire.id})",
        citation=str(message.citation),
        head=in_brackets(f"def {writer_name(message)}", code.arguments(values), f"{code.returned}:"),
        takes_object="object" in code.uses,
        values=values,
        parameters=tuple(code.parameters),
        lines=tuple(part for line in lines for part in _printed(line)),
        id_bytes=(wire.id & 0xFF, wire.id >> 8 & 0xFF, wire.id >> 16),
        crc_extra=wire.crc_extra,
        length=wire.length,
        last_word=(wire.length - 1) // 4 * 4,
    )


def _printed(line: str) -> list[str]:
    """The line in the body of a function; a long remark takes several lines."""
    text = f"    {line}" if line else ""
    if len(text) <= 120 or not line.lstrip().startswith("#"):
        return [text]
    indent = text[: text.index("#")]
    return wrap(text, 116, initial_indent="", subsequent_indent=f"{indent}#   ", drop_whitespace=True)


def _read(message: PopulatedMessage, system: System) -> list[Component]:
    """The components of which the message reads something, in the order of the state."""
    names = {quantity.component for answer in message.answers for quantity in answer.quantities}
    return [component for component in system.components.values() if component.name in names]


def _prologue(message: PopulatedMessage, code: SpelledCode) -> list[str]:
    """The variables that the statements need: where each component's words begin, and where they write."""
    lines = []
    for name, block in code.layout.blocks.items():
        if name in code.words:
            lines.append(code.reach(name, _instance(block.component, message)))
    return [*code.pointers(), *filter(None, lines)]


def _instance(component: Component, message: PopulatedMessage) -> str:
    """The instance of a component that a message reads, if there are several."""
    if component.instances == 1:
        return ""
    if message.component is not None and message.component.name == component.name:
        return "instance"
    is_chosen = any(choice.component.name == component.name for choice in chosen(message))
    return f"{component.name}_instance" if is_chosen else ""
