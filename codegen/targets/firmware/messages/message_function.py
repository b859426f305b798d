"""Views of the functions that go from the words of the state to a message: in machine code, and in plain Python."""

from textwrap import wrap

from codegen.frozen import dataclass
from codegen.model.system import Policy, PopulatedMessage, Representation, System
from codegen.model.vehicle import Component, Reading, Stream
from codegen.targets.firmware.messages.choice import choosing
from codegen.targets.firmware.messages.payload import SpelledCode
from codegen.targets.firmware.messages.payload_machine import MachineCode
from codegen.targets.firmware.messages.payload_plain import PlainCode
from codegen.targets.firmware.readings.reading import expiry, forgetting
from codegen.targets.firmware.words import ConstantView, Layout
from codegen.targets.imports import import_lines, in_brackets
from codegen.targets.naming import builder_name, class_names, encoder_name, frame_name, message_about


@dataclass(frozen=True, slots=True)
class FunctionView:
    """One message: what builds it, what makes its frame, the statements of its function, and what its frame needs.

    ``encoder`` takes the first instance and page where it is told none, ``frame`` is the function that has to be told.

    ``about`` are the instance and the page, as far as it has them; ``arguments`` are those of the builder behind the
    state. ``write`` is the builder's call of the function with the statements, and ``head`` the head of that one.
    ``last_word`` is the place of its last four bytes. ``is_withheld``: it may be. ``is_seldom``: it is on request only,
    or due at most once a second unless a ground station asks for more, and small code counts more than a quick one.
    """

    message: str
    citation: str
    class_name: str
    builder: str
    encoder: str
    frame: str
    instances: int
    is_for_each: bool
    about: str
    arguments: str
    head: str
    write: str
    is_withheld: bool
    is_seldom: bool
    parameters: tuple[str, ...]
    lines: tuple[str, ...]
    id_bytes: tuple[int, int, int]
    crc_extra: int
    length: int
    last_word: int


@dataclass(frozen=True, slots=True)
class SharedView:
    """A function that several others share in plain Python: its name, its arguments, and its statements."""

    name: str
    arguments: str
    lines: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class FunctionsView:
    """The module: constants of the state's words, texts, and a function for each message in the order of their ids.

    Nothing is ``shared`` in machine code but the end of messages that go out seldom: a call is dear there.
    """

    imports: tuple[str, ...]
    constants: tuple[ConstantView, ...]
    texts: tuple[tuple[str, str], ...]
    shared: tuple[SharedView, ...]
    functions: tuple[FunctionView, ...]
    puts_floats: bool
    puts_reals: bool
    is_withheld: bool
    is_any_seldom: bool
    ticks: bool


def _chosen(message: PopulatedMessage) -> tuple[Representation, ...]:
    """The components of several instances for which it is chosen at each call which one the message is about."""
    choices = message.represents.values()
    return tuple(choice for choice in choices if choice.policy is not Policy.FIRST and choice.component.instances > 1)


def functions_view(system: System, layout: Layout, *, machine_code: bool) -> FunctionsView:
    """The view of telemetry_viper.py, or of telemetry_plain.py."""
    words: dict[str, set[str]] = {}
    uses: set[str] = set()
    texts: dict[str, str] = {}
    shared: dict[str, SharedView] = {}
    functions = []
    classes = class_names(wire.name for wire in system.wires)
    for message in system.messages:
        code: SpelledCode = (MachineCode if machine_code else PlainCode)(layout, message.name.lower())
        functions.append(_function(message, classes[message.wire.name], system, code, shared))
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
        shared=tuple(shared.values()),
        functions=tuple(functions),
        puts_floats="put_float" in uses,
        puts_reals="put_real" in uses,
        is_withheld=any(function.is_withheld for function in functions),
        is_any_seldom=any(function.is_seldom for function in functions),
        ticks="tick" in uses,
    )


def _imports(uses: set[str], *, machine_code: bool) -> tuple[str, ...]:
    modules = {"messages"} | ({"micropython"} if machine_code else {"time"})
    names = {("micropython", "const")}
    if "clock" in uses:
        names.add(("time", "ticks_ms"))
    if "tick" in uses:
        names.add(("clock_viper" if machine_code else "clock_plain", "tick"))
    if "chip" in uses:
        modules.add("machine")
        names.add(("binascii", "hexlify"))
    if "put_float" in uses:
        names.add(("floats_viper", "put_floats") if machine_code else ("floats_plain", "put_float"))
    if "put_real" in uses:
        names.add(("reals_viper" if machine_code else "reals_plain", "put_real"))
    return import_lines(modules, names)


def _is_seldom(stream: Stream | None) -> bool:
    return stream is None or stream.fastest <= 1 or (stream.parameter is None and stream.default_rate <= 1)


def _function(
    message: PopulatedMessage, class_name: str, system: System, code: SpelledCode, shared: dict[str, SharedView]
) -> FunctionView:
    body: list[str] = []
    for answer in message.answers:
        body += ["", *answer.statements(code)]
    expired = _expiring(message, system)
    choices = [line for choice in _chosen(message) for line in ["", *choosing(choice, code)]]
    before = [line for reading in expired for line in ["", *_expiring_of(reading, code, shared)]]
    before = [*_ageing(message, system, code), *before]
    withheld = _withheld(message, code)
    cleared = code.cleared(message.wire.length)
    lines = [
        *_prologue(message, code),
        *choices,
        *(["", *cleared] if cleared else []),
        *before,
        *code.ticking(),
        *withheld,
        *body,
        *code.ending(),
        *(code.finished() if withheld else []),
    ]
    while lines and not lines[0]:
        lines.pop(0)
    wire, told = message.wire, message_about(message)
    call, given = code.call(told)
    return FunctionView(
        message=message.title,
        citation=str(message.citation),
        class_name=class_name,
        builder=builder_name(message),
        encoder=encoder_name(message),
        frame=frame_name(message),
        instances=message.instances,
        is_for_each=message.component is not None,
        about="".join(f", {value}" for value in told),
        arguments="".join(f", {value}=0" for value in told),
        head=in_brackets(*code.head(told), ":"),
        write=in_brackets(f"    done = {call.strip()}" if withheld else call, given, ""),
        is_withheld=bool(withheld),
        is_seldom=_is_seldom(message.stream),
        parameters=tuple(code.parameters),
        lines=tuple(part for line in lines for part in _printed(line)),
        id_bytes=(wire.id & 0xFF, wire.id >> 8 & 0xFF, wire.id >> 16),
        crc_extra=wire.crc_extra,
        length=wire.length,
        last_word=(wire.length - 1) // 4 * 4,
    )


def _ageing(message: PopulatedMessage, system: System, code: SpelledCode) -> list[str]:
    """Forget what code has not set for too long, of all that the message reads."""
    paths = (quantity.decided_by for answer in message.answers for quantity in answer.quantities)
    found = [quantity for quantity in map(system.quantity, dict.fromkeys(paths)) if quantity and quantity.ages]
    lines = [line for quantity in found for line in ["", *forgetting(quantity, code, "value")]]
    now = code.now() if lines else ""
    return [*(["", f"value = {now}"] if now not in ("", "value") else []), *lines]


def _withheld(message: PopulatedMessage, code: SpelledCode) -> list[str]:
    """Return the lines that withhold a message while something is unknown that its field cannot say."""
    lines = [line for answer in message.answers for line in answer.withholding(code)]
    return ["", "# The message is withheld while one of these is unknown.", *lines] if lines else []


def _printed(line: str) -> list[str]:
    """The line in the body of a function; a long remark takes several lines."""
    text = f"    {line}" if line else ""
    if len(text) <= 120 or not line.lstrip().startswith("#"):
        return [text]
    indent = text[: text.index("#")]
    return wrap(text, 116, initial_indent="", subsequent_indent=f"{indent}#   ", drop_whitespace=True)


def _expiring_of(reading: Reading, code: SpelledCode, shared: dict[str, SharedView]) -> list[str]:
    """Forget a reading that is too old: here in machine code, or else in a function that all messages share."""
    lines = expiry([reading], code, code.now())
    if not isinstance(code, PlainCode):
        return lines
    name, component = f"_expire_{reading.name}", reading.component
    arguments = ", ".join(["value", "words", *([component.name] if component.instances > 1 else [])])
    shared[name] = SharedView(name, arguments, tuple(part for line in lines for part in _printed(line)))
    return [f"{name}({arguments})"]


def _expiring(message: PopulatedMessage, system: System) -> list[Reading]:
    """The readings that can become too old of which the message reads something, in the state's order.

    The first one of a component counts for all that is read of that.
    """
    quantities = [quantity for answer in message.answers for quantity in answer.quantities]
    names = {quantity.component for quantity in quantities}
    paths = {path for quantity in quantities for path in (quantity.path, quantity.decided_by)}
    return [
        reading
        for reading in system.readings()
        if reading.expires
        and reading.component.name in names
        and (reading.is_first or any(quantity.path in paths for quantity in reading.given))
    ]


def _prologue(message: PopulatedMessage, code: SpelledCode) -> list[str]:
    """The variables that the statements need: where each component's words begin, and where they write."""
    is_chosen = {choice.component.name for choice in _chosen(message)}
    lines = [
        code.reach(name, _instance(block.component, message))
        for name, block in code.layout.blocks.items()
        if name in code.words and name not in is_chosen
    ]
    return [*code.sources(), *code.pointers(), *filter(None, lines)]


def _instance(component: Component, message: PopulatedMessage) -> str:
    """The instance of a component that a message reads, if it is one of several and not always the first."""
    is_own = message.component is not None and message.component.name == component.name
    return "instance" if is_own and component.instances > 1 else ""
