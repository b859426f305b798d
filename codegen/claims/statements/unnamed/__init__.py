"""Statements about fields without their names, by everyday words for them."""
