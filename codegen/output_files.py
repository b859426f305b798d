"""What codegen keeps of its own in an output folder."""

MANIFEST = "manifest.json"
"""The file that says which others codegen wrote there."""

OWN_FOLDER = ".codegen"
"""The folder that git and the comparison with what is generated leave out."""
