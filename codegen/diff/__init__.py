"""Changes between two resolved models, and their consequences: see ``change``."""
