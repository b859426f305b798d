"""The checker of claims finds what is said in many ways, of any message, and leaves alone what is right or no claim."""

import claims_phrasings
import pytest

LEAST = 0.7
"""The share of each kind that is found at least; the benchmark tells the share of today."""


@pytest.mark.parametrize("kind", claims_phrasings.MAKERS)
def test_a_kind_of_claim_is_found_however_it_is_said(kind: str) -> None:
    twins = list(claims_phrasings.twins(kind, each=1, seed=1))
    missed = [each.wrong for each in twins if not claims_phrasings.findings(each.wrong)]
    assert len(missed) <= (1 - LEAST) * len(twins), missed
    assert [(each.right, found) for each in twins for found in claims_phrasings.findings(each.right)] == []


@pytest.mark.parametrize("kind", claims_phrasings.phrasings(claims_phrasings.ASIDES))
def test_what_is_no_claim_is_left_alone(kind: str) -> None:
    texts = [each.wrong for each in claims_phrasings.twins(kind, each=1, seed=1, path=claims_phrasings.ASIDES)]
    assert [(text, found) for text in texts for found in claims_phrasings.findings(text)] == []


def test_right_and_wrong_differ() -> None:
    for kind in claims_phrasings.MAKERS:
        assert all(each.right != each.wrong for each in claims_phrasings.twins(kind, each=2, seed=2))
