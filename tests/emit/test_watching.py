"""A connection looks for who uses the same ids: where messages have the chip, and which numbers are the board's own."""

from types import SimpleNamespace
from typing import Any

import pytest

from codegen.targets.firmware.program import watching as module
from codegen.targets.firmware.program.watching import watched, watching


def message(name: str, *, is_chip: bool = True, component: Any = None) -> Any:
    covers = SimpleNamespace(offset=7, count=8)
    answers = (SimpleNamespace(is_chip_number=False), SimpleNamespace(is_chip_number=is_chip, covers=covers))
    return SimpleNamespace(wire=SimpleNamespace(name=name, id=len(name)), answers=answers, component=component)


def lines(*messages: Any, parameter: str | None = "COMPID", program: Any = True, cited: str | None = None) -> list[str]:
    named = None if parameter is None else SimpleNamespace(name=parameter)
    system: Any = SimpleNamespace(program=program or None, component_parameter=named, messages=messages)
    aspects = {} if cited is None else {"services": {"twins": cited}}
    told: Any = SimpleNamespace(aspects=aspects)
    return list(watching(system, told))


FIRST = SimpleNamespace(name="BATT_ID")
PACK = SimpleNamespace(name="battery", first_number=FIRST, instances=2)
FIXED = SimpleNamespace(name="motor", first_number=None, instances=2)


@pytest.fixture(autouse=True)
def numbers(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where a message has the number of its instance."""
    monkeypatch.setattr(module, "number_at", lambda message: 3 if message.component else -1)


def test_the_numbers_of_a_component_follow_its_parameter() -> None:
    first = "self.parameters.batt_id"
    assert lines(message("ABC", component=FIXED), message("ABCD", component=PACK)) == [
        "watch_twins(",
        "    connection,",
        "    self.texts,",
        '    "COMPID",',
        "    ((3, 7, 8, 3), (4, 7, 8, 3)),",
        '    "BATT_ID",',
        f"    range({first}, {first} + 2),",
        ")",
    ]


def test_fixed_numbers_are_not_asked_for() -> None:
    """Nor is anything of a message without a component, or without the chip."""
    told = " ".join(lines(message("ABC", component=FIXED), message("AB"), message("A", is_chip=False)))
    assert "range" not in told
    assert "(3, 7, 8, 3), (2, 7, 8, -1)" in told
    assert "(1," not in told


def test_nobody_looks_where_nobody_can_change_an_id() -> None:
    assert lines(message("ABC"), parameter=None) == []
    system: Any = SimpleNamespace(program=None, component_parameter=FIRST, messages=(message("ABC"),))
    assert watched(system) == ()


def test_what_asks_for_it_is_cited() -> None:
    assert lines(message("ABC"), cited="FR-1.2")[0] == "# Who uses the same ids is told (FR-1.2)."
    assert not any(line.startswith("#") for line in lines(message("ABC")))
