"""The whole story of one thing that is specified, as text for a terminal."""
