"""codegen completion: what a shell offers is what the commands take."""

import subprocess
from typing import Any

import pytest

from codegen.cli.completion import SHELLS
from codegen.cli.usage import COMMANDS


def offered(script: str, *words: str) -> set[str]:
    """Return the words that bash offers for the last one."""
    program = f'{script}\nCOMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _codegen; printf "%s\\n" "${{COMPREPLY[@]}}"'
    command = ["bash", "-c", program, "bash", "codegen", *words]
    return set(subprocess.run(command, capture_output=True, text=True, check=True).stdout.split())


def test_bash_completes_commands_options_and_their_values(run: Any) -> None:
    code, script, _ = run("completion", "bash")
    assert code == 0
    assert offered(script, "") >= {*COMMANDS, "--project"}
    assert offered(script, "b") == {"bench", "build"}
    assert offered(script, "build", "--d") == {"--debug", "--depfile", "--depfile-target", "--diff", "--dry-run"}
    assert offered(script, "init", "--from", "b") == {"boat"}
    assert offered(script, "--debug", "check", "--format", "s") == {"sarif"}


@pytest.mark.parametrize("shell", SHELLS)
def test_each_shell_has_every_command(run: Any, shell: str) -> None:
    code, script, _ = run("completion", shell)
    assert code == 0
    for command in COMMANDS:
        assert command in script.split() or f"{command})" in script
    assert ("complete -c codegen" in script) is (shell == "fish")
    assert ("bashcompinit" in script) is (shell == "zsh")
