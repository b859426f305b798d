"""A tree: anything that knows contents by path, such as a revision of a git repository, or an archive."""

from typing import Protocol


class Tree(Protocol):
    """Files by their path below the tree, with ``/`` between the parts."""

    @property
    def folder(self) -> str | None:
        """The absolute path of the folder of the disk that the tree is a version of, if it is one."""

    @property
    def version(self) -> str:
        """Return what tells its files from those of any other tree, such as a commit's hash; empty without that."""

    def holds(self, path: str) -> bool:
        """Return whether there is such a file."""

    def read(self, path: str) -> bytes | None:
        """Return the content of a file, or None where there is none."""

    def names(self, folder: str) -> tuple[str, ...] | None:
        """Return the names in a folder (``""`` is the tree itself), sorted, or None where there is none."""
