"""An input of the board's analog to digital converter."""
