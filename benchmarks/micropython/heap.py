# ruff: noqa: T201  what is printed is the answer
"""Prints the heap that modules take once they are imported, and the modules that came with them.

Arguments: names of modules to import.
"""

import gc
import json
import sys

names = sys.argv[1:]
before = set(sys.modules)
gc.collect()
gc.collect()
start = gc.mem_alloc()
for name in names:
    __import__(name)
gc.collect()
taken = gc.mem_alloc() - start
print(json.dumps({"heap": taken, "modules": sorted(set(sys.modules) - before)}))
