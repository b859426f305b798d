"""Pulses at a digital input."""
