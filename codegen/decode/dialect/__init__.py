"""The XML of a dialect and of all that it includes, as definitions."""
