"""What no stored project shows of single functions of the targets: limits that are met exactly, two pages, no enum."""

from fractions import Fraction
from types import SimpleNamespace
from typing import Any, cast

import pytest

from codegen.model.dialect.dialect import EnumDefinition, EnumEntry
from codegen.model.units.unit import unit_named
from codegen.source import Place
from codegen.targets.codec.enums import WIDTH, enums_text
from codegen.targets.firmware.messages import sending
from codegen.targets.firmware.program import main_loop
from codegen.targets.firmware.readings import measured_view
from codegen.targets.receiver import view
from codegen.targets.suite.amounts import minute
from codegen.targets.suite.amounts.minute import Phase
from codegen.targets.suite.cases import receptions
from codegen.targets.suite.facts import calm_inputs


@pytest.mark.parametrize(
    ("pages", "takes_page", "suffix"),
    [(1, False, "_page"), (2, True, "_2_pages"), (3, True, "_3_pages")],
)
def test_two_pages_are_several(pages: int, takes_page: bool, suffix: str) -> None:
    message: Any = SimpleNamespace(
        component=None, withheld_for=(), instances=1, pages=pages, population=SimpleNamespace(pages="all")
    )
    way = sending._way(message, [], [])
    assert (way.pages, way.instances, way.suffix) == (takes_page, False, suffix)
    assert ("range(" in way.sending) is takes_page


@pytest.mark.parametrize("instances", [1, 2, 3])
def test_two_instances_are_several(instances: int) -> None:
    message: Any = SimpleNamespace(
        component=SimpleNamespace(name="pump"),
        withheld_for=("depth",),
        instances=instances,
        pages=1,
        population=SimpleNamespace(pages=None),
    )
    way = sending._way(message, ["instance"], [])
    assert way.instances is (instances > 1)
    assert way.suffix == "_pump_while_known"
    assert (f"in range({instances}):" in way.sending) is (instances > 1)


def _calm(*, minimum: int, maximum: int, above: tuple[int, ...] | None, rests: Any) -> int:
    threshold = None if above is None else SimpleNamespace(above=above)
    quantity = SimpleNamespace(
        name="depth",
        component="pump",
        minimum=minimum,
        maximum=maximum,
        derivation=SimpleNamespace(threshold=threshold),
    )
    channel = SimpleNamespace(full_scale=320)
    conversion = SimpleNamespace(channel=channel, stored=lambda count: count)
    condition = SimpleNamespace(quantity=quantity, rests_at=rests)
    failsafe = SimpleNamespace(conditions=[condition], to_arm=[])
    system: Any = SimpleNamespace(program=SimpleNamespace(failsafes=[failsafe]))
    reading: Any = SimpleNamespace(conversion=conversion, quantity=quantity)
    return calm_inputs._calm_count(reading, [], system)


def test_limits_of_a_quantity_and_its_threshold_are_calm() -> None:
    """Counts are tried in the order 0, 200, 210 ... 310, 190 ... 10: what is a limit is within, and not above."""
    assert _calm(minimum=0, maximum=320, above=None, rests=lambda _: True) == 0
    assert _calm(minimum=1, maximum=320, above=None, rests=lambda _: True) == 200
    assert _calm(minimum=1, maximum=200, above=None, rests=lambda _: True) == 200
    assert _calm(minimum=200, maximum=200, above=None, rests=lambda _: True) == 200
    assert _calm(minimum=1, maximum=199, above=None, rests=lambda _: True) == 190
    assert _calm(minimum=1, maximum=320, above=(250, 200), rests=lambda _: True) == 200
    assert _calm(minimum=1, maximum=320, above=(250, 199), rests=lambda _: True) == 190
    assert _calm(minimum=1, maximum=320, above=None, rests=lambda value: value > 300) == 310
    assert _calm(minimum=1, maximum=320, above=None, rests=lambda value: value == 10) == 10
    assert _calm(minimum=1, maximum=320, above=None, rests=lambda _: False) == 0


def test_the_sum_at_the_end_of_each_phase(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(minute, "added", lambda phase, *_: Fraction(phase.of))
    phases = (Phase(1, 100, 7, 0), Phase(1, 100, -9, 0), Phase(1, 100, 1, 0))
    nothing: Any = None
    assert minute._totals(phases, nothing, nothing, None) == [7, -2, -1]
    assert minute.most_of(phases, nothing, nothing, None) == 7


def _enum(name: str, *entries: tuple[str, int, str], is_bitmask: bool = False) -> EnumDefinition:
    place = Place("boat.xml", 1, 1)
    made = tuple(EnumEntry(*each, place) for each in entries)
    return cast("EnumDefinition", SimpleNamespace(name=name, is_bitmask=is_bitmask, entries=made))


def test_a_module_of_enums() -> None:
    """It says so where there are none; a name that is taken with another value is a comment."""
    assert "# The fields of these messages refer to none." in enums_text([])
    text = enums_text(
        [_enum("SAIL", ("UP", 1, "Set."), ("None", 2, "")), _enum("ANCHOR", ("UP", 3, ""), ("IN", 4, ""))]
    )
    assert "# The fields of these messages refer to none." not in text
    assert "# SAIL\nUP = 1  # Set.\nNone_ = 2\n\n# ANCHOR\n# UP = 3\nIN = 4" in text
    assert "# FLAGS: bits, to be combined\n" in enums_text([_enum("FLAGS", ("A", 1, ""), is_bitmask=True)])


def test_comments_of_enums_end_with_the_line() -> None:
    room = WIDTH - len("UP = 1") - 3
    fits, too_long = "x" * (room - 2) + " y", "x" * (room - 3) + " yz"
    assert f"UP = 1  # {fits[:-2]}" in enums_text([_enum("SAIL", ("UP", 1, fits))])
    assert f"# {fits}\n" in enums_text([_enum("SAIL", ("UP", 1, fits))]) + "\n"
    assert "# {} ...".format("x" * (room - 3)) in enums_text([_enum("SAIL", ("UP", 1, too_long + "z"))])


@pytest.mark.parametrize(
    ("most", "bits", "number"),
    [(127, 0x7F, 127), (127, 0x80, -128), (127, -1, -1), (127, 0x101, 1), (255, 0x80, 128), (255, -1, 255)],
)
def test_bits_of_a_signed_field(most: int, bits: int, number: int) -> None:
    """All bits count that the field has, and no others."""
    field: Any = SimpleNamespace(type=SimpleNamespace(size=1, maximum=most))
    assert receptions._signed(field, bits) == number


@pytest.mark.parametrize(("name", "rank"), [("SAIL_2", 0), ("SAIL", 2), ("KEEL", 1)])
def test_new_generations_are_preferred_and_old_ones_last(name: str, rank: int) -> None:
    """One of no generation stands between both; of those that are alike the higher id goes first."""
    generations = [SimpleNamespace(new=("SAIL_2",), old=("SAIL",)), SimpleNamespace(new=("MAST_2",), old=("MAST",))]
    system: Any = SimpleNamespace(generations=generations)
    message: Any = SimpleNamespace(name=name, wire=SimpleNamespace(id=7))
    assert view._preference(message, system) == (rank, -7)


@pytest.mark.parametrize(
    ("arming", "has_load", "words"),
    [("", False, {"ready", "load_dpct"}), (None, True, {"load_dpct"}), (None, False, set())],
)
def test_words_that_the_main_loop_sets(
    monkeypatch: pytest.MonkeyPatch, arming: str | None, has_load: bool, words: set[str]
) -> None:
    """Who can arm asks for the load, whether or not it is sent."""
    monkeypatch.setattr(main_loop, "_has_load", lambda _: has_load)
    system: Any = None
    program: Any = SimpleNamespace(spec=SimpleNamespace(arming=arming))
    assert main_loop.own_words(system, program) == words


@pytest.mark.parametrize(
    ("unit", "offset", "formula"),
    [
        ("V", None, "adc / 4095 * 3.3 * 2.5"),
        ("mV", None, "adc / 4095 * 3.3 * 2500"),
        ("V", Fraction(1, 4), "(adc / 4095 * 3.3 - 0.25) * 2.5"),
    ],
)
def test_the_formula_of_a_reading_with_fixed_numbers(unit: str, offset: Fraction | None, formula: str) -> None:
    volt = unit_named("V")
    conversion = SimpleNamespace(
        channel=SimpleNamespace(full_scale=4095, reference=Fraction(33, 10)),
        multiplier=SimpleNamespace(unit=SimpleNamespace(scale=Fraction(1)), value=Fraction(5, 2)),
        offset=None if offset is None else SimpleNamespace(unit=volt, value=offset),
    )
    reading: Any = SimpleNamespace(quantity=SimpleNamespace(unit=unit_named(unit)), conversion=conversion)
    assert measured_view._formula(reading) == (formula, "adc")
