"""Predicts how long a pass of the main loop takes on a board, and how much time that leaves to the user's code.

The due times follow from the specification (``jobs``, ``frames``), the cost of each part was measured (``costs``),
and ``budget`` puts both together.
"""
