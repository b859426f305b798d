"""Statements about what a number is told from: which way it counts, from which level, from where, of what.

A field's description says one of two that exclude each other, "positive down" or "up is positive", "above MSL" or
"above home". ``words`` finds them in a text; ``stated`` compares what a document says with the description.
"""
