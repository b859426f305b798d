"""Libraries that pymavlink makes of a dialect are right; a fault in one of their numbers is found.

They repeat the descriptions of the dialect word by word, which speak of other fields, of messages and of older versions.
"""

import random
from pathlib import Path

import pytest
from claims_libraries import KINDS, Document, Kind, faulty, findings, is_found, library
from lxml import etree
from pymavlink import mavutil

MESSAGES = (
    "BATTERY_STATUS", "CAMERA_IMAGE_CAPTURED", "COMMAND_ACK", "GIMBAL_MANAGER_SET_PITCHYAW", "HIL_STATE",
    "PARAM_EXT_REQUEST_READ",
)  # fmt: skip
"""Messages whose files had false findings in one language or another."""
UNREAD = {kind for kind in KINDS["TypeScript"] if kind.name == "type"}
"""Types in comments above a class that only then says which message it is."""
ENUMS = ("MAV_FRAME", "MAV_BATTERY_FAULT", "ACTUATOR_OUTPUT_FUNCTION")


@pytest.fixture(scope="module")
def xml(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a part of common.xml."""
    shipped = Path(mavutil.__file__).parent / "dialects" / "v20" / "common.xml"
    root = etree.parse(shipped).getroot()
    for include in root.findall("include"):
        root.remove(include)
    for parent, names in (("messages", MESSAGES), ("enums", ENUMS)):
        for element in root.iterfind(f"{parent}/*"):
            if element.get("name") not in names:
                element.getparent().remove(element)
            for field in element.iterfind("field"):
                if field.get("enum") not in ENUMS:
                    field.attrib.pop("enum", None)
    path = tmp_path_factory.mktemp("xml") / "part.xml"
    path.write_bytes(etree.tostring(root))
    return path


@pytest.fixture(scope="module")
def libraries(xml: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, tuple[Document, ...]]:
    """Return the libraries by language."""
    folder = tmp_path_factory.mktemp("libraries")
    made = {language: library(xml, language, folder) for language in KINDS}
    return {name: tuple(each for each in those if _is_of_part(each)) for name, those in made.items()}


def _with_faults(document: Document, kinds: set[Kind]) -> tuple[Document, dict[int, str]]:
    """Return a document with a fault of each kind that it can have, which are taken out of ``kinds``, and their lines."""
    lines = {}
    for kind in sorted(kinds, key=lambda each: each.name):
        for changed, line in faulty([document], kind, 1, random.Random(2)):
            if line not in lines:
                document, lines[line] = changed, kind.name
                kinds.remove(kind)
    return document, lines


def _is_of_part(document: Document) -> bool:
    """Return whether a file is of a message or an enum, and none that all libraries of a language have."""
    path = "".join(letter for letter in document.path.lower() if letter.isalnum())
    return "testsuite" not in path and any(name.replace("_", "").lower() in path for name in (*MESSAGES, *ENUMS))


@pytest.mark.parametrize("language", KINDS)
def test_a_library_is_right(libraries: dict[str, tuple[Document, ...]], language: str) -> None:
    documents = libraries[language]
    assert len(documents) >= len(MESSAGES)
    assert [str(each) for document in documents for each in findings(document)] == []


@pytest.mark.parametrize("language", [language for language, kinds in KINDS.items() if kinds])
def test_faults_are_found(libraries: dict[str, tuple[Document, ...]], language: str) -> None:
    missed, kinds = [], set(KINDS[language]) - UNREAD
    for right in libraries[language]:
        if "battery" in right.path or "enum" in right.path:
            document, lines = _with_faults(right, kinds)
            missed += [f"{kind} in {right.path}:{line}" for line, kind in lines.items() if not is_found(document, line)]
    assert (missed, kinds) == ([], set())
