"""Feeds the watchdog of an interrupted program, which a soft reset does not stop."""

import gc
import sys


def hold():
    """Let the program that is there keep its watchdog from resetting the board, and forget its modules again."""
    known = list(sys.modules)
    try:
        import watchdog

        watchdog.hold()
    except Exception:  # noqa: S110  there is no such program, or half of one, and then nothing has started a watchdog
        pass
    for name in list(sys.modules):
        if name not in known:
            del sys.modules[name]


hold()
gc.collect()
