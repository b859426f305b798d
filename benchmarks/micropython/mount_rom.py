"""Mounts the ROMFS beside it: what a board has in its flash, and here on the heap. Stands before another script."""

import sys

import vfs

with open("image.romfs", "rb") as file:
    vfs.mount(vfs.VfsRom(memoryview(file.read())), "/rom")
sys.path.append("/rom")
