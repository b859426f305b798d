"""A revision of a git repository as a tree: its files are read as blobs, and nothing is checked out."""

import os
import posixpath
import subprocess
from collections.abc import Iterator
from contextlib import ExitStack
from dataclasses import dataclass, field
from types import TracebackType
from typing import Self

from codegen.load.git import GitFault, git_environment, git_says

_SYMLINK = "120000"
_SUBMODULE = "160000"
_MOST_LINKS = 8


@dataclass(slots=True)
class GitTree:
    """The files of one commit, with those of its submodules; a context, since git runs in it and hands out contents.

    ``fault`` is set when git could not hand out something that was asked for: then what was read is not all.
    """

    repository: str
    commit: str
    fault: GitFault | None = None
    _blobs: dict[str, str] = field(default_factory=dict)  # path: hash
    _links: set[str] = field(default_factory=set)
    _submodules: "dict[str, str | GitTree]" = field(default_factory=dict)  # path: commit until it is looked into
    _folders: dict[str, set[str]] = field(default_factory=dict)
    _read: dict[str, bytes] = field(default_factory=dict)
    _git: "subprocess.Popen[bytes] | None" = None
    _stack: ExitStack = field(default_factory=ExitStack)

    @property
    def folder(self) -> str:
        """The absolute path of the work tree."""
        return self.repository

    @property
    def version(self) -> str:
        """The hash of the commit; of one that cannot be read as a whole nothing can be kept."""
        return "" if self.fault else self.commit

    def __enter__(self) -> Self:
        """List what there is."""
        listed = git_says(self.repository, "ls-tree", "-r", "-z", "--full-tree", self.commit)
        if isinstance(listed, GitFault):
            self.fault = listed
            return self
        for line in listed.split("\0")[:-1]:
            head, _, path = line.partition("\t")
            mode, _, name = head.split(" ")
            if mode == _SUBMODULE:
                self._submodules[path] = name
            else:
                self._blobs[path] = name
                self._add(path)
            if mode == _SYMLINK:
                self._links.add(path)
        return self

    def _add(self, path: str) -> None:
        while path:
            folder, _, name = path.rpartition("/")
            names = self._folders.setdefault(folder, set())
            if name in names:
                return
            names.add(name)
            path = folder

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Let git end."""
        self._stack.close()
        if self._git is not None:
            self._git.communicate()

    def holds(self, path: str) -> bool:
        """Return whether there is such a file, or a link to one."""
        tree, path = self._at(path)
        return path in tree._blobs

    def read(self, path: str) -> bytes | None:
        """The content of a file, links of the commit followed; None where there is none."""
        tree, path = self._at(path)
        blob = tree._blobs.get(path)
        return None if blob is None else self._noting(tree, blob)

    def names(self, folder: str) -> tuple[str, ...] | None:
        """The names in a folder, sorted; None where there is none."""
        tree, folder = self._at(folder)
        names = tree._folders.get(folder)
        return None if names is None else tuple(sorted(names))

    def _at(self, path: str) -> "tuple[GitTree, str]":
        """The tree that has a path, itself or a submodule, and the path there with no links in it."""
        for _ in range(_MOST_LINKS if self._links else 0):
            link = next((part for part in _heads(path) if part in self._links), None)
            if link is None:
                break
            target = os.fsdecode(self._content(self._blobs[link]))
            joined = posixpath.join(posixpath.dirname(link), target, path[len(link) + 1 :])
            path = posixpath.normpath(joined).removeprefix(".")
        if self._submodules:
            head = next((part for part in _heads(path) if part in self._submodules), None)
            found = None if head is None else self._submodule(head)
            if head is not None and found is not None:
                below = found._at(path[len(head) + 1 :])
                self.fault = self.fault or found.fault
                return below
        return self, path

    def _submodule(self, path: str) -> "GitTree | None":
        found = self._submodules[path]
        if isinstance(found, str):
            found = self._stack.enter_context(GitTree(os.path.join(self.repository, *path.split("/")), found))
            self._submodules[path] = found
        if found.fault is not None and self.fault is None:
            hint = f"git submodule update --init {path}, or in it: git fetch origin {found.commit}"
            self.fault = GitFault(f"the submodule {path} has no commit {found.commit[:12]} here", hint)
        return found

    def _noting(self, tree: "GitTree", blob: str) -> bytes:
        """A content of the tree or of one of its submodules, whose fault is one of the whole."""
        content = tree._content(blob)
        self.fault = self.fault or tree.fault
        return content

    def _content(self, blob: str) -> bytes:
        if blob not in self._read:
            self._read[blob] = self._asked(blob)
        return self._read[blob]

    def _asked(self, blob: str) -> bytes:
        if self._git is None:
            self._git = subprocess.Popen(  # noqa: S603
                ["git", "-C", self.repository, "cat-file", "--batch"],  # noqa: S607
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                env=git_environment(),
            )
        assert self._git.stdin is not None
        assert self._git.stdout is not None
        try:
            self._git.stdin.write(f"{blob}\n".encode())
            self._git.stdin.flush()
            head = self._git.stdout.readline().split()
        except OSError:  # git ends where the remote of a partial clone does not answer
            head = []
        if len(head) != 3:
            hint = "a partial clone fetches what it lacks from its remote; git fsck tells what is damaged"
            self.fault = self.fault or GitFault(f"git has no object {blob[:12]} of it", hint)
            return b""
        content = self._git.stdout.read(int(head[2]))
        self._git.stdout.read(1)
        return content


def _heads(path: str) -> Iterator[str]:
    """``a``, ``a/b`` and ``a/b/c`` of ``a/b/c``."""
    parts = path.split("/")
    return ("/".join(parts[: number + 1]) for number in range(len(parts)))
