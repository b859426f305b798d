"""Load: files into trees in which everything has a line and a column; no other stage opens a file."""
