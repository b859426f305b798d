"""The trace as ReqIF 1.2, the format in which tools for requirements exchange them (OMG formal/2016-07-01).

The attributes are called as those of the ReqIF Implementation Guide where it has one: ReqIF.ForeignID, ReqIF.Text,
ReqIF.ChapterName, ReqIF.Name. Only criteria have a text, and only documents a chapter name, so that tools can tell
them from what answers to them.

Everything has to say when it was last changed. That is a given time or always the same one, because the hour of the
export would make two files of one specification differ; a tool that takes in only what is newer wants a given one.
"""

import hashlib
from collections.abc import Iterable, Iterator
from xml.sax.saxutils import escape, quoteattr

from codegen.trace.exchange import Exchange, ExchangeObject, ObjectKind, Relation, RelationKind

NEVER = "1970-01-01T00:00:00Z"
"""The time of the last change of everything, unless another one is given."""

NAMESPACE = "http://www.omg.org/spec/ReqIF/20110401/reqif.xsd"
XHTML = "http://www.w3.org/1999/xhtml"

_FORMATTED = {"ReqIF.Text", "ReqIF.ChapterName", "ReqIF.Name"}
_ATTRIBUTES = {
    ObjectKind.DOCUMENT: ("ReqIF.ForeignID", "ReqIF.ChapterName", "status", "aliases", "refers_to", "place"),
    ObjectKind.CRITERION: ("ReqIF.ForeignID", "ReqIF.Text", "status", "result", "review", "bench", "place"),
    ObjectKind.ROW: ("ReqIF.ForeignID", "ReqIF.Name", "place"),
    ObjectKind.SYMBOL: ("ReqIF.ForeignID", "ReqIF.Name", "place"),
    ObjectKind.TEST: ("ReqIF.ForeignID", "ReqIF.Name", "status", "result", "cases", "place"),
}
_KINDS_OF_RELATION = tuple(kind for kind in RelationKind if kind is not RelationKind.PART)
"""Kinds of relations beside PART, which the hierarchy expresses."""


def reqif_xml(exchange: Exchange, changed: str = NEVER) -> str:
    """The text of the file; ``changed`` is an xsd:dateTime."""
    relations = [each for each in exchange.relations if each.kind in _KINDS_OF_RELATION]
    parts = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<REQ-IF xmlns="{NAMESPACE}" xmlns:xhtml="{XHTML}">',
        *_header(exchange.project, changed),
        "<CORE-CONTENT><REQ-IF-CONTENT>",
        "<DATATYPES>",
        f'<DATATYPE-DEFINITION-STRING IDENTIFIER="string" LAST-CHANGE="{changed}" MAX-LENGTH="32000"/>',
        f'<DATATYPE-DEFINITION-XHTML IDENTIFIER="xhtml" LAST-CHANGE="{changed}"/>',
        "</DATATYPES>",
        "<SPEC-TYPES>",
        *(line for kind in ObjectKind for line in _object_type(kind, changed)),
        *(line for kind in _KINDS_OF_RELATION for line in _relation_type(kind, changed)),
        f'<SPECIFICATION-TYPE IDENTIFIER="specification" LAST-CHANGE="{changed}" LONG-NAME="Specification"/>',
        "</SPEC-TYPES>",
        "<SPEC-OBJECTS>",
        *(line for each in exchange.objects for line in _object(each, changed)),
        "</SPEC-OBJECTS>",
        "<SPEC-RELATIONS>",
        *(line for each in relations for line in _relation(each, changed)),
        "</SPEC-RELATIONS>",
        "<SPECIFICATIONS>",
        *_specifications(exchange, changed),
        "</SPECIFICATIONS>",
        "</REQ-IF-CONTENT></CORE-CONTENT>",
        "</REQ-IF>",
    ]
    return "\n".join(parts) + "\n"


def identifier(name: str) -> str:
    """A name as an xsd:ID: those of documents and criteria are one, of all others it is the hash."""
    if name.replace("-", "").replace(".", "").isalnum() and name.isascii() and name[0].isalpha():
        return name
    return f"_{hashlib.sha256(name.encode()).hexdigest()[:24]}"


def _header(project: str, changed: str) -> Iterator[str]:
    yield '<THE-HEADER><REQ-IF-HEADER IDENTIFIER="header">'
    yield f"<CREATION-TIME>{changed}</CREATION-TIME>"
    yield "<REQ-IF-TOOL-ID>codegen</REQ-IF-TOOL-ID><REQ-IF-VERSION>1.0</REQ-IF-VERSION>"
    yield f"<SOURCE-TOOL-ID>codegen</SOURCE-TOOL-ID><TITLE>{_text(project)}</TITLE>"
    yield "</REQ-IF-HEADER></THE-HEADER>"


def _object_type(kind: ObjectKind, changed: str) -> Iterator[str]:
    name = kind.name.lower()
    yield f'<SPEC-OBJECT-TYPE IDENTIFIER="{name}" LAST-CHANGE="{changed}" LONG-NAME="{kind}"><SPEC-ATTRIBUTES>'
    for attribute in _ATTRIBUTES[kind]:
        yield from _attribute_type(f"{name}.{attribute}", attribute, changed)
    yield "</SPEC-ATTRIBUTES></SPEC-OBJECT-TYPE>"


def _relation_type(kind: RelationKind, changed: str) -> Iterator[str]:
    name = kind.name.lower()
    yield f'<SPEC-RELATION-TYPE IDENTIFIER="{name}" LAST-CHANGE="{changed}" LONG-NAME="{kind}"><SPEC-ATTRIBUTES>'
    yield from _attribute_type(f"{name}.review", "review", changed)
    yield "</SPEC-ATTRIBUTES></SPEC-RELATION-TYPE>"


def _attribute_type(own: str, attribute: str, changed: str) -> Iterator[str]:
    form = "XHTML" if attribute in _FORMATTED else "STRING"
    yield f'<ATTRIBUTE-DEFINITION-{form} IDENTIFIER="{own}" LAST-CHANGE="{changed}" LONG-NAME="{attribute}"><TYPE>'
    yield f"<DATATYPE-DEFINITION-{form}-REF>{form.lower()}</DATATYPE-DEFINITION-{form}-REF>"
    yield f"</TYPE></ATTRIBUTE-DEFINITION-{form}>"


def _object(each: ExchangeObject, changed: str) -> Iterator[str]:
    own = each.kind.name.lower()
    values = {
        "ReqIF.ForeignID": each.name,
        "ReqIF.ChapterName": each.title,
        "ReqIF.Name": each.title,
        "ReqIF.Text": each.text,
        **dict(each.facts),
    }
    name = quoteattr(_plain(each.title))
    yield f'<SPEC-OBJECT IDENTIFIER="{identifier(each.name)}" LAST-CHANGE="{changed}" LONG-NAME={name}><VALUES>'
    for attribute in _ATTRIBUTES[each.kind]:
        if attribute in values:
            yield _value(f"{own}.{attribute}", attribute, values[attribute])
    yield f"</VALUES><TYPE><SPEC-OBJECT-TYPE-REF>{own}</SPEC-OBJECT-TYPE-REF></TYPE></SPEC-OBJECT>"


def _value(own: str, attribute: str, value: str) -> str:
    if attribute in _FORMATTED:
        content = f"<THE-VALUE><xhtml:div>{_text(value)}</xhtml:div></THE-VALUE>"
        reference = f"<DEFINITION><ATTRIBUTE-DEFINITION-XHTML-REF>{own}</ATTRIBUTE-DEFINITION-XHTML-REF></DEFINITION>"
        return f"<ATTRIBUTE-VALUE-XHTML>{content}{reference}</ATTRIBUTE-VALUE-XHTML>"
    reference = f"<DEFINITION><ATTRIBUTE-DEFINITION-STRING-REF>{own}</ATTRIBUTE-DEFINITION-STRING-REF></DEFINITION>"
    return f"<ATTRIBUTE-VALUE-STRING THE-VALUE={quoteattr(_plain(value))}>{reference}</ATTRIBUTE-VALUE-STRING>"


def _relation(each: Relation, changed: str) -> Iterator[str]:
    own = each.kind.name.lower()
    name = identifier(f"relation {each.source} {each.kind} {each.target}")
    values = f"<VALUES>{_value(f'{own}.review', 'review', 'suspect')}</VALUES>" if each.is_suspect else ""
    yield f'<SPEC-RELATION IDENTIFIER="{name}" LAST-CHANGE="{changed}">{values}'
    for end, target in (("SOURCE", each.source), ("TARGET", each.target)):
        yield f"<{end}><SPEC-OBJECT-REF>{identifier(target)}</SPEC-OBJECT-REF></{end}>"
    yield f"<TYPE><SPEC-RELATION-TYPE-REF>{own}</SPEC-RELATION-TYPE-REF></TYPE></SPEC-RELATION>"


def _specifications(exchange: Exchange, changed: str) -> Iterator[str]:
    """The documents with their criteria, and a list of each kind of what answers to them."""
    parts = {each.source: each.target for each in exchange.relations if each.kind is RelationKind.PART}
    children: dict[str, list[str]] = {}
    for criterion, document in parts.items():
        children.setdefault(document, []).append(criterion)
    documents = [each.name for each in exchange.objects if each.kind is ObjectKind.DOCUMENT]
    hierarchy = (line for name in documents for line in _hierarchy(name, children.get(name, ()), changed))
    yield from _specification("requirements", "Requirements", hierarchy, changed)
    for kind in (ObjectKind.ROW, ObjectKind.SYMBOL, ObjectKind.TEST):
        names = [each.name for each in exchange.objects if each.kind is kind]
        listed = (line for name in names for line in _hierarchy(name, (), changed))
        yield from _specification(f"{kind.name.lower()}s", f"{kind}s", listed, changed)


def _specification(own: str, title: str, hierarchy: Iterable[str], changed: str) -> Iterator[str]:
    yield f'<SPECIFICATION IDENTIFIER="{own}" LAST-CHANGE="{changed}" LONG-NAME="{title}">'
    yield "<TYPE><SPECIFICATION-TYPE-REF>specification</SPECIFICATION-TYPE-REF></TYPE><CHILDREN>"
    yield from hierarchy
    yield "</CHILDREN></SPECIFICATION>"


def _hierarchy(name: str, children: Iterable[str], changed: str) -> Iterator[str]:
    own = identifier(f"place of {name}")
    yield f'<SPEC-HIERARCHY IDENTIFIER="{own}" LAST-CHANGE="{changed}">'
    yield f"<OBJECT><SPEC-OBJECT-REF>{identifier(name)}</SPEC-OBJECT-REF></OBJECT>"
    if children:
        yield "<CHILDREN>"
        for child in children:
            yield from _hierarchy(child, (), changed)
        yield "</CHILDREN>"
    yield "</SPEC-HIERARCHY>"


def _text(value: str) -> str:
    return escape(_plain(value))


def _plain(value: str) -> str:
    """A text without the control characters that XML cannot carry."""
    return "".join(one if one >= " " or one in "\t\n" else " " for one in value)
