"""Lets the tests import the fuzzer, which `make fuzz` runs with thousands of inputs."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))
