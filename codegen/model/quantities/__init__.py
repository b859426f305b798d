"""Where the values of quantities come from, how far they reach, and how long they are believed."""
