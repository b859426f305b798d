"""The JSON Schemas agree with the decoder: they accept what it accepts and refuse what it refuses."""

import json
import math
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator
from spec_examples import BROKEN, GOOD

from codegen.decode.record import decode_record
from codegen.diagnostics import Report
from codegen.load.yaml_tree import MappingNode, ScalarNode, SequenceNode, YamlNode, parse_yaml
from codegen.model.spec.spec import StreamsSpec
from codegen.targets.schemas.texts import SCHEMA_MODELS, schema_texts

SPECS = Path(__file__).resolve().parents[2] / "specs"
NAMES = ("codegen", "state", "board", "parameters", "streams", "vehicle", "receiver", "scenarios", "waivers")
SHIPPED = [
    *((name, SPECS / f"{name}.yaml") for name in NAMES),
    *(("message", path) for path in sorted((SPECS / "messages").glob("*.yaml"))),
    *(("corrections", path) for path in sorted((SPECS / "dialects").glob("*.yaml"))),
]


def plain(node: YamlNode) -> Any:
    """The tree as an editor hands it to a JSON Schema."""
    match node:
        case MappingNode():
            return {key.text: plain(value) for key, value in node.entries}
        case SequenceNode():
            return [plain(item) for item in node.items]
        case ScalarNode(value=Fraction()):
            assert isinstance(node.value, Fraction)
            return int(node.value) if node.value.denominator == 1 else float(node.value)
    return node.value


def is_valid(kind: str, text: str) -> bool:
    report = Report()
    node = parse_yaml(text, "/specs/a.yaml", report)
    assert node is not None
    schema = json.loads(schema_texts()[f"{kind}.schema.json"])
    return Draft202012Validator(schema).is_valid(plain(node))


@pytest.mark.parametrize("name", SCHEMA_MODELS)
def test_each_schema_is_valid_and_stable_text(name: str) -> None:
    text = schema_texts()[name]
    schema = json.loads(text)
    Draft202012Validator.check_schema(schema)
    assert text == json.dumps(schema, indent=2, sort_keys=True, ensure_ascii=False) + "\n"
    assert schema["additionalProperties"] is False


def test_every_key_is_described() -> None:
    """An editor shows the descriptions while one types."""

    def undescribed(schema: Any, path: str) -> list[str]:
        found = []
        for key, value in schema.items() if isinstance(schema, dict) else ():
            if key == "properties":
                found += [f"{path}.{name}" for name, inner in value.items() if not inner.get("description")]
            found += undescribed(value, f"{path}.{key}")
        return found

    assert [missing for name, text in schema_texts().items() for missing in undescribed(json.loads(text), name)] == []


@pytest.mark.parametrize("kind", GOOD)
def test_the_schemas_accept_the_good_examples(kind: str) -> None:
    assert is_valid(kind, GOOD[kind])


@pytest.mark.parametrize(("kind", "text"), [case[:2] for case in BROKEN], ids=[repr(case[1][-40:]) for case in BROKEN])
def test_the_schemas_refuse_what_the_decoder_refuses(kind: str, text: str) -> None:
    """Unknown and missing keys, wrong types and choices, empty mappings, none or two sources."""
    assert not is_valid(kind, text)


def test_not_a_number_is_the_decoders_own_business() -> None:
    """JSON has no such number, so no schema can speak of it."""
    text = "message: M\nrequirement: R\nstream: S\nfields: {f: {constant: .nan}}\n"
    assert is_valid("message", text)
    node = parse_yaml("- .nan", "/specs/a.yaml", Report())
    assert isinstance(node, SequenceNode)
    assert math.isnan(plain(node)[0])


@pytest.mark.parametrize(("kind", "path"), SHIPPED, ids=[path.name for _, path in SHIPPED])
def test_the_shipped_specification_is_valid(kind: str, path: Path) -> None:
    assert is_valid(kind, path.read_text(encoding="utf-8"))


@pytest.mark.parametrize(
    ("amount", "is_amount"),
    [
        *((amount, True) for amount in ("3.3 V", "-1 cA", "1e3 Hz", "50 %", "2 ms", "3.3V", ".5 s")),
        *((text, False) for text in ("V", "3.3", "3.3 V V", "3,3 V", "", " 2 ms", "2 3")),
    ],
)
def test_amounts_have_one_pattern(amount: str, is_amount: bool) -> None:
    text = f"streams:\n  A: {{doc: d, rate: {json.dumps(amount)}}}\n"
    assert is_valid("streams", text) == is_amount
    report = Report()
    node = parse_yaml(text, "/specs/a.yaml", report)
    assert node is not None
    decode_record(node, StreamsSpec, report)
    assert report.has_errors != is_amount
