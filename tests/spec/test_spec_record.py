"""Trees into records: what is decoded with which places, and what each mistake is called and where."""

import re
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from spec_examples import BROKEN, GOOD, field

from codegen.decode.record import decode_record
from codegen.decode.record_file import decode_record_text
from codegen.diagnostics import Report
from codegen.load.yaml_tree import MappingNode, ScalarNode, SequenceNode, YamlNode, parse_yaml
from codegen.model.spec.derivation import MeasuredSpec, WhileKnownSpec
from codegen.model.spec.driver import DriverSpec
from codegen.model.spec.population import FieldAnswer, PopulationSpec, Rounding
from codegen.model.spec.program import VehicleSpec
from codegen.model.spec.receiver import ReceiverSpec
from codegen.model.spec.scenario import ScenariosSpec
from codegen.model.spec.spec import BoardSpec, CorrectionsSpec, ParametersSpec, Project, StreamsSpec
from codegen.model.spec.state import QuantitySpec, StateSpec
from codegen.model.spec.waiver import WaiversSpec
from codegen.source import Place, Written

FILE = "/specs/a.yaml"
MODELS: dict[str, type[Written]] = {
    "scenarios": ScenariosSpec,
    "waivers": WaiversSpec,
    "vehicle": VehicleSpec,
    "driver": DriverSpec,
    "receiver": ReceiverSpec,
    "codegen": Project,
    "state": StateSpec,
    "board": BoardSpec,
    "parameters": ParametersSpec,
    "streams": StreamsSpec,
    "message": PopulationSpec,
    "corrections": CorrectionsSpec,
}


def decoded(kind: str, text: str) -> tuple[Any, list[tuple[str, int, int]]]:
    report = Report()
    node = parse_yaml(text, FILE, report)
    assert node is not None
    record = decode_record(node, MODELS[kind], report)
    return record, [(d.rule.id, d.place.line, d.place.column) for d in report]


def messages(kind: str, text: str) -> list[str]:
    report = Report()
    node = parse_yaml(text, FILE, report)
    assert node is not None
    decode_record(node, MODELS[kind], report)
    return [f"{d.message} | {d.hint}" for d in report]


@pytest.mark.parametrize("kind", GOOD)
def test_good_examples_decode_without_a_word(kind: str) -> None:
    record, findings = decoded(kind, GOOD[kind])
    assert findings == []
    assert isinstance(record, MODELS[kind])


def test_values_have_the_types_of_the_model() -> None:
    """Numbers are exact, whole numbers int, choices members of their enum; what is not written has its default."""
    state, _ = decoded("state", GOOD["state"])
    voltage = state.components["battery"].quantities["voltage"]
    assert (voltage.min, voltage.invalid_after, voltage.initial, voltage.max) == (
        Fraction(-1, 2),
        5,
        Fraction(12),
        None,
    )
    assert type(voltage.invalid_after) is int
    assert state.components["battery"].first_number is None
    assert state.components["battery"].quantities["armed"].initial is False
    parameters, _ = decoded("parameters", GOOD["parameters"])
    assert parameters.parameters["MULT"].default == Fraction(79, 20)
    assert parameters.parameters["MULT"].max == 10
    board, _ = decoded("board", GOOD["board"])
    assert board.facts == {"battery": {"cells": Fraction(3), "kind": "LIPO"}}
    table, _ = decoded("message", GOOD["message"])
    assert list(table.fields) == ["id", "voltages", "energy_consumed", "flags", "load", "rest"]
    assert table.fields["voltages"].rounding is Rounding.DOWN
    assert table.fields["voltages"].max == "65 V"
    assert table.fields["flags"].flags == ("A", "B if battery.low")
    assert table.fields["load"].constant == Fraction(3, 2)
    assert table.fields["energy_consumed"].unknown is True
    corrections, _ = decoded("corrections", GOOD["corrections"])
    assert corrections.corrections[0].set == {"invalid": "0xFFFF", "units": "mV", "instance": "true"}


def quantity_of(*keys: str) -> tuple[QuantitySpec, list[tuple[str, int, int]]]:
    lines = "".join(f"        {key}\n" for key in ("doc: d", *keys))
    state, findings = decoded("state", f"components:\n  a:\n    doc: d\n    quantities:\n      q:\n{lines}")
    return state.components["a"].quantities["q"], findings


def test_keys_that_belong_together_are_a_record_of_their_own() -> None:
    """They stand among the other keys; each record has those of its own, and knows their places."""
    quantity, findings = quantity_of("adc: x", "unit: V", "multiplier: M", "while_known: y")
    place = Place(FILE, 5, 7)
    assert findings == []
    assert quantity.derivations == (
        MeasuredSpec(place=place, adc="x", multiplier="M"),
        WhileKnownSpec(place=place, while_known="y"),
    )
    assert quantity.unit == "V"
    assert [each.at(each.KEY) for each in quantity.derivations] == [Place(FILE, 7, 14), Place(FILE, 10, 22)]
    assert quantity_of("unit: V")[0].derivations == ()


def test_what_cannot_be_read_of_such_a_record_is_left_out() -> None:
    """With the other keys of it there is one all the same; with none there is no record."""
    quantity, findings = quantity_of("adc: x", "warn_above: much", "while_known: [y]")
    assert quantity.derivations == (MeasuredSpec(place=Place(FILE, 5, 7), adc="x"),)
    assert findings == [("wrong-type", 8, 21), ("wrong-type", 9, 22)]


def test_such_keys_are_among_those_that_a_mistake_is_held_against() -> None:
    text = "components:\n  a:\n    doc: d\n    quantities:\n      q:\n        doc: d\n        multiplyer: M\n"
    assert messages("state", text) == ["unknown key 'multiplyer' | did you mean multiplier?"]


def test_records_know_their_places() -> None:
    """An entry of a mapping stands at its key, a key's place is that of its value; plain entries and items too."""
    table, _ = decoded("message", GOOD["message"])
    assert table.place == Place(FILE, 1, 1)
    assert table.at("message") == Place(FILE, 1, 10)
    answer = table.fields["voltages"]
    assert answer.place == Place(FILE, 6, 3)
    assert answer.at("state") == Place(FILE, 6, 21)
    assert answer.at("note") == answer.place
    assert table.fields["energy_consumed"].place == Place(FILE, 7, 3)
    assert table.fields["energy_consumed"].at("unknown") == Place(FILE, 7, 20)
    assert table.fields["flags"].at("flags[1]") == Place(FILE, 8, 22)
    board, _ = decoded("board", GOOD["board"])
    assert board.at("facts.battery.kind") == Place(FILE, 5, 29)
    corrections, _ = decoded("corrections", GOOD["corrections"])
    assert corrections.corrections[0].place == Place(FILE, 2, 5)
    assert corrections.corrections[0].at("set.units") == Place(FILE, 4, 35)


@pytest.mark.parametrize(("kind", "text", "expected", "is_left"), BROKEN, ids=[repr(case[1][-40:]) for case in BROKEN])
def test_each_mistake_has_its_rule_and_place(
    kind: str, text: str, expected: list[tuple[str, int, int]], is_left: bool
) -> None:
    """All mistakes of a text are found, and the record is lost only where it cannot be built."""
    record, findings = decoded(kind, text)
    assert sorted(findings) == expected
    assert (record is not None) == is_left


def test_a_broken_entry_does_not_take_its_siblings_along() -> None:
    text = field("{}") + "  g: unknown\n  h: {sate: x}\n"
    record, findings = decoded("message", text)
    assert list(record.fields) == ["g"]
    assert findings == [("one-of-keys", 5, 3), ("unknown-key", 7, 7)]


def test_an_answer_whose_source_cannot_be_read_is_no_answer() -> None:
    """Later stages may rely on every answer having exactly one source."""
    for answer in ("{unknown: false}", "{flags: A, split: true}", "{constant: [1]}"):
        record, findings = decoded("message", field(answer) + "  g: unknown\n")
        assert list(record.fields) == ["g"]
        assert len(findings) == 1


@pytest.mark.parametrize(
    ("kind", "text", "said"),
    [
        (
            "state",
            "components: {c: {doc: d, quantities: {q: {doc: d, min: -400,5}}}}",
            "unknown key '5' | YAML divides at a comma: write a decimal point, such as 5.5",
        ),
        ("codegen", "projct: r\ndialect: c", "unknown key 'projct' | did you mean project?"),
        ("codegen", "project: 1\ndialect: c", 'not the number 1 | for this text, put it in quotes: "1"'),
        ("codegen", "project: r\ndialect: c\noverlays: a.xml", "wants a list, not the text 'a.xml' | write [a.xml]"),
        ("message", field("unknwn"), "a mapping or unknown is wanted here, not the text 'unknwn' | did you mean"),
        ("message", field("{constant: 1, split: yes}"), "wants true or false, not the text 'yes' | write true or"),
        ("message", field("{constant: 1, rounding: nerest}"), "not nearest or down or up or toward_zero | did you"),
        ("message", field("{state: a, enum: E}"), "state and enum are given, and only one of them can hold"),
        ("message", field("{constant: .nan}"), "constant wants a number, and .nan cannot be used as one"),
        ("streams", "streams: {A: {doc: d, rate: 2}}", "wants a number with its unit, not the number 2 | add"),
        ("parameters", "parameters: {A: {doc: d, default: '1', max: 2}}", "the text '1' | write the number alone"),
        ("state", "components:", "components has no value"),
    ],
)
def test_the_message_says_what_is_found_and_what_is_wanted(kind: str, text: str, said: str) -> None:
    assert any(said in message for message in messages(kind, text)), messages(kind, text)


def test_a_misspelt_key_is_one_finding() -> None:
    """Not an unknown key and a missing one, nor an unknown key and a field without a source."""
    assert decoded("codegen", "projct: r\ndialect: c")[1] == [("unknown-key", 1, 1)]
    assert decoded("message", field("{sate: x}"))[1] == [("unknown-key", 5, 7)]
    assert decoded("codegen", "qqq: r\ndialect: c")[1] == [("missing-key", 1, 1), ("unknown-key", 1, 1)]


def test_one_source_is_what_the_model_lists() -> None:
    assert FieldAnswer.ONE_OF == FieldAnswer.SOURCES


SCALARS = st.builds(
    lambda value, text: ScalarNode(value, text, Place(FILE)),
    st.one_of(st.none(), st.booleans(), st.text(max_size=5), st.fractions(), st.floats(), st.just("unknown")),
    st.text(max_size=5),
)
EXAMPLE_KEYS = sorted({word for text in GOOD.values() for word in re.findall(r"(\w+):", text)})
KEYS = st.sampled_from([*EXAMPLE_KEYS, "parameter", "enum", "dialect", "x", ""])


def mappings(children: st.SearchStrategy[YamlNode]) -> st.SearchStrategy[YamlNode]:
    entries = st.dictionaries(KEYS, children, max_size=6)
    return entries.map(
        lambda items: MappingNode(
            tuple((ScalarNode(key, key, Place(FILE)), value) for key, value in items.items()), Place(FILE)
        )
    )


TREES: st.SearchStrategy[YamlNode] = st.recursive(
    SCALARS,
    lambda children: st.one_of(
        mappings(children), st.lists(children, max_size=3).map(lambda items: SequenceNode(tuple(items), Place(FILE)))
    ),
    max_leaves=25,
)


@settings(max_examples=300)
@given(TREES, st.sampled_from([*MODELS.values(), FieldAnswer, QuantitySpec]))
def test_no_tree_raises_or_vanishes_without_a_word(tree: YamlNode, model: type[Written]) -> None:
    report = Report()
    record = decode_record(tree, model, report)
    assert record is not None or report.has_errors


@settings(max_examples=300)
@given(st.text() | st.binary().map(lambda data: data.decode("latin-1")), st.sampled_from([*MODELS]))
def test_no_text_raises(text: str, kind: str) -> None:
    report = Report()
    node = parse_yaml(text, FILE, report)
    if node is not None:
        decode_record(node, MODELS[kind], report)
    assert report.has_errors


def test_what_was_meant_is_looked_for_a_hundred_times() -> None:
    """For each of very many unknown keys that took minutes."""
    report = Report()
    text = "project: p\ndialect: common\n" + "".join(f"machine_code_{number}: 1\n" for number in range(1000))
    decode_record_text(text, "/codegen.yaml", Project, report)
    assert len(list(report)) == 1000
    assert [finding.hint for finding in report].count("did you mean machine_code?") == 100
