"""A sensor that code of the user's reads."""
