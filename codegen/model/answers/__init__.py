"""The results of answers of tables: accounts for the stages, and the numbers that are sent."""
