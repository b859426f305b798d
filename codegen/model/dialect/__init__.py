"""A dialect: its messages, fields and enums, and how they go over the wire."""
