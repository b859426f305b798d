"""The tables of messages that are sent."""
