"""Meanings of single values of fields: of elements that nothing fills, numbered fields, entries by short names."""
