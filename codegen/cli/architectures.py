"""The boards that ``--mpy`` compiles for."""

ARCHITECTURES = ("bytecode", "armv6m", "armv7m", "armv7emsp", "armv7emdp", "xtensawin", "rv32imc", "x64")
"""Names of mpy-cross, and "bytecode" for every board. An RP2040 takes armv6m, an RP2350 that or armv7emsp."""
