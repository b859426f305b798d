"""The common part of all elements of a dialect: required attributes, names, booleans, lifecycle, unknown parts."""

from collections.abc import Set

from codegen.diagnostics import Report, Rule, Severity, did_you_mean
from codegen.frozen import dataclass
from codegen.load.xml_tree import XmlElement, place_of
from codegen.model.dialect.dialect import IN_USE, Lifecycle
from codegen.model.dialect.literals import boolean, is_identifier
from codegen.source import Place

MISSING_ATTRIBUTE = Rule(
    "dialect-missing-attribute",
    "The element lacks an attribute without which it means nothing. Add it.",
)
UNKNOWN_ATTRIBUTE = Rule(
    "dialect-unknown-attribute",
    "MAVLink's schema has no such attribute here, so nobody reads it. Correct its name or remove it.",
    Severity.WARNING,
    remedy="remove it, or take one that MAVLink's schema has here",
)
UNKNOWN_ELEMENT = Rule(
    "dialect-unknown-element",
    "MAVLink's schema has no such element here, so nobody reads it. Correct its name or remove it.",
    Severity.WARNING,
    remedy="remove it, or take one that MAVLink's schema has here",
)
BAD_NAME = Rule(
    "dialect-name",
    "Names of messages, fields, enums and entries become names in code: a letter or underscore, then letters, digits "
    "and underscores, ASCII only.",
    remedy="use letters, digits and _ of ASCII, and no digit at the front",
)
BAD_BOOLEAN = Rule(
    "dialect-boolean",
    "The attribute is an XML boolean: true, false, 1 or 0.",
)

LIFECYCLE = ("wip", "deprecated", "superseded")
"""Elements that say whether a message, an enum or an entry is still to be used."""


@dataclass(frozen=True, slots=True)
class ElementReader:
    """Reads elements of one dialect file (``path``, absolute) and reports what is wrong with them."""

    path: str
    report: Report

    def place(self, element: XmlElement) -> Place:
        """Return where the element opens."""
        return place_of(element, self.path)

    def required(self, element: XmlElement, attribute: str) -> str | None:
        """The text of an attribute that must be there, or None after a diagnostic."""
        text = element.attributes.get(attribute)
        if text is None:
            self.report.add(
                MISSING_ATTRIBUTE,
                self.place(element),
                f"<{element.tag}> has no {attribute}",
                hint=f'write <{element.tag} {attribute}="...">',
            )
        return text

    def name(self, element: XmlElement) -> str | None:
        """The attribute ``name``, or None after a diagnostic if it is missing or no identifier."""
        name = self.required(element, "name")
        if name is None or is_identifier(name):
            return name
        self.report.add(BAD_NAME, self.place(element), f"{name!r} cannot be the name of a {element.tag}")
        return None

    def boolean(self, element: XmlElement, attribute: str) -> bool:
        """An optional XML boolean; False where it is absent, or after a diagnostic."""
        text = element.attributes.get(attribute)
        if text is None:
            return False
        value = boolean(text)
        if value is None:
            self.report.add(BAD_BOOLEAN, self.place(element), f"{attribute} is {text!r}", "write true or false")
            return False
        return value

    def expect(self, element: XmlElement, attributes: Set[str], children: Set[str]) -> None:
        """Warn about attributes and children that MAVLink's schema does not know here (other namespaces are left)."""
        for attribute in () if element.attributes.keys() <= attributes else element.attributes:
            if attribute not in attributes and not attribute.startswith("{"):
                message = f"<{element.tag}> has no attribute {attribute}"
                self.report.add(UNKNOWN_ATTRIBUTE, self.place(element), message, did_you_mean(attribute, attributes))
        for child in element.children:
            if child.tag not in children:
                message = f"<{element.tag}> does not hold <{child.tag}>"
                self.report.add(UNKNOWN_ELEMENT, self.place(child), message, did_you_mean(child.tag, children))

    def description(self, element: XmlElement) -> str:
        """The text of the first ``<description>`` on one line; empty where there is none."""
        for child in element.children:
            if child.tag == "description":
                return one_line(child.text)
        return ""

    def lifecycle(self, element: XmlElement) -> Lifecycle:
        """Return what ``<wip>``, ``<deprecated>`` and ``<superseded>`` say; a missing
        date is an error and reads as ''.
        """
        marks = [child for child in element.children if child.tag in LIFECYCLE]
        if not marks:
            return IN_USE
        since: dict[str, str] = {}
        replaced_by = None
        for mark in marks:
            if mark.tag == "wip":
                self.expect(mark, {"since"}, {"description"})
                continue
            self.expect(mark, {"since", "replaced_by", "remove_on_date"}, {"description"})
            since[mark.tag] = self.required(mark, "since") or ""
            replaced_by = self.required(mark, "replaced_by") or replaced_by
        remarks = (one_line(mark.text) or self.description(mark) for mark in marks)
        return Lifecycle(
            wip=any(mark.tag == "wip" for mark in marks),
            deprecated_since=since.get("deprecated"),
            superseded_since=since.get("superseded"),
            replaced_by=replaced_by,
            remark=" ".join(remark for remark in remarks if remark),
        )


def one_line(text: str) -> str:
    """``text`` with every run of white space, line ends too, made one space."""
    return " ".join(text.split())
