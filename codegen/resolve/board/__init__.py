"""What is known of the board, and what is connected to it."""
