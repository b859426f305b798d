# Generated from templates/tests/program/grouped.py: do not edit.
# Inputs: 4b5c571f57861cbb
"""Checks of the program in as few processes as can be: one for all, and a further one behind each that ends it."""

import json
import socket

from interpreters import heard, started

MOST_HANGING = 3  # further ones would only cost time


def outcomes(interpreter, asked, limit_s):
    """Return what each check finds by `script name`: None, or what went wrong. `asked` are pairs of these.

    A check in which the process ends is run alone. One that has not ended so many seconds after the one before it is
    left, and fails.
    """
    found, left, hanging = {}, [" ".join(each) for each in asked], 0
    while left:
        told, wrong, is_hanging = _run(interpreter, left, limit_s)
        found.update(told)
        left = [each for each in left if each not in told]
        if not left:
            assert wrong is None, wrong
            break
        ended, *left = left
        hanging += is_hanging
        found[ended] = wrong if is_hanging else _alone(interpreter, ended, limit_s)
        if hanging == MOST_HANGING:
            return {**dict.fromkeys(left, f"not run: {MOST_HANGING} others do not end"), **found}
    return found


def _alone(interpreter, name, limit_s):
    told, wrong, _ = _run(interpreter, [name], limit_s)
    return told.get(name, wrong)


def _run(interpreter, names, limit_s):
    """Return what checks found that one process runs, how it failed or None, and whether it had to be ended."""
    command, environment = started(interpreter, "checks_run.py", _free_port(), *names)
    output, said, code = heard(command, environment, limit_s)
    is_hanging = code is None
    wrong = code and f"{interpreter} ended with {code}: {said[-2000:]}"
    if is_hanging:
        wrong = f"does not end within {limit_s} s"
    lines = output.split("\n")[:-1]  # the last one is empty, or is not whole
    told = dict(map(json.loads, lines))
    if not wrong and told.keys() != set(names):
        wrong = f"{interpreter} ended early"
    return told, wrong or None, is_hanging


def _free_port():
    """Return the number of a UDP port that nobody has."""
    with socket.socket(type=socket.SOCK_DGRAM) as free:
        free.bind(("127.0.0.1", 0))
        return str(free.getsockname()[1])
