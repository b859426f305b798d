"""The scenarios of the simulation as plain numbers."""
