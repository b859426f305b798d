"""Statements that are true of no field of a message, whichever of them is meant.

Sentences often only describe what they are about: "roll, pitch and yaw are degrees", "the compass is in tesla". Where
the message is known, a unit that none of its fields has, though some measure the same, is wrong of any of them.
"""
