"""Located trees into the records of the model, driven by the model's own type hints (see ``shape``)."""

from difflib import get_close_matches
from typing import Any, Generic, TypeVar

from codegen.decode.scalar import MISSING_VALUE, WRONG_TYPE, Mismatch, found, mismatch, read_scalar, shortened
from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.load.yaml_tree import MappingNode, ScalarNode, SequenceNode, YamlNode
from codegen.model.spec.shape import (
    AnyScalar,
    Group,
    ListOf,
    MappingOf,
    RecordOf,
    ScalarOrList,
    ScalarShape,
    Shape,
    beside,
    chosen_by,
    instead,
    keys_of,
    one_of,
    rest,
    short_forms,
)
from codegen.model.spec.source import OwnSourceSpec
from codegen.source import Place, Written

HINTED = 100
"""Unknown keys of one record for which is looked what was meant."""

UNKNOWN_KEY = Rule(
    "unknown-key",
    "The record has no such key, so what is written there would have no effect. Correct the spelling or remove it.",
    remedy="remove it, or correct its name",
)
MISSING_KEY = Rule(
    "missing-key",
    "A key that the record cannot do without is not written.",
    remedy="write the key, with a value as the schema of the file describes it",
)
EMPTY_MAPPING = Rule("empty-mapping", "A mapping that has to name at least one thing is empty.")
ONE_OF_KEYS = Rule(
    "one-of-keys",
    "Of some keys exactly one is written: a field, for instance, has one source. The message lists those that are "
    "given; keep the right one.",
    remedy="keep one of them, and remove the others",
)

Record = TypeVar("Record", bound=Written)


def decode_record(node: YamlNode, cls: type[Record], report: Report, place: Place | None = None) -> Record | None:
    """The record of class ``cls`` that ``node`` states; ``place`` is its place (default: that of ``node``).

    Every problem of the record and of what it holds is reported. What cannot be decoded is left out: an entry of a
    mapping, an item of a list, a key that has a default. Returns None where the record itself cannot be built.

    ``places`` of the record has, beside each key, the entries of mappings (``facts.battery.cells``) and the
    items of plain lists (``flags[0]``).
    """
    return _RecordDecoder(_chosen(node, cls), report, place or node.place).decode(node)


def _chosen(node: YamlNode, cls: type[Record]) -> type[Record]:
    """The class of the record: that one, or the one that its key ``chosen_by`` chooses."""
    key = chosen_by(cls)
    if key is None or not isinstance(node, MappingNode):
        return cls
    from codegen.sources import SPECS  # noqa: PLC0415  most files have none, and it knows all kinds

    words = [value.text for name, value in node.entries if name.text == key and isinstance(value, ScalarNode)]
    chosen: Any = SPECS.get("".join(words), OwnSourceSpec)
    return chosen  # type: ignore[no-any-return]


class _RecordDecoder(Generic[Record]):
    """Decodes one record."""

    def __init__(self, cls: type[Record], report: Report, place: Place) -> None:
        self._cls = cls
        self._report = report
        self._place = place
        self._keys = {key.name: key for key in keys_of(cls) if key.attribute != rest(cls)}
        self._places: dict[str, Place] = {}

    def decode(self, node: YamlNode) -> Record | None:
        if not isinstance(node, MappingNode):
            return self._short_form(node)
        values: dict[str, Any] = {}
        grouped: dict[Group, dict[str, Any]] = {}
        usable = True
        for written, value_node in node.entries:
            key = self._keys.get(written.text)
            if key is None:
                self._keep(written, value_node, values)
                continue
            self._places[key.name] = value_node.place
            value = self._value(value_node, key.shape, key.name)
            if value is not None:
                into = values if key.group is None else grouped.setdefault(key.group, {})
                into[key.attribute] = value
            elif key.is_required or key.name in one_of(self._cls):
                usable = False
        missing = self._check_keys(node)
        incomplete = [group for group, given in grouped.items() if not self._is_complete(group, given)]
        if missing or incomplete or not usable:
            return None
        for group, given in grouped.items():
            record = group.model(place=self._place, places=self._places, **given)
            values[group.attribute] = (*values.get(group.attribute, ()), record)
        unread = tuple(
            name
            for name, key in self._keys.items()
            if key.group is None and name in self._places and key.attribute not in values
        )
        return self._cls(place=self._place, places=self._places, unread=unread, **values)

    def _is_complete(self, group: Group, given: dict[str, Any]) -> bool:
        """Return whether a group has what it cannot do without; a key of it that is not written is reported."""
        lacking = [key for key in keys_of(group.model) if key.is_required and key.attribute not in given]
        first = next(key.name for key in self._keys.values() if key.group is group and key.attribute in given)
        for key in lacking:
            if key.name not in self._places:  # else its value was no good, which has been said
                hint = f"{key.name}: {key.doc}"
                self._report.add(MISSING_KEY, self._places[first], f"{first} wants {key.name}, which is missing", hint)
        return not lacking

    def _keep(self, key: ScalarNode, node: YamlNode, values: dict[str, Any]) -> None:
        """Keep what stands at a key of the author's choice, where the record takes such."""
        into = rest(self._cls)
        if into is None or key.value is None:
            return
        self._places[f"{into}.{key.text}"] = node.place
        value = self._value(node, AnyScalar(), key.text)
        if value is not None:
            values.setdefault(into, {})[key.text] = value

    def _short_form(self, node: ScalarNode | SequenceNode) -> Record | None:
        forms = short_forms(self._cls)
        if isinstance(node, ScalarNode) and isinstance(node.value, str) and node.value in forms:
            values = forms[node.value]
            return self._cls(place=self._place, places=dict.fromkeys(values, node.place), **values)
        if isinstance(node, ScalarNode) and node.value is None:
            self._report.add(
                MISSING_VALUE,
                node.place,
                "a mapping is wanted here, and nothing is written",
                hint=f"write {{key: value}}; the keys are {', '.join(self._keys)}",
            )
            return None
        words = "".join(f" or {word}" for word in forms)
        near = get_close_matches(node.text, forms, n=1) if isinstance(node, ScalarNode) else []
        hint = f"did you mean {near[0]}?" if near else f"write {{key: value}}; the keys are {', '.join(self._keys)}"
        self._report.add(WRONG_TYPE, node.place, f"a mapping{words} is wanted here, not {found(node)}", hint)
        return None

    def _check_keys(self, node: MappingNode) -> bool:
        """Report unknown, missing and contradicting keys; True if the record cannot be built because of them."""
        written = {key.text: key.place for key, _ in node.entries}
        unknown = [] if rest(self._cls) else [key for key, _ in node.entries if key.text not in self._keys]
        absent_names = [name for name in self._keys if name not in written]
        meant: set[str] = set()
        for index, key in enumerate(unknown):
            if index >= HINTED:  # nobody is shown so many, and to look for what was meant takes long
                self._report.add(UNKNOWN_KEY, key.place, f"unknown key {shortened(key.text)!r}")
                continue
            is_near = bool(get_close_matches(key.text, self._keys, n=1))
            hint = (None if is_near else instead(self._cls)) or did_you_mean(key.text, self._keys)
            if key.text[:1].isdigit():
                hint = "YAML divides at a comma: write a decimal point, such as 5.5"
            self._report.add(UNKNOWN_KEY, key.place, f"unknown key {shortened(key.text)!r}", hint)
            meant.update(get_close_matches(key.text, absent_names, n=1))
        missing = [key for key in self._keys.values() if key.is_required and key.name not in written]
        for absent in missing:
            # A misspelt key is one mistake, not an unknown key and a missing one.
            if absent.name not in meant:
                hint = f"{absent.name}: {absent.doc}"
                self._report.add(MISSING_KEY, self._place, f"{absent.name} is missing", hint)
        contradictory = self._check_one_of(written, meant)
        return bool(missing) or contradictory

    def _check_one_of(self, written: dict[str, Place], meant: set[str]) -> bool:
        choice = one_of(self._cls)
        allowed = {other for name, other in beside(self._cls).items() if name in written}
        given = [name for name in written if name in choice and name not in allowed]
        if not choice or len(given) == 1:
            return False
        if not given and meant.isdisjoint(choice):
            names = ", ".join(choice)
            self._report.add(
                ONE_OF_KEYS,
                self._place,
                f"exactly one of {names} is wanted, and none is given",
                f"write one of {names}",
            )
        if given:
            first, second, *_ = given
            self._report.add(
                ONE_OF_KEYS,
                written[second],
                f"{', '.join(given[:-1])} and {given[-1]} are given, and only one of them can hold",
                related=[(written[first], f"{first} is given here")],
            )
        return True

    def _value(self, node: YamlNode, shape: Shape, path: str) -> Any:
        """The decoded value, or None after a diagnostic (no shape decodes to None)."""
        match shape:
            case RecordOf():
                return decode_record(node, shape.model, self._report)
            case MappingOf():
                return self._mapping(node, shape, path)
            case ListOf():
                return self._list(node, shape, path)
            case ScalarOrList():
                if isinstance(node, ScalarNode):
                    return self._scalar(node, shape.scalar, path)
                return self._list(node, shape.items, path)
            case _:
                return self._scalar(node, shape, path)

    def _scalar(self, node: YamlNode, shape: ScalarShape, path: str) -> Any:
        value = read_scalar(node, shape) if isinstance(node, ScalarNode) else mismatch(node, shape)
        if isinstance(value, Mismatch):
            self._say(node, value, path)
            return None
        return value

    def _mapping(self, node: YamlNode, shape: MappingOf, path: str) -> dict[str, Any] | None:
        if not isinstance(node, MappingNode):
            self._wrong_collection(node, shape, path)
            return None
        if not node.entries and not shape.may_be_empty:
            self._report.add(
                EMPTY_MAPPING,
                node.place,
                f"{path} is empty",
                hint="write at least one entry below it, or remove it where it may be left out",
            )
            return None
        entries: dict[str, Any] = {}
        for name, value_node in node.entries:
            if name.value is None or not name.text:
                self._report.add(
                    WRONG_TYPE, name.place, f"an entry of {path} has no name", hint="write a name in front of the colon"
                )
                continue
            self._places[f"{path}.{name.text}"] = value_node.place
            if isinstance(shape.value, RecordOf):
                value = decode_record(value_node, shape.value.model, self._report, name.place)
            else:
                value = self._value(value_node, shape.value, f"{path}.{name.text}")
            if value is not None:
                entries[name.text] = value
        return entries

    def _list(self, node: YamlNode, shape: ListOf, path: str) -> tuple[Any, ...] | None:
        if not isinstance(node, SequenceNode):
            self._wrong_collection(node, shape, path)
            return None
        items = []
        for index, item_node in enumerate(node.items):
            if not isinstance(shape.item, RecordOf):
                self._places[f"{path}[{index}]"] = item_node.place
            value = self._value(item_node, shape.item, f"{path}[{index}]")
            if value is not None:
                items.append(value)
        return tuple(items)

    def _wrong_collection(self, node: YamlNode, shape: MappingOf | ListOf, path: str) -> None:
        if isinstance(node, ScalarNode) and node.value is None:
            hint = "write [] for an empty list" if isinstance(shape, ListOf) else None
            self._say(node, Mismatch(MISSING_VALUE, "has no value", hint), path)
            return
        hint = f"write [{node.text}]" if isinstance(shape, ListOf) and isinstance(node, ScalarNode) else None
        self._say(node, mismatch(node, shape, hint), path)

    def _say(self, node: YamlNode, problem: Mismatch, path: str) -> None:
        self._report.add(problem.rule, node.place, f"{path} {problem.message}", problem.hint)
