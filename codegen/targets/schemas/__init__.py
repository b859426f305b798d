"""The JSON Schemas of the specification files, and the page about their keys."""
