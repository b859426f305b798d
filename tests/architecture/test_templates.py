"""Templates only print: one with many control lines has begun to decide what its view should."""

from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "templates" / "firmware"
LARGEST_SHARE = 0.08


def control_lines(text: str) -> int:
    """Return how many lines of a template begin with a statement of Jinja, which steers what is printed."""
    return sum(line.lstrip().startswith("{%") for line in text.splitlines())


def test_templates_of_the_firmware_only_print():
    """Of all lines below templates/firmware at most 8 % decide; files that are copied as they are count as lines."""
    paths = sorted([*FOLDER.rglob("*.j2"), *FOLDER.rglob("*.py")])
    texts = {path.relative_to(FOLDER): path.read_text(encoding="utf-8") for path in paths}
    counted = {path: (control_lines(text), len(text.splitlines())) for path, text in texts.items()}
    control, lines = (sum(numbers) for numbers in zip(*counted.values(), strict=True))
    by_file = [f"{path}: {found} of {of}, {found / of:.1%}" for path, (found, of) in counted.items() if found]
    assert control <= LARGEST_SHARE * lines, "\n".join([f"{control} of {lines}, {control / lines:.1%}", *by_file])
