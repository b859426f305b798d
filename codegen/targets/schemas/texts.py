"""JSON Schemas of the YAML files (draft 2020-12), for editors; generated from the same shapes that the decoder uses."""

import json
import re
from collections.abc import Mapping
from enum import StrEnum
from fractions import Fraction
from functools import cache
from typing import Any, assert_never

from codegen.model.board_model import BoardModelSpec
from codegen.model.spec.board import BoardSpec
from codegen.model.spec.command import CommandsSpec
from codegen.model.spec.driver import DriverSpec
from codegen.model.spec.population import PopulationSpec
from codegen.model.spec.program import VehicleSpec
from codegen.model.spec.receive import ReceiveSpec
from codegen.model.spec.receiver import ReceiverSpec
from codegen.model.spec.scenario import ScenariosSpec
from codegen.model.spec.shape import (
    AnyScalar,
    Choice,
    Key,
    ListOf,
    MappingOf,
    Null,
    Number,
    OneOf,
    RecordOf,
    ScalarOrList,
    Shape,
    Text,
    Whole,
    YesNo,
    beside,
    chosen_by,
    keys_of,
    one_of,
    rest,
    short_forms,
)
from codegen.model.spec.source import OwnSourceSpec
from codegen.model.spec.spec import CorrectionsSpec, ParametersSpec, ProgramProject, Project, StreamsSpec
from codegen.model.spec.state import StateSpec
from codegen.model.spec.trace_lock import TraceLockSpec
from codegen.model.spec.waiver import WaiversSpec
from codegen.source import Written
from codegen.sources import SPECS

SCHEMA_MODELS: Mapping[str, type[Written]] = {
    "codegen.schema.json": Project,
    "program.schema.json": ProgramProject,
    "state.schema.json": StateSpec,
    "board.schema.json": BoardSpec,
    "board_model.schema.json": BoardModelSpec,
    "driver.schema.json": DriverSpec,
    "parameters.schema.json": ParametersSpec,
    "streams.schema.json": StreamsSpec,
    "vehicle.schema.json": VehicleSpec,
    "commands.schema.json": CommandsSpec,
    "receiver.schema.json": ReceiverSpec,
    "message.schema.json": PopulationSpec,
    "receive.schema.json": ReceiveSpec,
    "corrections.schema.json": CorrectionsSpec,
    "scenarios.schema.json": ScenariosSpec,
    "trace_lock.schema.json": TraceLockSpec,
    "waivers.schema.json": WaiversSpec,
}
"""The schemas by file name, each with the model of the YAML file that it describes."""

_Schema = dict[str, Any]


@cache
def schema_texts() -> Mapping[str, str]:
    """The text of every schema by its file name: sorted keys, indented, with a newline at the end."""
    return {
        name: json.dumps(_file_schema(model), indent=2, sort_keys=True, ensure_ascii=False) + "\n"
        for name, model in SCHEMA_MODELS.items()
    }


def _file_schema(model: type[Written]) -> _Schema:
    """The schema of a file; the records inside it stand under ``$defs`` by the names of their classes."""
    definitions: dict[str, _Schema] = {}
    schema = _record(model, definitions)
    schema["$schema"] = "https://json-schema.org/draft/2020-12/schema"
    if definitions:
        schema["$defs"] = definitions
    return schema


def _record(model: type[Written], definitions: dict[str, _Schema]) -> _Schema:
    """Return what the decoder takes for a record: a mapping with known keys, or one of the short forms."""
    keys = [key for key in keys_of(model) if key.attribute != rest(model)]
    schema: _Schema = {
        "type": "object",
        "properties": {key.name: _property(key, definitions) for key in keys},
        "additionalProperties": _scalar(AnyScalar()) if rest(model) else False,
    }
    required = sorted(key.name for key in keys if key.is_required)
    if required:
        schema["required"] = required
    choice = one_of(model)
    if choice:
        schema["oneOf"] = [_chosen(name, model) for name in choice]
    forms = short_forms(model)
    if forms:
        schema = {"anyOf": [{"enum": sorted(forms)}, schema]}
    schema["description"] = _description(model)
    return schema


def _chosen(name: str, model: type[Written]) -> _Schema:
    """One of several keys; where it may stand beside another, only that one counts."""
    others = [{"required": [key]} for key, other in beside(model).items() if other == name]
    return {"required": [name], **({"not": {"anyOf": others}} if others else {})}


def _property(key: Key, definitions: dict[str, _Schema]) -> _Schema:
    schema = _shape(key.shape, definitions) | {"description": key.doc}
    if key.default is not None and not key.is_required:
        schema["default"] = _plain(key.default)
    return schema


def _shape(shape: Shape, definitions: dict[str, _Schema]) -> _Schema:
    match shape:
        case ListOf():
            return {"type": "array", "items": _shape(shape.item, definitions)}
        case MappingOf():
            return {
                "type": "object",
                "additionalProperties": _shape(shape.value, definitions),
                "propertyNames": {"minLength": 1},
                **({} if shape.may_be_empty else {"minProperties": 1}),
            }
        case RecordOf() if chosen_by(shape.model) is not None:
            return {"anyOf": [_variant(word, definitions) for word in (*SPECS, None)]}
        case RecordOf():
            name = shape.model.__name__
            if name not in definitions:
                definitions[name] = {}  # claims the name before the records inside are visited
                definitions[name] = _record(shape.model, definitions)
            return {"$ref": f"#/$defs/{name}"}
        case OneOf() | ScalarOrList():
            return {"anyOf": [_shape(member, definitions) for member in shape.members]}
        case _:
            return _scalar(shape)


def _variant(word: str | None, definitions: dict[str, _Schema]) -> _Schema:
    """A record that a word chooses, or any other word than those that choose one."""
    model = OwnSourceSpec if word is None else SPECS[word]
    name = model.__name__
    if name not in definitions:
        definitions[name] = {}
        schema = _record(model, definitions)
        key = chosen_by(model)
        assert key is not None
        chosen = {"type": "string", "not": {"enum": sorted(SPECS)}} if word is None else {"const": word}
        schema["properties"][key] = chosen | {"description": schema["properties"][key]["description"]}
        definitions[name] = schema
    return {"$ref": f"#/$defs/{name}"}


def _scalar(shape: Text | AnyScalar | YesNo | Number | Whole | Null | Choice) -> _Schema:
    match shape:
        case Text():
            return {"type": "string"} if shape.pattern is None else {"type": "string", "pattern": shape.pattern}
        case AnyScalar():
            return {"type": ["string", "number", "boolean"]}
        case YesNo():
            return {"type": "boolean"} if shape.only is None else {"const": shape.only}
        case Number():
            return {"type": "number"}
        case Whole():
            return {"type": "integer"}
        case Null():
            return {"type": "null"}
        case Choice():
            return {"enum": [word.value for word in shape.words]}
    assert_never(shape)


def _plain(value: Any) -> Any:
    """A default as JSON states it."""
    match value:
        case StrEnum():
            return value.value
        case tuple():
            return [_plain(item) for item in value]
        case Fraction():
            return int(value) if value.denominator == 1 else float(value)
        case _:
            return value


def _description(model: type[Written]) -> str:
    """The docstring of the model in one line, without the marks of code in it."""
    return re.sub(r"\s+", " ", (model.__doc__ or "").replace("``", "")).strip()
