"""Statements about fields without their names: by words for them, or by their elements."""
