"""The targets of a project: each makes one kind of output from the resolved system. To add one, list it here.

TARGETS are rendered for the project and for each of its further programs, PROJECT_TARGETS for the project alone.
"""

from collections.abc import Callable

from codegen.model.system import System
from codegen.targets.documents.files import render_documents
from codegen.targets.firmware import render_firmware
from codegen.targets.mocks import render_mocks
from codegen.targets.pages import render_pages
from codegen.targets.receiver import render_receiver
from codegen.targets.schemas.files import render_schemas
from codegen.targets.suite.files import render_suite

TARGETS: tuple[Callable[[System], dict[str, str]], ...] = (
    render_firmware,
    render_mocks,
    render_suite,
    render_receiver,
    render_documents,
    render_pages,
)
"""Functions from the system to ``{path below the output folder: text}``."""

PROJECT_TARGETS: tuple[Callable[[System], dict[str, str]], ...] = (render_schemas,)
"""The same for what belongs to the project as a whole."""
