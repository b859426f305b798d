"""The parts of generated code, in machine code and in plain Python alike."""
