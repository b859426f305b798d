"""The receiver: messages turned back into quantities, for companion computers and ground tools."""

from codegen.model.system import System
from codegen.render.rendered import rendered
from codegen.targets.codec.layout import message_files
from codegen.targets.codec.runtime import MACHINE_CODE, runtime_files
from codegen.targets.origin import copied_files, headed, origin_of, specification_file
from codegen.targets.receiver.names import names_view
from codegen.targets.receiver.suite import render_receiver_suite
from codegen.targets.receiver.view import receiver_view

_FOLDER = "receiver"


def render_receiver(system: System) -> dict[str, str]:
    """The files below ``receiver/`` and their tests; nothing for a project without receiver.yaml."""
    receiver = system.receiver
    if receiver is None:
        return {}
    wires = [message.wire for message in receiver.messages]
    tables = [message.population.place.file for message in receiver.messages]
    sources = [specification_file(system, f"{name}.yaml") for name in ("receiver", "state", "streams", "parameters")]
    sources += [specification_file(system, "board.yaml"), *tables]
    accelerated = [MACHINE_CODE] if system.spec.project.machine_code else []
    files = {**copied_files(_FOLDER), **runtime_files(f"{_FOLDER}/", wires, *accelerated)}
    files |= message_files(f"{_FOLDER}/", wires, system.dialect.version, origin_of(system, tables, wires))
    view = receiver_view(system, receiver)
    origin = origin_of(system, sources, wires)
    files[f"{_FOLDER}/{view.module}.py"] = headed(rendered("receiver/views_of.py.j2", view), origin)
    names = rendered("receiver/enum_names.py.j2", names_view(view.enums, system.dialect))
    files[f"{_FOLDER}/enum_names.py"] = headed(names, origin)
    files[f"{_FOLDER}/README.md"] = rendered("receiver/README.md.j2", view)
    return files | render_receiver_suite(system, receiver, view)
