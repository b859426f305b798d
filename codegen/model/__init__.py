"""The types that the stages hand to one another: what is written, what it resolves to, units and codes."""
