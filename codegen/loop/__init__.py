"""How long a pass of the main loop takes on a board, and what that leaves to the user's code: a prediction.

What is due when follows from the specification (``jobs``, ``frames``), what each part of it costs was measured
(``costs``), and ``budget`` puts both together.
"""
