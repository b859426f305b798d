"""Settings of the whole suite."""

from hypothesis import settings

# No timed assertions: a busy machine is no fault of the code, and a failure must be the same for everybody.
settings.register_profile("codegen", deadline=None, derandomize=True, database=None)
settings.load_profile("codegen")
