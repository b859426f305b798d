"""Settings of the whole suite."""

import signal

from hypothesis import settings

# No timed assertions: a busy machine is no fault of the code, and a failure must be the same for everybody.
settings.register_profile("codegen", deadline=None, derandomize=True, database=None)
settings.load_profile("codegen")

# What a shell runs in the background ignores Ctrl-C, and so would every program that a test starts and interrupts.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
