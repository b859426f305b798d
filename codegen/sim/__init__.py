"""The simulation: the generated firmware on this host, against a scenario, and the record of what it did."""
