"""Render: views and templates to text, in memory."""
