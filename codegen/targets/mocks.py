"""The mocks that stand in for the board on a host."""

from codegen.model.system import System
from codegen.targets.firmware.board import board_view
from codegen.targets.origin import copied_files, headed, origin_of, specification_file
from codegen.targets.rendered import rendered


def render_mocks(system: System) -> dict[str, str]:
    """The files below ``mocks/``."""
    files = copied_files("mocks")
    sources = [specification_file(system, "board.yaml"), specification_file(system, "state.yaml")]
    text = rendered("mocks/mock_board.py.j2", board_view(system))
    files["mocks/mock_board.py"] = headed(text, origin_of(system, sources))
    return files
