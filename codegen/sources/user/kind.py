"""A class of the user's code whose ``read()`` returns a number, or several, in the units that board.yaml states."""

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.quantities.source_kind import Output, Polling, Source, SourceFact
from codegen.model.spec.described import described
from codegen.model.spec.driver import OutputSpec
from codegen.model.spec.source import SourceSpec
from codegen.pattern import pattern
from codegen.sources.class_calls import Use, check_use
from codegen.sources.declared import declared_output, in_tuple
from codegen.sources.kind import Around, KindOfSource, check_class
from codegen.sources.module_names import taken_by

_KEYS = ("unit", "stored", "min", "max")
_CLASS = pattern(r"[A-Za-z_]\w*(\.[A-Za-z_]\w*)+", re.ASCII)
_HARDWARE = ("machine", "umachine")
"""Modules of MicroPython of which no class is one that can be read without arguments."""
_USE = Use((), (), {"read": ()}, {})


@dataclass(frozen=True, slots=True, kw_only=True)
class UserSpec(SourceSpec):
    """A class of the user's code: read() returns a number, a tuple of them in the order of outputs, or None."""

    class_name: str = described("Module and class, such as sonar.Sonar; it is made without arguments.", key="class")
    unit: str | None = described("Unit of the one number that it gives, where it has no outputs.", default=None)
    stored: str | None = described("Unit of one step that this is rounded to. Default: unit.", default=None)
    min: Fraction | None = described("Smallest plausible value of it, in unit.", default=None)
    max: Fraction | None = described("Largest plausible value of it, in unit.", default=None)
    outputs: Mapping[str, OutputSpec] = described(
        "The numbers that it gives, by name, in the order of the tuple that read() returns.", default_factory=dict
    )


@dataclass(frozen=True, slots=True)
class User(Source):
    """``steps`` steps of an output make one of the units that the code gives it in."""

    polling: Polling
    outputs: tuple[Output, ...]
    class_name: str
    steps: tuple[Fraction, ...]

    @property
    def module(self) -> str:
        return "user_source"

    @property
    def modules(self) -> tuple[str, ...]:
        return ("user/firmware/user_source.py",)

    @property
    def imported(self) -> str:
        return self.class_name.rpartition(".")[0]

    @property
    def opened(self) -> str:
        module, _, name = self.class_name.rpartition(".")
        scales = in_tuple(f"({steps.numerator}, {steps.denominator})" for steps in self.steps)
        limits = in_tuple(f"({output.low}, {output.high})" for output in self.outputs)
        return f'UserSource("{module}", "{name}", {scales}, {limits})'

    @property
    def given_in(self) -> tuple[Fraction, ...]:
        return self.steps

    def declared(self, output: Output) -> OutputSpec:
        spec = self.polling.spec
        assert isinstance(spec, UserSpec)
        return spec.outputs.get(output.name) or _single(spec)

    @property
    def cause(self) -> str:
        return ""  # nobody knows what an OSError of it means

    def facts(self) -> Iterator[SourceFact]:
        yield SourceFact("class", self.class_name, "class")
        yield SourceFact("steps", ", ".join(map(str, self.steps)), "outputs", asks=False)

    def words(self) -> str:
        return f"read() of {self.class_name}"


def resolve_user(spec: UserSpec, polling: Polling, around: Around) -> User | None:
    """The class and what it gives; None after a finding."""
    if not _CLASS.fullmatch(spec.class_name):
        around.bad("class", f"{spec.class_name} is no class of a module", "write module and class: sonar.Sonar")
    else:
        module, _, name = spec.class_name.rpartition(".")
        owner = taken_by(module)
        if owner not in (None, "MicroPython"):  # which has drivers, too
            around.bad("class", f"{owner} has a module {module} already", f"rename yours: class: my_{spec.class_name}")
        if module in _HARDWARE:
            message = f"{spec.class_name} is hardware, which is not made without arguments, or has no read()"
            around.bad("class", message, "write a class of your own, whose __init__ makes it and whose read() asks it")
        own = around.whole.drivers.get(module)  # its module goes to the board, beside the firmware
        source = around.whole.user_modules.get(module) or (own.module if own else None)
        check_class(name, source, spec.at("class"), around)
        check_use(name, source, spec.at("class"), _USE, around)
    if spec.outputs:
        for key in _KEYS:
            if getattr(spec, key) is not None:
                around.bad(key, f"{key} is that of a single number, and there are outputs", "write it in outputs")
        found = [declared_output(name, each, around) for name, each in spec.outputs.items()]
    else:
        found = [declared_output("", _single(spec), around)]
    if around.failed or None in found:
        return None
    outputs = [each for each in found if each is not None]
    return User(polling, tuple(each for each, _ in outputs), spec.class_name, tuple(steps for _, steps in outputs))


def _single(spec: UserSpec) -> OutputSpec:
    """The one number that it gives without ``outputs``, as if it were one of them."""
    return OutputSpec(place=spec.place, places=spec.places, doc=spec.doc, **{key: getattr(spec, key) for key in _KEYS})


USER = KindOfSource("user", UserSpec, resolve_user, "10 Hz")
