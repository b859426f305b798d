"""The commands of the vehicle, and their parameters."""
