"""A revision of a git repository as a tree: its files are read as blobs, and nothing is checked out.

git itself is asked (rev-parse, ls-tree, cat-file), so that every kind of repository and of revision is understood.
"""

import os
import posixpath
import re
import subprocess
from dataclasses import dataclass, field
from types import TracebackType
from typing import Self

_SYMLINK = "120000"
_BLOBS = ("100644", "100755", "100664", _SYMLINK)
_MOST_LINKS = 8
_BEHIND = re.compile(r"(.+?)(?:~(\d*)|(\^+))")
_REMOTE = re.compile(r"([\w.-]+)/(\S+)")
_OF_HOOKS = ("GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE", "GIT_PREFIX")
_HASH = re.compile(r"[0-9a-fA-F]{7,64}")


@dataclass(frozen=True, slots=True)
class GitFault:
    """Why a revision cannot be read, and what to do about it."""

    message: str
    hint: str | None = None


def repository_of(folder: str) -> str | GitFault:
    """The absolute path of the work tree that a folder lies in."""
    found = _git(folder, "rev-parse", "--show-toplevel")
    if isinstance(found, GitFault):
        return found
    return os.path.abspath(found.strip())


def commit_of(repository: str, revision: str) -> str | GitFault:
    """The hash of the commit that a revision names; ``A...B`` is the commit at which A and B parted."""
    first, dots, second = revision.partition("...")
    if dots:
        ends = [commit_of(repository, end or "HEAD") for end in (first, second)]
        for end in ends:
            if isinstance(end, GitFault):
                return end
        parted = _git(repository, "merge-base", *map(str, ends))
        if isinstance(parted, GitFault):
            return GitFault(f"{first or 'HEAD'} and {second or 'HEAD'} have no common commit here", _deepen(repository))
        return parted.strip()
    found = _git(repository, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{commit}}")
    if isinstance(found, GitFault):
        missing = GitFault(f"git knows no revision {revision}", _fetch(repository, revision))
        return missing if "not found" not in found.message else found
    return found.strip()


def _deepen(repository: str) -> str | None:
    return "this clone is shallow: git fetch --unshallow" if _is_shallow(repository) else None


def _fetch(repository: str, revision: str) -> str | None:
    """The command that brings a revision into a shallow clone."""
    if not _is_shallow(repository):
        return None
    behind, remote = _BEHIND.fullmatch(revision), _REMOTE.fullmatch(revision)
    command = "git fetch --unshallow"
    if behind is not None:
        steps = int(behind[2] or 1) if behind[2] is not None else len(behind[3])
        command = f"git fetch --deepen={steps}"
    elif remote is not None:
        command = f"git fetch --depth=1 {remote[1]} +refs/heads/{remote[2]}:refs/remotes/{remote[1]}/{remote[2]}"
    elif _HASH.fullmatch(revision):
        command = f"git fetch --depth=1 origin {revision}"
    return f"this clone is shallow: {command}"


def _is_shallow(repository: str) -> bool:
    found = _git(repository, "rev-parse", "--is-shallow-repository")
    return isinstance(found, str) and found.strip() == "true"


def _git(folder: str, *arguments: str) -> str | GitFault:
    """What git prints, or why it does not."""
    try:
        done = subprocess.run(  # noqa: S603
            ["git", "-C", folder, *arguments],  # noqa: S607
            capture_output=True,
            check=False,
            stdin=subprocess.DEVNULL,
            env=_environment(),
        )
    except OSError:
        return GitFault("git is not found", "install git, or name folders or files")
    if done.returncode:
        said = done.stderr.decode("utf-8", "replace").strip().splitlines()
        return GitFault(said[-1].removeprefix("fatal: ") if said else "git refuses")
    return os.fsdecode(done.stdout)


def _environment() -> dict[str, str]:
    """As it is, but in plain English, and without refreshing the index of a work tree that is only read.

    A hook runs with the paths of its own repository, which would count in place of the folder that is asked about.
    """
    kept = {name: value for name, value in os.environ.items() if name not in _OF_HOOKS}
    return {**kept, "LC_ALL": "C", "GIT_OPTIONAL_LOCKS": "0"}


@dataclass(slots=True)
class GitTree:
    """The files of one commit; a context, since git runs in it and hands out the contents."""

    repository: str
    commit: str
    _blobs: dict[str, tuple[str, str]] = field(default_factory=dict)  # path: mode, hash
    _folders: dict[str, set[str]] = field(default_factory=dict)
    _read: dict[str, bytes] = field(default_factory=dict)
    _git: "subprocess.Popen[bytes] | None" = None

    @property
    def folder(self) -> str:
        """The absolute path of the work tree."""
        return self.repository

    def __enter__(self) -> Self:
        """List what there is."""
        listed = _git(self.repository, "ls-tree", "-r", "-z", "--full-tree", self.commit)
        for line in listed.split("\0") if isinstance(listed, str) else ():
            head, _, path = line.partition("\t")
            mode, _, rest = head.partition(" ")
            if mode in _BLOBS:
                self._blobs[path] = mode, rest.split(" ")[1]
                self._add(path)
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
        if self._git is not None:
            self._git.communicate()

    def holds(self, path: str) -> bool:
        """Whether there is such a file, or link."""
        return path in self._blobs

    def read(self, path: str) -> bytes | None:
        """The content of a file, links of the commit followed; None where there is none."""
        for _ in range(_MOST_LINKS):
            if path not in self._blobs:
                return None
            mode, blob = self._blobs[path]
            content = self._content(blob)
            if mode != _SYMLINK:
                return content
            path = posixpath.normpath(posixpath.join(posixpath.dirname(path), os.fsdecode(content)))
        return None

    def names(self, folder: str) -> tuple[str, ...] | None:
        """The names in a folder, sorted; None where there is none."""
        names = self._folders.get(folder)
        return None if names is None else tuple(sorted(names))

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
                env=_environment(),
            )
        assert self._git.stdin is not None
        assert self._git.stdout is not None
        self._git.stdin.write(f"{blob}\n".encode())
        self._git.stdin.flush()
        head = self._git.stdout.readline().split()
        if len(head) != 3:  # "... missing": a damaged repository, or a partial clone that cannot fetch
            return b""
        content = self._git.stdout.read(int(head[2]))
        self._git.stdout.read(1)
        return content
