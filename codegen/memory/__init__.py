"""Estimates the heap that a program takes on a board, from counts of what its specification has.

``parts`` counts, what each part takes was measured (``costs``), and ``estimate`` puts both together.
"""
