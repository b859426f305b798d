# Generated from templates/firmware/reading_turns.py: do not edit.
# Inputs: 94f792ae12eac6c4
"""Further readings of a component, behind the first: a turn of each takes one reading of every part."""

import time

from guard import Guard
from micropython import const

_WAITING = const(-1000000000)  # the count of a part that the board is being asked about


def turns(state, read, parts, places, tell, follow):
    """Return what takes a turn when it is given the board.

    `read` is the function of the reading, `parts` are the words of each part, `places` where these have its count and
    its failures in a row. `tell(told, instance, error)` says what there is to say, and `follow()`, if there is one,
    takes over parameters before each turn. A turn never raises.
    """
    turn = _turns(state.words, read, parts, places, tell, follow)
    next(turn)
    return turn.send


def in_turn(first, second, restart):
    """Return what lets both take a turn when it is given the board; `restart` makes all anew after an interrupt."""
    both = _in_turn(first, second, restart)
    next(both)
    return both.send


def _in_turn(first, second, restart):
    try:
        board = yield
        while True:
            first(board)
            second(board)
            board = yield
    except (KeyboardInterrupt, SystemExit):
        restart()
        raise


def _turns(words, read, parts, places, tell, follow):
    """Go on for ever: what lives on between the calls keeps an exception without heap, and looks up no names."""
    ticks = time.ticks_ms
    first = 0
    board = yield
    while True:
        try:
            if follow and not first:
                follow()
            told = read(words, parts, board, ticks, first)
            if told:
                first = (told >> 4) + 1
                tell(told & 15, told >> 4, None)
            else:
                first = 0
                board = yield
        except Exception as error:
            first = failed(read, parts, places, tell, error, first)


def failed(read, parts, places, tell, error, first):
    """Count a failed reading of the part that the board was asked for; return which one is next."""
    count, failures = places
    for instance in range(first, len(parts)):
        words = parts[instance]
        if words[count] == _WAITING:
            words[count] = -1
            if words[failures] == 0:
                with Guard():  # a log that fails is no reason to stop
                    tell(0, instance, error)
            read(words, None, None, time.ticks_ms, -1)
            return instance + 1
    return len(parts)
