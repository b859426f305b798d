"""The tables of messages that are received."""
