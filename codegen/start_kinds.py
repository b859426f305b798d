"""What a new project can begin as: ``templates/start/kinds.json``."""

import json
import os
from collections.abc import Mapping

from codegen.template_files import templates_folder


def start_kinds() -> Mapping[str, str]:
    """Each kind, and what it is, in a few words."""
    with open(os.path.join(templates_folder(), "start", "kinds.json"), encoding="utf-8") as file:
        kinds: dict[str, str] = json.load(file)
    return kinds
