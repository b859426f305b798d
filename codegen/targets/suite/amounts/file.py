"""The files of the suite about amounts: the cases as data, and what runs them."""

import json
from collections.abc import Iterable, Iterator, Mapping

from codegen.model.system import System
from codegen.once import once
from codegen.targets.origin import copied_files, origin_of
from codegen.targets.suite.amounts.case import AmountCase
from codegen.targets.suite.amounts.curves import curve_cases
from codegen.targets.suite.amounts.devices import arriving_cases, devices_of
from codegen.targets.suite.amounts.limits import limit_cases, shown_cases
from codegen.targets.suite.amounts.sums import sum_cases
from codegen.targets.suite.amounts.trends import trend_cases
from codegen.targets.suite.cases.file import json_line

_FOLDER = "tests/amounts"


@once
def amount_cases(system: System) -> tuple[AmountCase, ...]:
    """All cases about amounts, in the order in which they run."""
    found = (arriving_cases, shown_cases, sum_cases, curve_cases, trend_cases, limit_cases)
    return tuple(case for cases in found for case in cases(system))


def amount_tests(system: System) -> Iterator[tuple[str, str]]:
    """The criterion that each case shows, or nothing, and what the suite calls it."""
    return ((case.criterion, case.name) for case in amount_cases(system))


def render_amount_suite(system: System) -> dict[str, str]:
    """The files below ``tests/`` that are about amounts; none where nothing is computed, and no device known."""
    cases = amount_cases(system)
    if not cases:
        return {}
    files = {path.replace(_FOLDER, "tests"): text for path, text in copied_files(_FOLDER).items()}
    origin = origin_of(system, [path for path in system.spec.files if not path.endswith(".md")])
    devices = [
        {
            "sensor": each.source.name,
            "module": each.device.module,
            "settings": each.device.settings,
            "shows": [shown.settings for shown in each.device.shows],
        }
        for each in devices_of(system)
    ]
    told = [{"name": case.name, "criterion": case.criterion, "kind": case.kind, **case.facts} for case in cases]
    parts = [
        f'"generated": {json.dumps({"from": list(origin.sources), "inputs": origin.digest})}',
        f'"devices": {_listed(devices)}',
        f'"cases": {_listed(told)}',
    ]
    files["tests/amounts.json"] = "{" + ",\n".join(parts) + "}\n"
    return files


def _listed(records: Iterable[Mapping[str, object]]) -> str:
    lines = ",\n".join(json_line(dict(record)) for record in records)
    return f"[\n{lines}\n]" if lines else "[]"
