"""Where the project file lies, seen from the folder of a project."""

PROJECT_FILES = ("specs/codegen.yaml", "codegen.yaml")
"""Its paths; the first that exists is meant."""
