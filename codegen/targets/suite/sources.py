"""The generated tests of the sensors: facts of the specification in one module, and checks that read them."""

import re
from collections.abc import Iterator
from fractions import Fraction
from functools import cache

from codegen.frozen import dataclass
from codegen.model.answers.scaling import rounded
from codegen.model.code.storage import Storage
from codegen.model.quantities.source_kind import Source
from codegen.model.sensor_turns import Turns, turns_of
from codegen.model.spec.population import Rounding
from codegen.model.spec.source import SourceSpec
from codegen.model.system import System
from codegen.render.rendered import rendered
from codegen.targets.firmware.readings.sources import GivenView, given_by
from codegen.targets.firmware.words import word_layout
from codegen.targets.origin import copied_files, headed, origin_of, specification_file
from codegen.targets.source_files import source_files
from codegen.targets.suite.making import call_literal
from codegen.tool.template_files import copied

_FOLDER = "tests/sources"
_DRIVERS = "tests/drivers"

Pair = tuple[int | None, int | None]


@dataclass(frozen=True, slots=True)
class QuantityFacts:
    """A quantity that a sensor gives: ``pairs`` of what its driver hands over and of what is kept, None is unknown.

    ``place`` is where the driver has it, in so many ``halves`` of 16 bits, or in one number where these are 0.
    """

    path: str
    component: str
    instance: int
    attribute: str
    place: int
    halves: int
    initial: int | None
    invalid_after: int | None
    stale_after_ms: int | None
    plain: int
    pairs: tuple[Pair, ...]


@dataclass(frozen=True, slots=True)
class SourceFacts:
    """A sensor: how many ``values`` its driver has, and what the specification says of its turns.

    ``given`` has, for each number that read() of the user's code gives, the fewest and the most steps, and how many of
    them make one of its units, as numerator and denominator.

    ``made`` is the call that makes its driver, as literals, and ``period_us`` how often it is asked.

    ``mask`` is the place of the bits of what is new, which are ``new`` where all is, or None.
    """

    name: str
    made: str
    period_us: int
    listens: bool
    values: int
    mask: int | None
    new: int
    limit_us: int | None
    retry_ms: int
    cause: str
    given: tuple[tuple[int, int, int, int], ...]
    quantities: tuple[QuantityFacts, ...]
    criteria: dict[str, str]


@dataclass(frozen=True, slots=True)
class SourceSuiteView:
    """The module of facts: the sensors, and the turns that they have."""

    turns: Turns
    sources: tuple[SourceFacts, ...]


def render_source_suite(system: System) -> dict[str, str]:
    """The files below ``tests/`` that are about sensors; none without one."""
    if not system.polled:
        return {}
    files = {path.replace(_FOLDER, "tests"): text for path, text in copied_files(_FOLDER).items()}
    brought = source_files(system, "tests")
    files |= brought
    if any(path.endswith("_driver.py") for path in brought):
        files |= {path.replace(_DRIVERS, "tests"): text for path, text in copied_files(_DRIVERS).items()}
    program = system.program
    view = SourceSuiteView(
        turns_of(system, program.control_us if program else 1000),
        tuple(_facts(source, system) for source in system.polled),
    )
    paths = [specification_file(system, f"{name}.yaml") for name in ("board", "state")]
    text = rendered(f"{_FOLDER}/source_facts.py.j2", view)
    files["tests/source_facts.py"] = headed(text, origin_of(system, paths))
    return files


def source_checks(system: System) -> Iterator[tuple[str, str]]:
    """The tests of the sensors: the criterion that each shows, or nothing, and what the suite calls it."""
    for source in system.polled:
        for aspect, check in _checks():
            yield source.polling.cited(aspect), f"{source.name}-{check}"


@cache
def _checks() -> tuple[tuple[str, str], ...]:
    """Aspect and name of each check, which are the same for all sensors."""
    listed = copied(f"{_FOLDER}/sources_behaviour.py").partition("\nCHECKS = (\n")[2].partition("\n)\n")[0]
    found = re.findall(r'\("(\w+)", (\w+)\),', listed)
    return tuple((aspect, check) for aspect, check in found)


def _facts(source: Source, system: System) -> SourceFacts:
    polling = source.polling
    values = sum(output.storage.words for output in source.outputs) + (4 if source.sets_clock else 0)
    cited = {aspect: polling.cited(aspect) for aspect in SourceSpec.ASPECTS}
    return SourceFacts(
        name=source.name,
        made=call_literal(source.opened),
        period_us=polling.period_us,
        listens=source.silence_ms is not None,
        values=values + source.tells_new,
        mask=values if source.tells_new else None,
        new=(1 << len(source.outputs)) - 1,
        limit_us=polling.limit_us,
        retry_ms=polling.retry_ms,
        cause=source.cause,
        given=tuple(
            (output.low, output.high, steps.numerator, steps.denominator)
            for output, steps in zip(source.outputs, source.given_in, strict=False)
        ),
        quantities=tuple(_quantity(each, source) for each in given_by(source, system, word_layout(system), {})),
        criteria={aspect: criterion for aspect, criterion in cited.items() if criterion},
    )


def _quantity(given: GivenView, source: Source) -> QuantityFacts:
    quantity, output = given.quantity, given.output
    initial = quantity.initial
    assert not isinstance(initial, str)
    return QuantityFacts(
        path=quantity.path,
        component=quantity.component,
        instance=given.instance,
        attribute=quantity.attribute,
        place=given.place,
        halves=output.storage.halves,
        initial=None if initial is None else int(initial),
        invalid_after=quantity.trust.invalid_after,
        stale_after_ms=quantity.trust.stale_after_ms,
        plain=max(output.low, min(output.high, 1)),
        pairs=tuple(_pairs(given, source)),
    )


def _pairs(given: GivenView, source: Source) -> list[Pair]:
    """Ends, what lies beyond them, and where rounding turns; of a wide number many drivers look at the ends."""
    output, factor = given.output, given.factor
    low, high = output.low, output.high
    handed = {low, high, low + 1, high - 1, 0, 1, -1, (low + high) // 2}
    if factor.denominator > 1:
        half, many = factor.denominator // 2, 7 * factor.denominator
        handed |= {part * sign for part in (half, half + 1, half - 1, many + half) for sign in (1, -1)}
    is_small = output.storage is Storage.SMALL
    beyond = {low - 1, high + 1} if is_small or not source.keeps_limits else set()
    smallest, largest = output.storage.limits
    inside = sorted(value for value in handed if low <= value <= high)
    outside = sorted(value for value in beyond if smallest <= value <= largest)
    return [
        *((value, rounded(Fraction(value) * factor, Rounding.NEAREST)) for value in inside),
        *((value, None) for value in (*outside, None)),
        (inside[0], rounded(Fraction(inside[0]) * factor, Rounding.NEAREST)),
    ]
