"""The use cases, each a module: they read, decide and return; arguments and printing are the command line's."""
