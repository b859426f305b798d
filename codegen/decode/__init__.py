"""Decode: trees into the records of the model, every value with its place; what is wrong becomes a finding."""
