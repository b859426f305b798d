"""Meanings of single values of fields: of elements that nothing fills, of numbered fields, of entries by short names."""
