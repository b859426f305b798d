"""The board of a project: its pins, and the links and sensors that are connected to them."""
