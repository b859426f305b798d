# Generated from templates/codec/frames.py: do not edit.
# Inputs: 8eb051efe569fe1c
"""Making and reading frames, in the fastest form that this interpreter runs.

CPython has no module `micropython` (ImportError) or a mock of it (AttributeError), a port without native code cannot
compile viper (SyntaxError) and refuses a compiled frames_viper.mpy (ValueError), a compiler of another release or port
may lack a part of viper (ViperTypeError, which is a TypeError, or NotImplementedError): they take the plain form.
"""
# ruff: noqa: F401  this is where they are imported from

try:
    from frames_viper import address, decoder, encoder, taker
except (AttributeError, ImportError, NotImplementedError, SyntaxError, TypeError, ValueError):
    from frames_plain import address, decoder, encoder, taker
