"""Views of the state's modules: its components, and the words that they are views of."""
