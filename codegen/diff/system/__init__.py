"""Changes between two versions of a specification: what the vehicle sends, keeps and does."""
