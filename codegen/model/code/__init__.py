"""What generated code is made of, in machine code and in plain Python alike."""
