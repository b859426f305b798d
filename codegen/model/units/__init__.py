"""Units, and the exact maps between them."""
