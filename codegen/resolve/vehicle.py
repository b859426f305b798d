"""The board, the parameters and the streams of the specification, resolved."""

from collections.abc import Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.measure import find_unit, read_amount, read_time
from codegen.model.board_model import BoardModel, shown_pins
from codegen.model.code.storage import SMALL_INT_MAX
from codegen.model.dialect.literals import exact_number
from codegen.model.spec.board import AdcSpec, BoardSpec
from codegen.model.spec.spec import ParameterSpec, ParametersSpec, ParameterType, Requirement
from codegen.model.units.unit import NUMBER, decimal, unit_named
from codegen.model.vehicle import AdcChannel, Citation, Parameter
from codegen.pattern import pattern
from codegen.resolve.carried_parameter import check_carried
from codegen.resolve.citation import cite_aspects, cite_optional
from codegen.resolve.families import Member, ParameterFamilies
from codegen.resolve.in_force import said_start, unsaid_start
from codegen.source import Place

BAD_ADC = Rule(
    "bad-adc",
    "An ADC channel cannot be built: its pin is an input of the board's converter, a count has 8 bits to as many as "
    "the converter has, and a mean needs 1 to 64 samples. A parameter that has the pin takes such numbers only, and "
    "says reboot: true, as that of when does: both are looked at when the board starts.",
    remedy="take a board with a converter, or leave the channel out",
)
_NAME = pattern("[A-Z][A-Z0-9_]{0,15}")
"""Of a parameter, as PARAM_VALUE carries it."""

BAD_PARAMETER = Rule(
    "bad-parameter",
    "A parameter contradicts itself: names have at most 16 characters of A-Z, 0-9 and _; min <= default <= max; all "
    "three are whole multiples of step and, in steps, fit a small integer of MicroPython. A whole type has a whole "
    "step and carries min and max; single values lie within them, each once, and the default is one of them. What "
    "values of earlier names are multiplied by is a factor between units, and not 0.",
    remedy="make min, default and max whole multiples of step, in this order",
)
UNKNOWN_PARAMETER = Rule(
    "unknown-parameter",
    "A table names a parameter that parameters.yaml does not have.",
    remedy="write it in parameters.yaml",
)

_Fault = tuple[str, str, str]
"""The key of a parameter that is wrong, what is wrong with it, and a hint."""
_NAMES = "use at most 16 of A-Z, 0-9 and _"
_REAL = "leave type out: REAL32 carries it; or narrow min and max, with whole steps"
_LONGEST_LIMIT_US = 1_000_000
"""The main loop stands still meanwhile, and a watchdog resets the board."""
_LEAST_FACTOR = Fraction(1, 10**9)
"""From one unit to another in which a vehicle counts: nA and A."""
_VALUE = "write a multiple of step from min to max"


def resolve_channels(
    board: BoardSpec,
    model: BoardModel | None,
    written: ParametersSpec,
    parameters: Mapping[str, Parameter],
    index: Mapping[str, Requirement],
    report: Report,
) -> dict[str, AdcChannel]:
    """The ADC channels by name; ``model`` is what is known about the board."""
    channels: dict[str, AdcChannel] = {}
    converter = model.adc if model else None
    if model is None or converter is None:
        if model is not None or board.board is None:  # else what is wrong with the board has been reported
            _report_no_converter(board, model, report)
        return channels
    for name, spec in board.adc.items():
        citation = cite_optional(spec.requirement, spec.at("requirement"), index, report)
        reference: Fraction | None = converter.reference
        if spec.reference is not None:
            reference = read_amount(spec.reference, unit_named("V"), spec.at("reference"), report)
        bits = converter.bits if spec.bits is None else spec.bits
        limit = _read_limit(spec, report)
        pin = None if spec.pin is None else find_parameter(spec.pin, spec.at("pin"), written, parameters, report)
        gpio = _gpio(name, spec, pin, model, converter.pins & model.free, report)
        when = _when(name, spec, written, parameters, report)
        sane = gpio is not None and (when is not None or not spec.when)
        for key, value, low, high in (
            ("bits", bits, 8, converter.bits),
            ("samples", spec.samples, 1, 64),
        ):
            if not low <= value <= high:
                report.add(
                    BAD_ADC,
                    spec.at(key),
                    f"{key} of {name} is {value}, not {low} to {high}",
                    hint=f"{key}: {min(max(value, low), high)}",
                )
                sane = False
        if reference is not None and reference <= 0:
            report.add(
                BAD_ADC, spec.at("reference"), f"the reference of {name} is not above 0 V", hint="reference: 3.3 V"
            )
            sane = False
        if reference is None or gpio is None or not sane:
            continue
        channels[name] = AdcChannel(
            name=name,
            gpio=gpio,
            pin=pin,
            when=when,
            bits=bits,
            full_scale=(1 << bits) - 1,
            reference=reference,
            samples=spec.samples,
            read_limit_us=limit,
            spec=spec,
            citation=citation,
            aspects=cite_aspects(spec, index, report),
        )
    return channels


def _read_limit(spec: AdcSpec, report: Report) -> int | None:
    """Return the longest time of one mean in microseconds; None without one, or after a finding."""
    if spec.read_limit is None:
        return None
    limit = read_time(spec.read_limit, unit_named("us"), spec.at("read_limit"), report)
    if limit is not None and limit > _LONGEST_LIMIT_US:
        message = f"no mean takes {spec.read_limit}, so that nothing would be told of one that takes too long"
        report.add(BAD_ADC, spec.at("read_limit"), message, "2 ms, up to 1 s")
    return limit


def _when(
    name: str, spec: AdcSpec, written: ParametersSpec, parameters: Mapping[str, Parameter], report: Report
) -> tuple[Parameter, int] | None:
    """The parameter that decides whether a channel is read, with the steps at which it is; None without, or wrong."""
    if not spec.when:
        return None
    (switch, value), *more = spec.when.items()
    if more:
        report.add(
            BAD_ADC,
            spec.at("when"),
            f"when of {name} has one parameter, not {len(spec.when)}",
            hint=f"keep one of them: {{{switch}: {decimal(value)}}}",
        )
    parameter = find_parameter(switch, spec.at("when"), written, parameters, report)
    if parameter is None:
        return None
    steps = value / parameter.step
    accepted = parameter.choices or range(parameter.minimum, parameter.maximum + 1)
    if steps not in accepted:
        related = [(parameter.spec.place, f"{switch} is declared here")]
        message = f"{switch} is never {decimal(value)}, so {name} is never read"
        report.add(BAD_ADC, spec.at("when"), message, f"write a value that {switch} can have", related)
    elif not parameter.spec.reboot:
        report.add(BAD_ADC, spec.at("when"), unsaid_start(parameter), said_start(parameter))
    return parameter, int(steps)


def _report_no_converter(board: BoardSpec, model: BoardModel | None, report: Report) -> None:
    for name, spec in board.adc.items():
        message = f"{model.name} has no converter for {name}" if model else f"the pin of {name} is on no known board"
        report.add(BAD_ADC, spec.place, message, None if model else "say which board it is, such as board: pico_2_w")


def _gpio(
    name: str, spec: AdcSpec, pin: Parameter | None, model: BoardModel, inputs: frozenset[int], report: Report
) -> int | None:
    """The GPIO of a channel, one of ``inputs``, at first; None where it is wrong, or the parameter that has it is."""
    if spec.gpio is not None:
        if spec.gpio in inputs:
            return spec.gpio
        message = f"gpio of {name} is {spec.gpio}, not {shown_pins(inputs)}"
        if spec.gpio in model.taken:
            message += f": the {model.name} needs it for {model.taken[spec.gpio]}"
        report.add(BAD_ADC, spec.at("gpio"), message, hint="take a GPIO of these")
        return None
    if pin is None:
        return None
    accepted = pin.choices or range(pin.minimum, pin.maximum + 1)
    if pin.step != 1 or not inputs.issuperset(accepted):
        message = f"{pin.name} takes other numbers than those of inputs of the {model.name}, {shown_pins(inputs)}"
        related = [(pin.spec.at("max"), f"{pin.name} is declared here")]
        report.add(
            BAD_ADC,
            spec.at("pin"),
            message,
            related=related,
            hint=f"narrow min and max of {pin.name}, or give it values, one for each pin",
        )
        return None
    if pin.unit is not NUMBER:
        message = f"{pin.name} is in {pin.unit.name}, and a pin is a number without a unit"
        report.add(BAD_ADC, spec.at("pin"), message, f"take unit: {pin.unit.name} out at {pin.name}")
    elif not pin.spec.reboot:
        report.add(BAD_ADC, spec.at("pin"), unsaid_start(pin), said_start(pin))
    return pin.default


def find_parameter(
    name: str, place: Place, written: ParametersSpec, parameters: Mapping[str, Parameter], report: Report
) -> Parameter | None:
    """The parameter called so; one that is written but broken has been reported already."""
    parameter = parameters.get(name)
    if parameter is None and f"parameters.{name}" not in written.places:
        report.add(UNKNOWN_PARAMETER, place, f"there is no parameter {name}", did_you_mean(name, parameters))
    return parameter


def resolve_parameters(
    spec: ParametersSpec, families: ParameterFamilies, index: Mapping[str, Requirement], report: Report
) -> dict[str, Parameter]:
    """The parameters by name, those of families for each instance."""
    parameters: dict[str, Parameter] = {}
    for name, written in spec.parameters.items():
        citation = cite_optional(written.requirement, written.at("requirement"), index, report)
        for member in families.members(name, written):
            parameter = _resolve_parameter(member, citation, report)
            if parameter is None and member.instance == 0:
                break  # the other members would give the same findings
            if parameter is None:
                continue
            if member.name in parameters or (member.instance and member.name in spec.parameters):
                message = f"{member.name} is also the name of {name} for another instance"
                report.add(BAD_PARAMETER, written.place, message, hint="choose another name")
            check_carried(member, report)
            parameters[member.name] = parameter
    families.check_defaults()
    _check_earlier_names(parameters, report)
    return parameters


def _check_earlier_names(parameters: Mapping[str, Parameter], report: Report) -> None:
    """Findings for earlier names of parameters that are names of today, or of two of them, or none at all."""
    owners: dict[str, str] = {}
    for name, parameter in parameters.items():
        for old, factor in parameter.spec.was.items():
            owner = owners.setdefault(old, name)
            problem, hint = None, "leave it out"
            if not _NAME.fullmatch(old):
                problem, hint = f"{old} is not a parameter name", _NAMES
            elif old in parameters:
                problem = f"{old} is a parameter of today"
            elif owner != name:
                problem, hint = f"{old} is also what {owner} was called", f"leave it out here, or at {owner}"
            elif factor == 0:
                problem, hint = (
                    f"{name} is not 0 times what {old} was",
                    f"was: {{{old}: 1}}, if a number means the same",
                )
            elif not _LEAST_FACTOR <= abs(factor) <= 1 / _LEAST_FACTOR:
                problem = (
                    f"of what {old} was, {name} would take over 0 alone: no unit is {float(abs(factor)):.3g} of another"
                )
                hint = f"was: {{{old}: 1}}, if a number means the same"
            if problem is not None and parameter.instance == 0:
                report.add(BAD_PARAMETER, parameter.spec.at(f"was.{old}"), problem, hint)


def _resolve_parameter(member: Member, citation: Citation | None, report: Report) -> Parameter | None:
    name, spec = member.name, member.spec
    problems: list[_Fault] = []
    if not _NAME.fullmatch(name):
        length = f": it has {len(name)} characters, and 16 are the most" if len(name) > 16 else ""
        problems.append(("", f"{name} is not a parameter name{length}", _NAMES))
    if spec.step <= 0:
        problems.append(("step", f"the step of {name} is not above 0", "step: 1, or smaller"))
    else:
        for key in ("default", "min", "max"):
            steps = getattr(spec, key) / spec.step
            if steps.denominator != 1:
                near = decimal(round(steps) * spec.step)
                problems.append(
                    (key, f"{key} of {name} is not a whole number of steps", f"{key}: {near}, or a finer step")
                )
            elif abs(steps) > SMALL_INT_MAX:
                message = f"{key} of {name} is {steps} steps, more than a small integer holds"
                problems.append((key, message, "write a coarser step, or narrower limits"))
    if spec.min > spec.max:
        problems.append(("max", f"max of {name} is below its min", "swap them"))
    elif not spec.min <= spec.default <= spec.max:
        near = decimal(min(max(spec.default, spec.min), spec.max))
        problems.append(
            ("default", f"default of {name} is not between its min and max", f"default: {near}, or other limits")
        )
    problems += _type_problems(name, spec)
    choices = _choices(name, spec, problems)
    for key, message, hint in problems:
        report.add(BAD_PARAMETER, member.at(key), message, hint)
    unit = find_unit(spec.unit, spec.at("unit"), report)
    if problems or unit is None:
        return None
    return Parameter(
        name=name,
        unit=unit,
        step=spec.step,
        default=_in_steps(spec.default, spec.step),
        minimum=_in_steps(spec.min, spec.step),
        maximum=_in_steps(spec.max, spec.step),
        choices={_in_steps(value, spec.step): meaning for value, meaning in choices.items()},
        spec=spec,
        citation=citation,
        component=member.component,
        instance=member.instance,
        siblings=member.siblings,
    )


def _type_problems(name: str, spec: ParameterSpec) -> list[_Fault]:
    """Return what a whole type does not carry of the values, by the key that says so."""
    if spec.type is ParameterType.REAL32:
        return []
    if spec.step.denominator != 1:
        return [("type", f"{name} has a step of {decimal(spec.step)}, which {spec.type} does not carry", _REAL)]
    bits = int(spec.type.lstrip("uint"))
    low, high = (0, 2**bits - 1) if spec.type.startswith("u") else (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1)
    if spec.min < low or spec.max > high:
        return [("type", f"{name} has values that {spec.type} does not carry: it is {low} to {high}", _REAL)]
    return []


def _choices(name: str, spec: ParameterSpec, problems: list[_Fault]) -> dict[Fraction, str]:
    choices: dict[Fraction, str] = {}
    for written, meaning in spec.values.items():
        value = exact_number(written)
        if value is None:
            problems.append((f"values.{written}", f"{written!r} is not a number", "values: {0: what it means}"))
            continue
        if not spec.min <= value <= spec.max or spec.step <= 0 or (value / spec.step).denominator != 1:
            problems.append((f"values.{written}", f"{written} is not a value that {name} can have", _VALUE))
        if value in choices:
            message = f"{written} of {name} means {choices[value]!r} already, and nobody could tell which it is"
            problems.append((f"values.{written}", message, "keep one of them"))
        choices[value] = meaning
    if choices and spec.default not in choices:
        problems.append(
            ("default", f"default of {name} is none of its values", f"one of {', '.join(map(decimal, choices))}")
        )
    return choices


def _in_steps(value: Fraction, step: Fraction) -> int:
    return int(value / step)
