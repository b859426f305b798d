"""What the answers of tables tell the stages, and the numbers that they send."""
