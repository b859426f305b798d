"""What is written: the records of the specification's files, every value with its place."""
