"""What changed between two resolved models, and what that means: see ``change``."""
