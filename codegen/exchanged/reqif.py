"""ReqIF as another tool has written it: the objects of its specifications, in the order of their hierarchies."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence

from codegen.diagnostics import Report, Rule, Severity, shortened_list
from codegen.exchanged.stated import UNREADABLE_TEXT, Formatted, Stated, StatedFile
from codegen.exchanged.xhtml import formatted
from codegen.frozen import dataclass
from codegen.load.files import DISK
from codegen.load.xml_tree import MixedElement, place_of, read_mixed_xml
from codegen.source import Place

REQIF_FORMAT = Rule(
    "reqif-format",
    "A file that ends with .reqif is XML with <REQ-IF> at its root and a <CORE-CONTENT> in it; one that ends with "
    ".reqifz is an archive, of which the .reqif inside is wanted.",
    unreadable=True,
    remedy="give XML with <REQ-IF> at its root, or a .reqifz with a .reqif in it",
)
REQIF_REFERENCE = Rule(
    "reqif-reference",
    "Something in a ReqIF file refers to an object, a type or an attribute that the file does not have, or two have "
    "one identifier. Export the file again, with all that it refers to.",
    remedy="export the file again, with all that it refers to",
)
REQIF_ATTRIBUTE = Rule(
    "reqif-attribute",
    "No object of a ReqIF file has an attribute with texts of requirements, as ReqIF.Text is called by convention. "
    "--text, --heading and --id name the attributes that the file has for texts, headings and ids.",
)
REQIF_SPECIFICATION = Rule(
    "reqif-specification",
    "A ReqIF file has no specification of the name that --specification gives, or several. A file can have several "
    "specifications, such as the modules of DOORS, which number their objects each for itself: one can be imported by "
    "its LONG-NAME or IDENTIFIER, with a --prefix of its own.",
)
REQIF_TWICE = Rule(
    "reqif-twice",
    "An object stands twice in the hierarchies of a ReqIF file; it is imported where it stands first.",
    Severity.WARNING,
    remedy="leave it in one place of the hierarchy where it was written",
)

MAX_BYTES = 50_000_000
"""Largest file that is read, in bytes: some ten times what 10,000 requirements take."""

FACTS = ("status", "aliases", "refers_to", "bench")
"""Attributes beyond the convention that the export of a trace has, in any case of letters."""


@dataclass(frozen=True, slots=True)
class Attributes:
    """The names in a file of the attributes with texts, headings, names and ids; and of the one ``specification`` that
    is read, by LONG-NAME or IDENTIFIER: without one, all are.
    """

    text: str = "ReqIF.Text"
    heading: str = "ReqIF.ChapterName"
    name: str = "ReqIF.Name"
    id: str = "ReqIF.ForeignID"
    specification: str | None = None


@dataclass(frozen=True, slots=True)
class _Object:
    element: MixedElement
    kind: str
    values: Mapping[str, MixedElement | str]


def read_reqif(path: str, attributes: Attributes, report: Report) -> StatedFile | None:
    """Return what a file states; None, after a finding, where it is no ReqIF."""
    root = read_mixed_xml(path, DISK, report, MAX_BYTES)
    if root is None:
        return None
    content = _only(_only(root, "CORE-CONTENT"), "REQ-IF-CONTENT")
    if root.tag != "REQ-IF" or content is None:
        report.add(REQIF_FORMAT, place_of(root, path), f"<{root.tag}> is not what ReqIF begins with")
        return None
    return _Reader(content, path, attributes, report).file()


class _Reader:
    """Looks up what the parts of one file refer to."""

    def __init__(self, content: MixedElement, path: str, attributes: Attributes, report: Report) -> None:
        self._content = content
        self._path = path
        self._attributes = attributes
        self._report = report
        self._named = {
            each.attributes["IDENTIFIER"]: each.attributes.get("LONG-NAME", "")
            for part in ("DATATYPES", "SPEC-TYPES")
            for each in _all(_only(content, part))
            if "IDENTIFIER" in each.attributes
        }
        self._objects = dict(self._read_objects())

    def file(self) -> StatedFile:
        """The objects of the hierarchies, and how many there are of what is not imported."""
        depends_on, relations = self._relations()
        placed = self._placed()
        stated = [self._stated(key, parent, depends_on.get(key, ())) for key, parent in placed.items()]
        kept = [each for each in stated if _says_something(each)]
        if placed or self._attributes.specification is None:
            self._check_texts(stated)
        left_out = Counter(self._objects[each.key].kind or "object" for each in stated if not _says_something(each))
        elsewhere = Counter(each.kind or "object" for key, each in self._objects.items() if key not in placed)
        return StatedFile(tuple(kept), {**(left_out + elsewhere), **relations})

    def _check_texts(self, stated: Sequence[Stated]) -> None:
        if any(each.text or each.is_broken for each in stated):
            return
        names = sorted({name for each in self._objects.values() for name in each.values})
        hint = f"its attributes are {shortened_list(names)}" if names else "its objects have no attributes"
        message = f"no object has an attribute {self._attributes.text}"
        self._report.add(REQIF_ATTRIBUTE, self._at(self._content), message, f"{hint}: --text NAME")

    def _read_objects(self) -> Iterator[tuple[str, _Object]]:
        known: dict[str, MixedElement] = {}
        for each in _children(_only(self._content, "SPEC-OBJECTS")):
            key = each.attributes.get("IDENTIFIER", "")
            if not key or key in known:
                what = f"another object is called {key}" if key else "an object has no IDENTIFIER"
                self._report.add(REQIF_REFERENCE, self._at(each), what)
                continue
            known[key] = each
            kind = self._named.get(_reference(_only(each, "TYPE")), "")
            yield key, _Object(each, kind, dict(self._values(each)))

    def _values(self, element: MixedElement) -> Iterator[tuple[str, MixedElement | str]]:
        for value in _children(_only(element, "VALUES")):
            name = self._named.get(_reference(_only(value, "DEFINITION")))
            if name is None:
                self._report.add(REQIF_REFERENCE, self._at(value), "the file has no such attribute definition")
                continue
            content = _only(value, "THE-VALUE")
            if content is not None:
                yield name, self._original(value, content)
            elif value.tag.endswith("ENUMERATION"):
                chosen = [_all_text(each) for each in _children(_only(value, "VALUES"))]
                yield name, ", ".join(self._named.get(each, each) for each in chosen)
            else:
                yield name, value.attributes.get("THE-VALUE", "")

    def _original(self, value: MixedElement, content: MixedElement) -> MixedElement:
        """Return a text as it was written first: a tool that cannot show its form leaves that beside a simpler one."""
        if value.attributes.get("IS-SIMPLIFIED", "").strip() not in ("true", "1"):
            return content
        original = _only(value, "THE-ORIGINAL-VALUE")
        if original is None or _plain(original) != _plain(content):
            message = "a tool has simplified this text, and what it was before is not there, or says otherwise"
            self._report.add(UNREADABLE_TEXT, self._at(content), message, "export it from where it was written")
        return content if original is None else original

    def _placed(self) -> dict[str, str | None]:
        """The objects that stand in hierarchies with the one that each stands below."""
        placed: dict[str, str | None] = {}
        for specification in self._chosen():
            waiting = [(each, None) for each in reversed(_children(_only(specification, "CHILDREN")))]
            todo: list[tuple[MixedElement, str | None]] = list(waiting)
            while todo:
                each, parent = todo.pop()
                key = _reference(_only(each, "OBJECT"))
                if key not in self._objects:
                    self._report.add(REQIF_REFERENCE, self._at(each), f"the file has no object {key or 'for it'}")
                elif key in placed:
                    self._report.add(REQIF_TWICE, self._at(each), f"{key} stands in a hierarchy before")
                else:
                    placed[key] = parent
                below = key if key in self._objects else parent
                todo += [(child, below) for child in reversed(_children(_only(each, "CHILDREN")))]
        return placed

    def _chosen(self) -> Sequence[MixedElement]:
        """Return the specifications that are read: all, or after a finding none."""
        known = _children(_only(self._content, "SPECIFICATIONS"))
        wanted = self._attributes.specification
        if wanted is None:
            return known
        found = [each for each in known if wanted in map(each.attributes.get, ("LONG-NAME", "IDENTIFIER"))]
        if len(found) != 1:
            names = [each.attributes.get("LONG-NAME") or each.attributes.get("IDENTIFIER", "") for each in known]
            what = f"{len(found)} specifications are called" if found else "no specification is called"
            hint = (
                f"name one of {shortened_list(sorted(names))}, or its IDENTIFIER" if names else "leave the option out"
            )
            self._report.add(REQIF_SPECIFICATION, self._at(self._content), f"{what} {wanted}", hint)
            return ()
        return found

    def _relations(self) -> tuple[dict[str, tuple[str, ...]], dict[str, int]]:
        """Return what depends on what, by keys; and how many relations there are of other types."""
        depends_on: dict[str, dict[str, None]] = {}
        others: Counter[str] = Counter()
        for each in _children(_only(self._content, "SPEC-RELATIONS")):
            source, target = (_reference(_only(each, end)) for end in ("SOURCE", "TARGET"))
            kind = self._named.get(_reference(_only(each, "TYPE")), "")
            for key in (source, target):
                if key not in self._objects:
                    self._report.add(REQIF_REFERENCE, self._at(each), f"the file has no object {key or 'for an end'}")
            if "".join(filter(str.isalpha, kind)).lower() == "dependson":
                depends_on.setdefault(source, {})[target] = None
            else:
                others[f"relation {kind!r}" if kind else "relation"] += 1
        return {source: tuple(targets) for source, targets in depends_on.items()}, others

    def _stated(self, key: str, parent: str | None, depends_on: tuple[str, ...]) -> Stated:
        found = self._objects[key]
        text = self._formatted(found, self._attributes.text)
        heading = self._formatted(found, self._attributes.heading) or self._formatted(found, self._attributes.name)
        is_requirement = self._attributes.text in found.values
        has_heading = self._attributes.heading in found.values
        title = heading.plain if heading and (is_requirement or has_heading) else ""
        told = {name: self._said(found, name) for name in found.values if name.lower() in FACTS}
        facts = {name.lower(): said or "" for name, said in told.items()}
        return Stated(
            key=key,
            name=self._said(found, self._attributes.id) or "",
            title=title,
            text=text if text and text.plain else None,
            is_broken=is_requirement and (text is None or None in told.values()),
            parent=parent,
            depends_on=depends_on,
            facts=facts,
            place=self._at(found.element),
        )

    def _said(self, found: _Object, attribute: str) -> str | None:
        """Return what a short attribute says; None, after a finding, where its marks would say otherwise."""
        value = found.values.get(attribute, "")
        if isinstance(value, str):
            return " ".join(value.split())
        read = formatted(value, self._path, self._report)
        return None if read is None else read.plain

    def _formatted(self, found: _Object, attribute: str) -> Formatted | None:
        value = found.values.get(attribute)
        if value is None:
            return None
        element = value if isinstance(value, MixedElement) else found.element._replace(content=(value,))
        return formatted(element, self._path, self._report)

    def _at(self, element: MixedElement) -> Place:
        return place_of(element, self._path)


def _says_something(each: Stated) -> bool:
    """Return whether an object is a requirement or a heading."""
    return each.text is not None or each.is_broken or bool(each.title)


def _plain(value: MixedElement | str) -> str:
    return " ".join((value if isinstance(value, str) else _all_text(value)).split())


def _only(element: MixedElement | None, tag: str) -> MixedElement | None:
    """The child of that name; None without one."""
    return next((each for each in _children(element) if each.tag == tag), None)


def _children(element: MixedElement | None) -> tuple[MixedElement, ...]:
    return () if element is None else element.children


def _all(element: MixedElement | None) -> Iterable[MixedElement]:
    """Every element below one."""
    for each in _children(element):
        yield each
        yield from _all(each)


def _reference(element: MixedElement | None) -> str:
    """Return what the one reference in an element refers to, or nothing."""
    children = _children(element)
    return _all_text(children[0]) if children else ""


def _all_text(element: MixedElement) -> str:
    return "".join(each if isinstance(each, str) else _all_text(each) for each in element.content).strip()
