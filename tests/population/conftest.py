"""Lets the tests import the proof, which benchmarks/conformance.py runs as a whole, and the oracle that it shares."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "benchmarks"), str(ROOT / "tests" / "codec")]
