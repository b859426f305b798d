"""Cases about amounts: devices, curves, sums and trends, each with exact numbers that nothing of the firmware made."""
