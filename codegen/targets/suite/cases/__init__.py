"""Cases of the generated suite: what is set or arrives, and what must come of it."""
