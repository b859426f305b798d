"""YAML as located trees: the meaning of scalars, exact places, and broken input of every kind."""

import math
from fractions import Fraction
from typing import Any

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from codegen.diagnostics import Report
from codegen.load.yaml_tree import MappingNode, ScalarNode, SequenceNode, YamlNode, parse_yaml

FILE = "/specs/a.yaml"


def parsed(text: str) -> YamlNode:
    report = Report()
    node = parse_yaml(text, FILE, report)
    assert node is not None, list(report)
    assert list(report) == []
    return node


def found(text: str) -> list[tuple[str, int, int]]:
    report = Report()
    parse_yaml(text, FILE, report)
    return [(d.rule.id, d.place.line, d.place.column) for d in report]


def places(node: YamlNode) -> Any:
    """The tree with ``line:column`` in place of every node, keys as ``(text, place)``."""
    at = f"{node.place.line}:{node.place.column}"
    match node:
        case ScalarNode():
            return at
        case SequenceNode():
            return [at, *(places(item) for item in node.items)]
        case MappingNode():
            return at, {(key.text, places(key)): places(value) for key, value in node.entries}


@pytest.mark.parametrize(
    ("written", "value"),
    [
        ("true", True),
        ("False", False),
        ("yes", "yes"),
        ("no", "no"),
        ("on", "on"),
        ("off", "off"),
        ("y", "y"),
        ("tRUE", "tRUE"),
        ("'true'", "true"),
        ("12:30", "12:30"),
        ("1:30:00.5", "1:30:00.5"),
        ("2026-05-01", "2026-05-01"),
        ("010", Fraction(10)),
        ("-007", Fraction(-7)),
        ("0o17", Fraction(15)),
        ("017", Fraction(17)),
        ("0xFFFF", Fraction(65535)),
        ("0b101", "0b101"),
        ("1_000", "1_000"),
        ("0o18", "0o18"),
        ("3.95", Fraction(79, 20)),
        ("0.0001", Fraction(1, 10000)),
        ("-.5", Fraction(-1, 2)),
        ("5.", Fraction(5)),
        ("1e3", Fraction(1000)),
        ("6.02E-2", Fraction(301, 5000)),
        ("+1", Fraction(1)),
        ("0.1e400", Fraction(10) ** 399),
        (".inf", math.inf),
        ("-.INF", -math.inf),
        ("1e401", math.inf),
        ("1e999999999999", math.inf),
        ("9" * 401, math.inf),
        ("inf", "inf"),
        ("NaN", "NaN"),
        ("1.2.3", "1.2.3"),
        ("3.3 V", "3.3 V"),
        ("٣", "٣"),
        ("null", None),
        ("~", None),
        ("''", ""),
        ("nUll", "nUll"),
        ("=", "="),
        ('"a\\u00b0"', "a°"),
    ],
)
def test_scalars_mean_what_yaml_1_2_says(written: str, value: object) -> None:
    """Neither yes/no booleans, nor sexagesimal or octal-by-zero numbers, nor dates; numbers are exact."""
    node = parsed(f"- {written}")
    assert isinstance(node, SequenceNode)
    (item,) = node.items
    assert isinstance(item, ScalarNode)
    assert type(item.value) is type(value)
    assert item.value == value


def test_not_a_number_and_an_empty_value() -> None:
    node = parsed("a: .nan\nb:\n")
    assert isinstance(node, MappingNode)
    (_, nan), (_, empty) = node.entries
    assert isinstance(nan, ScalarNode)
    assert isinstance(nan.value, float)
    assert math.isnan(nan.value)
    assert nan.text == ".nan"
    assert empty == ScalarNode(None, "", empty.place)


def test_places_are_exact() -> None:
    """Block and flow style, lists at the indentation of their key, wide characters, and empty values at their key."""
    text = (
        "# yaml-language-server: $schema=x\n"
        "a: 1\n"
        "bé:\n"
        "- x\n"
        '- "🔋y": [1, {k: v}]\n'
        "c: |\n"
        "  text\n"
        "d:\r\n"
        "  e: {f: , g: 2}\n"
        "h:\n"
    )
    assert places(parsed(text)) == (
        "2:1",
        {
            ("a", "2:1"): "2:4",
            ("bé", "3:1"): [
                "4:1",
                "4:3",
                ("5:3", {("🔋y", "5:3"): ["5:9", "5:10", ("5:13", {("k", "5:14"): "5:17"})]}),
            ],
            ("c", "6:1"): "6:4",
            ("d", "8:1"): ("9:3", {("e", "9:3"): ("9:6", {("f", "9:7"): "9:7", ("g", "9:12"): "9:15"})}),
            ("h", "10:1"): "10:1",
        },
    )
    assert places(parsed("\ufeffa: 1")) == ("1:1", {("a", "1:1"): "1:4"})
    assert parsed("a: 1").place.file == FILE


BROKEN = [
    ("", [("yaml-empty", 1, 1)]),
    ("\n# only a comment\n", [("yaml-empty", 1, 1)]),
    ("---\n", [("yaml-empty", 1, 1)]),
    ("a: 1\nb: 2\na: 3\n", [("yaml-duplicate-key", 3, 1)]),
    ("a:\n  b: 1\n  'b': 2\n  b: 3\n", [("yaml-duplicate-key", 3, 3), ("yaml-duplicate-key", 4, 3)]),
    ("1: a\n'1': b", [("yaml-duplicate-key", 2, 1)]),
    ("a: &x 1\nb: *x\n", [("yaml-unsupported", 1, 4), ("yaml-unsupported", 2, 4)]),
    ("a: {<<: b}", [("yaml-unsupported", 1, 5)]),
    ("a: !!str 1\nb: !x\n", [("yaml-unsupported", 1, 4), ("yaml-unsupported", 2, 4)]),
    ("a: 1\n---\nb: 2\n", [("yaml-unsupported", 2, 1)]),
    ("? [a, b]\n: c", [("yaml-unsupported", 1, 3)]),
    ("%YAML 1.1\n---\na: 1", [("yaml-unsupported", 1, 1)]),
    ("%YAML 1.3\n---\na: 1", [("yaml-unsupported", 1, 1)]),
    ('a: "\\ud800"', [("yaml-unsupported", 1, 4)]),
    ("a:\n\tb: 1", [("yaml-syntax", 2, 1)]),
    ("a: x\ty", [("yaml-syntax", 1, 5)]),
    ("a: 1\n  b: 2\n c: 3", [("yaml-syntax", 2, 4)]),
    ("a:\n    b: 1\n  c: 2\n", [("yaml-syntax", 3, 3)]),
    ("a: 1\nb: 'x\nc: 2\n", [("yaml-syntax", 2, 4)]),
    ('a: "x', [("yaml-syntax", 1, 4)]),
    ("a: [1, 2\nb: 3\n", [("yaml-syntax", 2, 2)]),
    ("a: {b: 1", [("yaml-syntax", 1, 9)]),
    ("a: ]", [("yaml-syntax", 1, 4)]),
    ("a: b: c", [("yaml-syntax", 1, 5)]),
    ("a: 1\nb\nc: 2\n", [("yaml-syntax", 2, 1)]),
    ("a: @b", [("yaml-syntax", 1, 4)]),
    ("a: %b", [("yaml-syntax", 1, 4)]),
    ("a: 1\nb: \x01\n", [("yaml-syntax", 2, 4)]),
    ("a: \x00", [("yaml-syntax", 1, 4)]),
    ("a: b\u2028c", [("yaml-syntax", 1, 5)]),
    ("a: \ud800", [("yaml-syntax", 1, 4)]),
    ('a: "\\q"', [("yaml-syntax", 1, 6)]),
    ('a: "\\UFFFFFFFF"', [("yaml-syntax", 1, 7)]),
    ("- a\nb: c", [("yaml-syntax", 2, 1)]),
    ("[" * 10_000, [("yaml-too-deep", 1, 65)]),
    ("- " * 10_000, [("yaml-too-deep", 1, 129)]),
    ("{a: " * 10_000, [("yaml-too-deep", 1, 257)]),
]


@pytest.mark.parametrize(("text", "expected"), BROKEN, ids=[repr(text[:20]) for text, _ in BROKEN])
def test_broken_input_is_reported_at_its_place(text: str, expected: list[tuple[str, int, int]]) -> None:
    assert found(text) == expected


@pytest.mark.parametrize("text", [text for text, _ in BROKEN], ids=lambda text: repr(text[:20]))
def test_a_tree_is_returned_only_where_it_is_what_was_written(text: str) -> None:
    """Of a key that is written twice the first value stays; everything else leaves no tree."""
    report = Report()
    node = parse_yaml(text, FILE, report)
    assert (node is not None) == all(d.rule.id == "yaml-duplicate-key" for d in report)


def test_a_duplicate_cites_the_first_key() -> None:
    report = Report()
    node = parse_yaml("a: 1\nb: 2\na: 3\n", FILE, report)
    (finding,) = report
    assert [(place.line, place.column) for place, _ in finding.related] == [(1, 1)]
    assert isinstance(node, MappingNode)
    assert [(key.text, value.value) for key, value in node.entries if isinstance(value, ScalarNode)] == [
        ("a", 1),
        ("b", 2),
    ]


def test_findings_before_a_syntax_error_are_reported_too() -> None:
    assert found("a: {k: 1, k: 2}\nb: 'x\n") == [("yaml-duplicate-key", 1, 11), ("yaml-syntax", 2, 4)]


def test_unreadable_is_what_is_no_yaml() -> None:
    """Exit code 2 for text that cannot be read, 1 for readable text with mistakes."""
    for text, code in (("a: [", 2), ("[" * 1000, 2), ("a: 1\na: 2", 1), ("a: &x 1", 1), ("", 1)):
        report = Report()
        parse_yaml(text, FILE, report)
        assert report.exit_code == code, text


def test_aliases_of_aliases_are_refused_and_not_expanded() -> None:
    """Nine levels of nine aliases would be a billion items."""
    lines = ["a0: &a0 [x, x, x]"]
    lines += [f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 9)}]" for n in range(1, 10)]
    rules = {rule for rule, _, _ in found("\n".join(lines))}
    assert rules == {"yaml-unsupported"}


def test_a_file_with_endless_findings_is_given_up() -> None:
    findings = found("\n".join("a: 1" for _ in range(50_000)))
    assert len(findings) == 102
    assert ("yaml-too-many-findings", 102, 1) in findings
    findings = found("[" + "*a, " * 50_000 + "]")
    assert len(findings) == 102
    assert ("yaml-too-many-findings", 1, 402) in findings


STRUCTURE = ("\n", "\n  ", "\n ", "\r\n", "- ", ": ", ", ", "? ", "[", "]", "{", "}", "---", "...", "|\n  ", ">-\n  ")
CONTENT = ("a", "b: ", "'", '"', "&x ", "*x", "!t ", "#", " # c", "1", "-", "é", "🔋", "<<: ", "\\x", "true", "\t")
SNIPPETS = st.sampled_from((*STRUCTURE, *CONTENT, "%YAML 1.2\n"))


@pytest.mark.skipif(not yaml.__with_libyaml__, reason="there is one parser only")
@settings(max_examples=400)
@given(st.lists(SNIPPETS, max_size=14).map("".join))
def test_both_parsers_give_the_same_tree_places_and_findings(text: str) -> None:
    """The parser in C is an accelerator: what is valid, and where a finding is placed, must not depend on it.

    Known and left alone: only the one in C takes ``|#`` and a question mark inside a flow scalar.
    """
    if "|#" in text or "?" in text:
        return
    with pytest.MonkeyPatch.context() as patch:
        fast = Report()
        fast_node = parse_yaml(text, FILE, fast)
        patch.setattr(yaml, "CSafeLoader", yaml.SafeLoader)
        slow = Report()
        slow_node = parse_yaml(text, FILE, slow)
    assert fast_node == slow_node
    assert list(fast) == list(slow)


@settings(max_examples=400)
@given(
    st.one_of(st.text(), st.lists(SNIPPETS, max_size=30).map("".join), st.text(alphabet="[]{}:-?&*!|>'\"%@`\\#,\n a1"))
)
def test_no_text_raises_or_leaves_without_a_word(text: str) -> None:
    """A tree, or at least one diagnostic whose place lies in the text."""
    report = Report()
    node = parse_yaml(text, FILE, report)
    assert node is not None or report.has_errors
    for finding in report:
        assert 1 <= finding.place.line <= text.count("\n") + text.count("\r") + 2
