"""The mocks that stand in for the board on a host."""

from dataclasses import replace

from codegen.model.system import System
from codegen.render.rendered import rendered
from codegen.targets.firmware.readings.board import board_view
from codegen.targets.origin import copied_files, headed, origin_of, specification_file
from codegen.targets.source_files import mock_paths, module_name, source_files


def render_mocks(system: System) -> dict[str, str]:
    """The files below ``mocks/``."""
    files = copied_files("mocks")
    sources = [specification_file(system, "board.yaml"), specification_file(system, "state.yaml")]
    view = replace(board_view(system), mocks=tuple(map(module_name, mock_paths(system))))
    files["mocks/mock_board.py"] = headed(rendered("mocks/mock_board.py.j2", view), origin_of(system, sources))
    return files | source_files(system, "mocks")
