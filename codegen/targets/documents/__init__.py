"""The review documents: the resolved system as tables that are committed."""
