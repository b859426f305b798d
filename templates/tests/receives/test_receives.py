"""Tests of received messages against their tables, on both interpreters; pymavlink makes the frames."""

import json

import pytest
from interpreters import HERE, run_under
from oracle import dialects, message_class
from receives_model import Model

FACTS = json.loads((HERE / "receives.json").read_text(encoding="utf-8"))
FLOATS = {"nan": float("nan"), "inf": float("inf"), "-inf": -float("inf")}
PATHS = sorted({f"{field['component']}.{field['attribute']}" for table in FACTS["tables"] for field in table["fields"]})


@pytest.fixture(scope="session")
def played():
    """The steps of each case as frames, with what the model knows after them."""
    messages = {step["message"] for case in FACTS["cases"] for step in case["steps"] if "message" in step}
    modules = dialects(FACTS["dialect"], messages, HERE)
    return [_played(case, modules) for case in FACTS["cases"]]


def _played(case, modules):
    model, frames = Model(FACTS), []
    for step in case["steps"]:
        if "ms" in step:
            model.passes(step["ms"])
            frames.append(step["ms"])
            continue
        version = step.get("version", 2)
        module = modules[version == 1]
        known = message_class(module, step["message"])
        values = _values(known, step["values"])
        types = dict(zip(known.fieldnames, known.fieldtypes, strict=True))
        sent = {name: value.encode("latin-1") if isinstance(value, str) else value for name, value in values.items()}
        system, component = step["from"]
        frames.append(known(**sent).pack(module.MAVLink(None, srcSystem=system, srcComponent=component)).hex())
        model.receives(step["message"], values, step["from"], version, types)
    return frames, model


def _values(known, given):
    """All fields by name: what is not given is 0, or empty; elements are given as `name[2]`."""
    values = {}
    lengths = dict(zip(known.ordered_fieldnames, known.array_lengths, strict=True))
    for name, kind in zip(known.fieldnames, known.fieldtypes, strict=True):
        length = lengths[name]
        is_list = length and kind != "char"
        value = given.get(name, [0] * length if is_list else "" if kind == "char" else 0)
        if is_list:
            value = [_plain(given.get(f"{name}[{at}]", each)) for at, each in enumerate(value)]
        values[name] = value if kind == "char" or is_list else _plain(value)
    return values


def _plain(value):
    """JSON has no NaN."""
    return FLOATS.get(value, value) if isinstance(value, str) else value


@pytest.fixture(scope="session", params=["cpython", "micropython"])
def outcomes(request, played, tmp_path_factory):
    """Return the state of the vehicle after each case, in one run of each interpreter."""
    path = tmp_path_factory.mktemp("receives") / "cases.json"
    calls = {table["name"]: table["call"] for table in FACTS["tables"]}
    path.write_text(json.dumps({"paths": PATHS, "calls": calls, "cases": [frames for frames, _ in played]}))
    told = run_under(request.param, "receives_run.py", str(path))
    return [json.loads(line) for line in told.splitlines()]


def _cases():
    for number, case in enumerate(FACTS["cases"]):
        marks = [pytest.mark.requirement(case["requirement"])] if case["requirement"] else []
        yield pytest.param(number, id=f"{case['table']}-{case['name']}-{case['requirement']}", marks=marks)


@pytest.mark.parametrize("number", list(_cases()))
def test_receives(number, played, outcomes):
    """Quantities, what was taken, refused, called and told, are what the tables make of the frames."""
    _, model = played[number]
    known, counts, called, told, faults = outcomes[number]
    assert known == {path: _text(value) for path, value in model.known.items()}
    assert counts == {table: [model.taken[table], model.refused[table]] for table in model.taken}
    assert called == {table: model.taken[table] for table in called}
    assert told == sorted(model.told)
    assert faults == 0


def _text(value):
    """As receives_run prints a value; a float prints alike on both."""
    return None if value is None else str(value)


def test_every_table_is_seen():
    """Each field of each table is taken in some case, and each table is left alone in some."""
    for table in FACTS["tables"]:
        named = [case for case in FACTS["cases"] if case["table"] == table["name"]]
        for field in table["fields"]:
            assert [case for case in named if case["name"].startswith(field["label"])]
        assert [case for case in named if case["name"] == "own"]
