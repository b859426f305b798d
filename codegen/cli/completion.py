"""``codegen completion``: a script with which a shell completes the commands, their options and the values of these."""

import argparse
from typing import Any

SHELLS = ("bash", "zsh", "fish")


def add_command(commands: Any, common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    parser = commands.add_parser(
        "completion",
        parents=[common],
        description="Print a script with which a shell completes codegen's commands and options.",
        epilog='bash: eval "$(codegen completion bash)" in ~/.bashrc; zsh: the same with zsh in ~/.zshrc; fish: '
        "codegen completion fish > ~/.config/fish/completions/codegen.fish",
    )
    parser.add_argument("shell", choices=SHELLS, metavar="SHELL", help=", ".join(SHELLS))
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Print the script, and return the exit code."""
    words = words_by_command()
    script = {"bash": _bash, "zsh": _zsh, "fish": _fish}[arguments.shell]
    print(script(words), end="")
    return 0


def words_by_command() -> dict[str, list[str]]:
    """Return what may stand behind each command: its options, and the values that an option or argument can have."""
    from codegen.cli.parser import parser_for

    parser = parser_for([])
    (commands,) = (each for each in parser._actions if isinstance(each, argparse._SubParsersAction))
    return {name: _words(each) for name, each in commands.choices.items()}


def _words(parser: argparse.ArgumentParser) -> list[str]:
    words: list[str] = []
    for action in parser._actions:
        words += [option for option in action.option_strings if option.startswith("--")]
        words += [str(choice) for choice in action.choices or ()]
    return list(dict.fromkeys(words))


def _bash(words: dict[str, list[str]]) -> str:
    cases = "".join(f'    {name}) words="{" ".join(each)}" ;;\n' for name, each in words.items())
    return (
        "_codegen() {\n"
        '  local word words="" command=""\n'
        '  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do\n'
        '    case "$word" in -*) ;; *) command="$word"; break ;; esac\n'
        "  done\n"
        '  case "$command" in\n'
        f'    "") words="{" ".join(words)} --help --version --project" ;;\n'
        f"{cases}"
        "  esac\n"
        '  COMPREPLY=($(compgen -W "$words" -- "${COMP_WORDS[COMP_CWORD]}"))\n'
        "}\n"
        "complete -o default -F _codegen codegen\n"
    )


def _zsh(words: dict[str, list[str]]) -> str:
    return f"autoload -U +X compinit && compinit -u\nautoload -U +X bashcompinit && bashcompinit\n{_bash(words)}"


def _fish(words: dict[str, list[str]]) -> str:
    lines = [f"complete -c codegen -n __fish_use_subcommand -a {name}" for name in words]
    for name, each in words.items():
        condition = f'-n "__fish_seen_subcommand_from {name}"'
        for word in each:
            what = f"-l {word.removeprefix('--')}" if word.startswith("--") else f"-a {word}"
            lines.append(f"complete -c codegen {condition} {what}")
    return "\n".join(lines) + "\n"
