"""The checks of behaviour.py, each in one run of each interpreter."""


def test_behaviour(behaviour):
    """The board and the state behave as the requirements say, and the steady cycle allocates nothing."""
    outcomes = behaviour("behaviour.py")
    assert outcomes
    assert [found for found in outcomes if found[1] is not None] == []
