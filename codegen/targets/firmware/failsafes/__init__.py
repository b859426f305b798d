"""Views and statements of failsafes: their tables, texts and actions."""
