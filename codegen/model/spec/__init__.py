"""The specification as written: the records of its files, every value with its place."""
