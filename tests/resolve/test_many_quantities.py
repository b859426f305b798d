"""A specification with very many quantities is read in time: nothing looks at all of them for each of them."""

import cProfile
import pstats
from pathlib import Path

import pytest

from codegen.cli import main

COUNT = 400
QUANTITY = "      q{}: {{doc: x, unit: V, stored: mV, min: 0, max: 30, requirement: FR-1.3}}\n"


@pytest.mark.parametrize("command", ["check", "build"])
def test_work_grows_as_the_number_of_quantities(command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Calls are counted, which depend on no clock: from n quantities to 2 n as many more as from none to n."""
    assert main(["init", str(tmp_path / "p"), "--from", "minimal"]) == 0
    monkeypatch.chdir(tmp_path / "p")
    state = Path("specs", "state.yaml")
    text = state.read_text()

    def calls(count: int) -> int:
        state.write_text(text + "".join(map(QUANTITY.format, range(count))))
        profile = cProfile.Profile()
        assert profile.runcall(main, [command]) == 0
        return int(pstats.Stats(profile).total_calls)  # type: ignore[attr-defined]

    calls(1)  # imports, and compiles templates
    few, some, many = (calls(number) for number in (1, COUNT, 2 * COUNT))
    assert (many - some) < 1.25 * (some - few)
