"""A message that sets quantities takes at most three times what it takes to parse it."""

import shutil
from collections.abc import Mapping

import cost
import pytest

MOST = 3


@pytest.fixture(scope="module")
def counted(tmp_path_factory: pytest.TempPathFactory) -> Mapping[str, float]:
    """The instructions of each workload, without those of the loop around it; each said that the message was taken."""
    if shutil.which("valgrind") and cost.problem():
        pytest.skip(cost.problem())
    folder = tmp_path_factory.mktemp("cost")
    costs, said = cost.instructions("cost_received.py", 0, cost.modules_of("received", folder), folder)
    assert set(said.values()) == {1}
    assert len(said) == len(costs) - 1 == 9
    return {name: value - costs["nothing"] for name, value in costs.items()}


@pytest.mark.parametrize("message", ["stick", "fix"])
def test_taking_a_message_takes_at_most_three_times_what_parsing_takes(
    counted: Mapping[str, float], message: str
) -> None:
    """From the bytes of a frame to the words of the state: MANUAL_CONTROL into three, GPS_INPUT into eight."""
    parsed, taken = counted[f"{message}_parsed"], counted[f"{message}_taken"]
    assert 1000 < parsed < taken <= MOST * parsed


def test_a_further_table_for_a_message_takes_less_than_parsing_it(counted: Mapping[str, float]) -> None:
    """Of which the conditions are not met."""
    assert 0 < counted["both_taken"] - counted["fix_taken"] < counted["fix_parsed"]
