"""Traceability: from a requirement's criteria over the rows of the specification to symbols and tests, and back."""
