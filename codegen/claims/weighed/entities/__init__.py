"""Statements about what else a dialect names: messages, entries, parameters, and fields that no name is given for."""
