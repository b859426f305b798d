"""Changes between two dialects, and what they mean to receivers of the other version."""
