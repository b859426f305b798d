"""View of telemetry.py: for each populated message what builds it, and what makes its frame."""

from codegen.frozen import dataclass
from codegen.model.system import PopulatedMessage, Representation, System
from codegen.targets.firmware.message_function import FunctionsView, FunctionView, chosen
from codegen.targets.firmware.reading import expires
from codegen.targets.firmware.words import ConstantView, Layout
from codegen.targets.imports import either_import, import_lines, in_brackets, order
from codegen.targets.naming import builder_name, class_names, encoder_name, parameter_attribute


@dataclass(frozen=True, slots=True)
class ChoiceView:
    """The function that chooses which of several instances a single message is about.

    ``lowest``, ``enabled`` and ``start`` are expressions of words: the quantity that decides, whether the instance is
    enabled, and where the words of it begin.
    """

    function: str
    component: str
    message: str
    instances: int
    parameter: str | None
    parameter_name: str
    lowest: str | None
    lowest_name: str
    enabled: str | None
    expires: bool


@dataclass(frozen=True, slots=True)
class BuilderView:
    """One message: its class, its functions, and what they pass to the one that writes it.

    ``arguments`` are those of the builder, ``forwarded`` what the encoder gives it; ``build`` and ``encode`` are their
    calls of the one that writes. ``is_direct``: the encoder passes nothing but the instance on.
    """

    name: str
    id: int
    class_name: str
    function: str
    encoder: str
    write: str
    store: str
    citation: str
    instances: int
    is_for_each: bool
    is_direct: bool
    arguments: str
    forwarded: str
    build: str
    encode: str
    chosen: tuple[ChoiceView, ...]


@dataclass(frozen=True, slots=True)
class TelemetryView:
    """The module: the builders in order of message id, and the constants of the words that choices read."""

    imports: tuple[str, ...]
    write_imports: tuple[str, ...]
    builders: tuple[BuilderView, ...]
    constants: tuple[ConstantView, ...]


def telemetry_view(system: System, functions: FunctionsView, layout: Layout) -> TelemetryView:
    """The view of the whole module."""
    classes = class_names(wire.name for wire in system.wires)
    builders = tuple(
        _builder(message, classes[message.name], function, layout)
        for message, function in zip(system.messages, functions.functions, strict=True)
    )
    words: dict[str, set[str]] = {}
    for message in system.messages:
        for choice in chosen(message):
            used = [quantity for quantity in (choice.quantity, choice.component.enabled) if quantity]
            words.setdefault(choice.component.name, set()).update(quantity.attribute for quantity in used)
    factories = {"each_encoder" if builder.is_for_each else "encoder" for builder in builders if builder.is_direct}
    framed = () if all(builder.is_direct for builder in builders) else ("TABLE_AT",)
    names: set[tuple[str, str]] = set()
    if words:
        names.add(("micropython", "const"))
    return TelemetryView(
        imports=import_lines(["messages", "time"], names),
        write_imports=either_import(
            "telemetry",
            sorted({*factories, *framed, *(builder.write for builder in builders)}, key=order),
            machine_code=system.spec.project.machine_code,
        ),
        builders=builders,
        constants=tuple(
            constant
            for component in layout.blocks
            if component in words
            for constant in layout.constants(component, words[component], in_array=True)
        ),
    )


def _builder(message: PopulatedMessage, class_name: str, function: FunctionView, layout: Layout) -> BuilderView:
    choices = tuple(_choice(choice, message, layout) for choice in chosen(message))
    by_choice = {f"{choice.component}_instance": f"{choice.function}(state)" for choice in choices}
    parameters = {name: f"state.parameters.{name}" for name in function.parameters}
    given = [value for value in function.values if value not in by_choice and value not in parameters]
    passed = ["state.words", *(by_choice.get(value) or parameters.get(value) or value for value in function.values)]
    return BuilderView(
        name=message.name,
        id=message.wire.id,
        class_name=class_name,
        function=builder_name(message),
        encoder=encoder_name(message),
        write=function.name,
        store=f"_{message.name.lower()}",
        citation=str(message.citation),
        instances=message.instances,
        is_for_each=message.component is not None,
        is_direct=function.values == (("instance",) if message.component else ()),
        arguments="".join(f", {value}=0" for value in given),
        forwarded="".join(f", {value}" for value in given),
        build=in_brackets(f"    {function.name}", ", ".join(("time.ticks_ms()", "0", "message.wire", *passed)), ""),
        encode=in_brackets(
            f"        length = {function.name}", ", ".join(("time.ticks_ms()", "TABLE_AT", "link.room", *passed)), ""
        ),
        chosen=choices,
    )


def _choice(choice: Representation, message: PopulatedMessage, layout: Layout) -> ChoiceView:
    component = choice.component
    block = layout.blocks[component.name]
    start = f"{block.base_constant} + {block.size_constant} * instance"

    def word(attribute: str) -> str:
        return f"words[{start} + {block.constant(attribute)}]"

    return ChoiceView(
        function=f"_{message.name.lower()}_{component.name}",
        component=component.name,
        message=message.name,
        instances=component.instances,
        parameter=parameter_attribute(choice.parameter.name) if choice.parameter else None,
        parameter_name=choice.parameter.name if choice.parameter else "",
        lowest=word(choice.quantity.attribute) if choice.quantity else None,
        lowest_name=choice.quantity.name if choice.quantity else "",
        enabled=word(component.enabled.attribute) if component.enabled else None,
        expires=expires(component),
    )
