"""Reads statements of documents about the fields of a message into a population table, and compares both."""
