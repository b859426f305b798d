"""From what a document says about the fields of a message to a population table, and how both compare."""
