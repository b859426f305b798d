"""Whether what changed still is what it was, and how bad it is where it is not."""
