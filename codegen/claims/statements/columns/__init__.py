"""Columns of tables: the rows with their messages and fields, and the sizes of fields."""
