"""Claims of a project's documents about the project itself: parameters, rates, the converter, worked examples.

These claims follow from the specification; all others follow from the dialect, which changes far less often.
"""
