# Generated from templates/codec/frames.py: do not edit.
# Inputs: ccf575346c60dfb2
"""Making and reading frames, in the fastest form that this interpreter runs.

CPython has no module `micropython` (ImportError) or a mock of it (AttributeError), a port without native code cannot
compile viper (SyntaxError) and refuses a compiled frames_viper.mpy (ValueError): they take the plain form.
"""
# ruff: noqa: F401  this is where they are imported from

try:
    from frames_viper import address, decoder, encoder, taker
except (AttributeError, ImportError, SyntaxError, ValueError):
    from frames_plain import address, decoder, encoder, taker
