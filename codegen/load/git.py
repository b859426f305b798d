"""Asks git itself, so that every kind of repository and of revision is understood."""

import os
import re
import subprocess

from codegen.frozen import dataclass

_BEHIND = re.compile(r"(.+?)(?:~(\d*)|(\^+))")
_REMOTE = re.compile(r"([\w.-]+)/(\S+)")
_OF_HOOKS = ("GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE", "GIT_PREFIX")
_BARE = "this operation must be run in a work tree"
_HASH = re.compile(r"[0-9a-fA-F]{7,64}")


@dataclass(frozen=True, slots=True)
class GitFault:
    """The reason for which a revision cannot be read, with a hint."""

    message: str
    hint: str | None = None


def repository_of(folder: str) -> str | GitFault:
    """The absolute path of the work tree that a folder lies in, or of the repository that has none."""
    found = git_says(folder, "rev-parse", "--show-toplevel")
    if isinstance(found, GitFault) and found.message == _BARE:
        found = git_says(folder, "rev-parse", "--absolute-git-dir")
    if isinstance(found, GitFault):
        return found
    return os.path.abspath(found.removesuffix("\n"))


def commit_of(repository: str, revision: str) -> str | GitFault:
    """The hash of the commit that a revision names; ``A...B`` is the commit at which A and B parted."""
    first, dots, second = revision.partition("...")
    if dots:
        ends = [commit_of(repository, end or "HEAD") for end in (first, second)]
        for end in ends:
            if isinstance(end, GitFault):
                return end
        parted = git_says(repository, "merge-base", *map(str, ends))
        if isinstance(parted, GitFault):
            return GitFault(f"{first or 'HEAD'} and {second or 'HEAD'} have no common commit here", _deepen(repository))
        return parted.strip()
    found: str | GitFault = revision
    for suffix in ("", "^{commit}"):  # one after the other: what follows ":/" is a text to look for
        if isinstance(found, str):
            asked = f"{found.strip()}{suffix}"
            found = git_says(repository, "rev-parse", "--verify", "--quiet", "--end-of-options", asked)
    if isinstance(found, GitFault):
        missing = GitFault(f"git knows no revision {revision}", _two_sides(revision) or _fetch(repository, revision))
        return missing if "not found" not in found.message else found
    return found.strip()


def _two_sides(revision: str) -> str | None:
    """Return what a range means here: its two ends."""
    first, dots, second = revision.partition("..")
    return f"the two sides are two words: codegen diff {first or 'HEAD'} {second or 'HEAD'}" if dots else None


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
    found = git_says(repository, "rev-parse", "--is-shallow-repository")
    return isinstance(found, str) and found.strip() == "true"


def git_says(folder: str, *arguments: str) -> str | GitFault:
    """Return what git prints, started in ``folder``, or why it does not."""
    try:
        done = subprocess.run(  # noqa: S603
            ["git", "-C", folder, *arguments],  # noqa: S607
            capture_output=True,
            check=False,
            stdin=subprocess.DEVNULL,
            env=git_environment(),
        )
    except OSError:
        return GitFault("git is not found", "install git, or name folders or files")
    if done.returncode:
        said = [line.strip() for line in done.stderr.decode("utf-8", "replace").splitlines() if line.strip()]
        fatal = [line.removeprefix("fatal: ") for line in said if line.startswith("fatal: ")]
        command = next((line for line in said if line.startswith("git ")), None)  # that git proposes
        return GitFault((fatal or said or ["git refuses"])[-1], command)
    return os.fsdecode(done.stdout)


def git_environment() -> dict[str, str]:
    """Return what git runs in: as it is, but in plain English, and no index of a work tree that is only read is
    refreshed.

    A hook runs with the paths of its own repository, which would count in place of the folder that is asked about.
    """
    kept = {name: value for name, value in os.environ.items() if name not in _OF_HOOKS}
    return {**kept, "LC_ALL": "C", "GIT_OPTIONAL_LOCKS": "0"}
