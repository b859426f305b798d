"""Names that are words of Python, or taken, or have small letters: what goes out is right, and the suite is green."""

import shutil
from pathlib import Path

import pytest
from generated_suite import suite_is_green
from in_process import build

MINIMAL = Path(__file__).resolve().parent / "minimal" / "specs"
NAMES = ("def", "self", "class", "from", "None", "lambda", "async", "pack", "crc_extra", "force_mavlink1", "match")
DIALECT = """\
<?xml version="1.0"?>
<mavlink>
  <include>minimal.xml</include>
  <messages>
    <message id="52000" name="Named_Oddly">
      <description>d</description>
{fields}
      <extensions/>
      <field type="uint16_t" name="while">d</field>
    </message>
  </messages>
</mavlink>
"""


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project with a message whose fields have such names, built."""
    folder = tmp_path_factory.mktemp("names")
    specs = folder / "specs"
    shutil.copytree(MINIMAL, specs)
    (specs / "dialects").mkdir(exist_ok=True)
    fields = [
        f'      <field type="{"uint16_t" if at % 2 else "uint8_t[3]"}" name="{name}">d</field>'
        for at, name in enumerate(NAMES)
    ]
    (specs / "dialects" / "odd.xml").write_text(DIALECT.format(fields="\n".join(fields)))
    settings = specs / "codegen.yaml"
    settings.write_text(settings.read_text().replace("dialect: minimal", "dialect: dialects/odd.xml"))
    assert "odd.xml" in settings.read_text()
    answers = "".join(f"  {name}: {{constant: {at + 1}}}\n" for at, name in enumerate((*NAMES, "while")))
    table = f"message: Named_Oddly\nrequirement: FR-1\nstream: only\nfields:\n{answers}"
    (specs / "messages" / "odd.yaml").write_text(table)
    build(folder)
    return folder


def test_its_suite_is_green(project: Path) -> None:
    """Frames are pymavlink's, as is what each class says of its message, and values of every field are carried."""
    suite_is_green(project, "generated/tests/test_frames.py", "generated/tests/test_dialect.py")
