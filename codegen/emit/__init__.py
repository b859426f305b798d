"""Emit: compare what was rendered with the output folder, then write what changed and nothing else."""
