# Generated from templates/tests/test_behaviour.py: do not edit.
# Inputs: 0e07c7e18cec8be4
"""The checks of behaviour.py, each in one run of each interpreter."""


def test_behaviour(behaviour):
    """The board and the state behave as the requirements say, and the steady cycle allocates nothing."""
    outcomes = behaviour("behaviour.py")
    assert outcomes
    assert [found for found in outcomes if found[1] is not None] == []
