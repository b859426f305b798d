"""The files that kinds of sensors bring along, drivers, mocks and tests: copied where a project has such a sensor."""

import os

from codegen.model.code.clock import CLOCK
from codegen.model.system import System
from codegen.targets.origin import headed, origin_of, origin_of_text
from codegen.tool.template_files import driver_text


def module_name(path: str) -> str:
    """The name of the module in a file."""
    return os.path.basename(path).removesuffix(".py")


def mock_paths(system: System) -> tuple[str, ...]:
    """The files that stand in for the hardware of sensors, once each."""
    return tuple(dict.fromkeys(path for source in system.polled for path in source.mocks))


def source_files(system: System, folder: str) -> dict[str, str]:
    """The files below ``folder``, which is firmware, mocks or tests: ``{path in the output: text}``.

    Modules of machine code come where the project has it: a driver takes its plain ones else.
    """
    has_machine_code = system.spec.project.machine_code
    files = {}
    for source in system.polled:
        clock = source.clock_modules if CLOCK in system.components else ()
        brought = {"firmware": (*source.modules, *clock), "mocks": source.mocks, "tests": source.tests}
        for path in brought[folder]:
            if path.endswith("_viper.py") and not has_machine_code:
                continue
            text = driver_text(path)
            files[f"{folder}/{os.path.basename(path)}"] = headed(text, origin_of_text(f"codegen/sources/{path}", text))
        for path, text in source.own_modules.items() if folder == "firmware" else ():
            files[f"{folder}/{os.path.basename(path)}"] = headed(text, origin_of(system, [path]))
    return files
