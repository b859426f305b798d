"""The facts of a program with which `codegen bench` runs its parts on a board."""

from codegen.model.system import System
from codegen.targets.naming import message_about
from codegen.targets.suite.facts.components import component_facts
from codegen.targets.suite.files import suite_origin


def bench_facts(system: System) -> dict[str, object]:
    """The facts that ``templates/deploy/bench.py`` names, as JSON knows them."""
    read = [(reading.name, reading.component.instances) for reading in system.readings()]
    return {
        "program": system.program is not None,
        "own_ports": not any(link.spec.usb for link in system.links),
        "system_id": system.system_id,
        "component_id": system.component_id,
        "components": [component.name for component in component_facts(system) if component.measured],
        "readings": [list(each) for each in dict.fromkeys(read)],
        "messages": [[message.name.lower(), len(message_about(message))] for message in system.messages],
        "set": [
            [name, next(iter(component.quantities.values())).attribute, component.instances]
            for name, component in system.components.items()
            if component.quantities
        ],
    }


def bench_inputs(system: System) -> str:
    """The hash of the specification that results of a board are about: that of the generated suite."""
    return suite_origin(system).digest
