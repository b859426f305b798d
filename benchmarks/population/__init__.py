"""The proof of population: every field of a dialect answered from a quantity, sent, and compared with pymavlink."""
