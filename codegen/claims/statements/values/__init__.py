"""What single values of fields mean: of elements that nothing fills, of numbered fields, of entries by short names."""
