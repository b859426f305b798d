"""The shipped specification without the programs beside the rover's: it is read in half the time."""

from pathlib import Path


def without_programs(specs: Path) -> None:
    """Take the further programs away, and the scenarios in which they run."""
    project = specs / "codegen.yaml"
    text = project.read_text()
    project.write_text(text[: text.index("# Further programs")])
    (specs / "scenarios.yaml").unlink()
