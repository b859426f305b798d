"""The classes of records and views are those of the standard library's frozen dataclasses, made later."""

import copy
import dataclasses
import pickle
from dataclasses import FrozenInstanceError, field, fields, replace
from typing import Any, ClassVar

import pytest

from codegen.findings.catalogue import rule_catalogue
from codegen.frozen import _FEW, _own_slots, _slots, dataclass


@dataclass(frozen=True, slots=True)
class Base:
    """With a default, and a value that does not count."""

    name: str
    size: int = 3
    place: str = field(default="", compare=False, repr=False)
    parts: list[str] = field(default_factory=list)


@dataclass(frozen=True, slots=True, kw_only=True)
class Named(Base):
    """Of which the new field is always named."""

    unit: str

    def __str__(self) -> str:
        return f"{self.size} {self.unit}"


@dataclass(frozen=True, slots=True)
class Empty:
    """Without fields."""


@dataclasses.dataclass(frozen=True, slots=True)
class StandardBase:
    name: str
    size: int = 3
    place: str = field(default="", compare=False, repr=False)
    parts: list[str] = field(default_factory=list)


@dataclasses.dataclass(frozen=True, slots=True, kw_only=True)
class StandardNamed(StandardBase):
    unit: str

    def __str__(self) -> str:
        return f"{self.size} {self.unit}"


ROUNDS = (0, _FEW + 1)
"""The first objects are made in another way than those that follow."""


def made(cls: Any, before: int, *values: object, **named: object) -> Any:
    """An object of a class, after so many others."""
    for _ in range(before):
        cls(*values, **named)
    return cls(*values, **named)


def fresh() -> Any:
    @dataclass(frozen=True, slots=True)
    class Fresh(Base):
        other: int = 7

    return Fresh


@pytest.mark.parametrize("before", ROUNDS)
@pytest.mark.parametrize(
    ("values", "named"),
    [
        (("a",), {}),
        (("a", 4), {}),
        (("a",), {"parts": ["b"]}),
        ((), {"name": "a", "other": 1}),
        (("a", 1, "b", [], 2), {}),
    ],
)
def test_arguments_find_their_fields(before: int, values: tuple[object, ...], named: dict[str, object]) -> None:
    @dataclasses.dataclass(frozen=True, slots=True)
    class Standard(StandardBase):
        other: int = 7

    found, expected = made(fresh(), before, *values, **named), Standard(*values, **named)  # type: ignore[arg-type]
    assert [getattr(found, each.name) for each in fields(found)] == list(dataclasses.astuple(expected))


@pytest.mark.parametrize("before", ROUNDS)
@pytest.mark.parametrize(
    ("values", "named"), [((), {}), (("a",), {"name": "b"}), (("a",), {"new": 1}), (("a", 1, "", [], 2, 3), {})]
)
def test_wrong_arguments_are_refused(before: int, values: tuple[object, ...], named: dict[str, object]) -> None:
    cls = fresh()
    made(cls, before, "a")
    with pytest.raises(TypeError, match="argument"):
        cls(*values, **named)


def test_a_field_that_is_named_is_not_taken_by_its_position() -> None:
    with pytest.raises(TypeError):
        Named("a", 1, "", [], "V")  # type: ignore[call-arg,misc]
    assert str(Named("a", 1, unit="V")) == str(StandardNamed("a", 1, unit="V")) == "1 V"


def test_each_object_has_a_default_of_its_own() -> None:
    for _ in range(_FEW + 2):
        assert Base("a").parts is not Base("a").parts


def test_what_counts_is_compared_and_shown() -> None:
    assert Base("a", place="here") == Base("a", place="there")
    assert Base("a") != Base("b")
    assert Base("a") != StandardBase("a")
    assert Empty() == Empty()
    assert hash(replace(Named("a", unit="V"), parts=())) == hash(replace(Named("a", unit="V"), parts=()))  # type: ignore[arg-type]
    with pytest.raises(TypeError):
        hash(Base("a"))  # of a list
    assert repr(Base("a", place="here")) == repr(StandardBase("a", place="here")).replace("Standard", "")


def test_nothing_can_be_changed() -> None:
    for one in (Base("a"), Named("a", unit="V")):
        with pytest.raises(FrozenInstanceError):
            one.name = "b"  # type: ignore[misc]
        with pytest.raises(FrozenInstanceError):
            del one.name  # type: ignore[misc]
        with pytest.raises(FrozenInstanceError):
            one.other = 1  # type: ignore[union-attr]


@pytest.mark.parametrize("one", [Base("a", 2, "here", ["b"]), Named("a", unit="V"), Empty()])
def test_copies_are_whole(one: Any) -> None:
    names = [each.name for each in fields(one)]
    unpickled = pickle.loads(pickle.dumps(one))  # noqa: S301
    for other in (unpickled, copy.copy(one), copy.deepcopy(one), replace(one)):
        assert type(other) is type(one)
        assert [getattr(other, name) for name in names] == [getattr(one, name) for name in names]


def test_the_standard_library_describes_them() -> None:
    for one, standard in ((Base, StandardBase), (Named, StandardNamed)):
        for found, expected in zip(fields(one), fields(standard), strict=True):
            for name in ("name", "type", "default", "default_factory", "compare", "repr", "init", "kw_only"):
                assert getattr(found, name) == getattr(expected, name)
        assert not hasattr(one("a", **({"unit": "V"} if one is Named else {})), "__dict__")


def test_what_belongs_to_the_class_is_no_field() -> None:
    @dataclass(frozen=True, slots=True)
    class Counted:
        MOST: ClassVar[int] = 3
        name: str

    assert [each.name for each in fields(Counted)] == ["name"]
    assert (Counted("a").MOST, Counted.MOST) == (3, 3)


@pytest.mark.parametrize("before", ROUNDS)
def test_a_field_that_is_written_again_stays_in_its_place(before: int) -> None:
    @dataclass(frozen=True, slots=True)
    class Larger(Base):
        size: int = 9

    @dataclasses.dataclass(frozen=True, slots=True)
    class Standard(StandardBase):
        size: int = 9

    assert dataclasses.astuple(made(Larger, before, "a")) == dataclasses.astuple(Standard("a"))
    assert replace(made(Larger, before, "a"), size=1).size == 1


def test_every_class_has_slots_for_the_fields_that_the_standard_library_finds() -> None:
    rule_catalogue()  # imports all of codegen
    for cls, slots in _own_slots.items():
        own = {each.name for each in fields(cls)} - {
            each.name for base in cls.__bases__ if dataclasses.is_dataclass(base) for each in fields(base)
        }
        assert own <= {slot.name for slot in slots}, cls
        assert [slot.name for slot in _slots(cls)] == [each.name for each in fields(cls)], cls


def test_patterns_take_values_by_position() -> None:
    assert Base.__match_args__ == StandardBase.__match_args__  # type: ignore[attr-defined]
