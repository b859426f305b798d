"""Units of fields in documents: those of the dialect, factors between units, and two units beside each other."""
