"""The documents of the corpus: nothing is found wrongly but what is known, and no less than was found once."""

import claims_score
import pytest
import yaml

FOUND = {
    "seen-1": 47,
    "seen-2": 160,
    "seen-3": 86,
    "seen-4": 47,
    "seen-5": 66,
    "seen-6": 55,
    "seen-7": 32,
    "seen-8": 27,
}
WRONG = {"seen-6": 1, "seen-7": 8, "seen-8": 3}
SURE = {"seen-1": 36, "seen-2": 122, "seen-3": 51, "seen-4": 33, "seen-5": 59, "seen-6": 37, "seen-7": 19, "seen-8": 18}


@pytest.mark.parametrize("folder", FOUND)
def test_findings_are_right_and_most_faults_are_found(folder: str) -> None:
    """A false finding costs the reader's trust; a fault that was found stays found."""
    score = claims_score.score([folder])
    assert score.wrong <= WRONG.get(folder, 0), "benchmarks/claims_score.py --wrong " + folder
    assert score.found >= FOUND[folder]


def test_half_of_the_documents_are_right() -> None:
    """A checker that finds fault with everything, or with nothing, has no score to show."""
    for folder in ("seen-1", "seen-2", "seen-3"):
        entries = yaml.safe_load((claims_score.CORPUS / folder / "labels.yaml").read_text())
        wrong = sum(bool(entry["faults"]) for entry in entries)
        assert abs(2 * wrong - len(entries)) <= len(entries) / 3


@pytest.mark.parametrize("folder", SURE)
def test_what_is_certain_is_right(folder: str) -> None:
    """An error fails a gate: it has to be right, and what was certain and right once stays so."""
    score = claims_score.score([folder])
    assert score.sure_and_right == score.sure, "benchmarks/claims_score.py --wrong " + folder
    assert score.sure >= SURE[folder]
