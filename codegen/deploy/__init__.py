"""A program goes to a board over its raw REPL: only what changed, and so that the next deploy repairs a cut one."""
