"""Frozen dataclasses that are made sooner: what only some programs ask of them is made when it is asked for.

The decorator of the standard library describes each class and compiles six methods of it while its module is imported.
Codegen has hundreds of these classes; a run makes objects of some of them and compares still fewer, and half of the
time that its imports took went into descriptions and methods that nobody asked for.
"""

import dataclasses
from collections.abc import Callable
from dataclasses import MISSING, Field, FrozenInstanceError
from functools import cache
from operator import attrgetter
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple, TypeVar, cast

_Class = TypeVar("_Class")

if TYPE_CHECKING:
    from dataclasses import dataclass
else:

    def dataclass(*, frozen: bool, slots: bool, kw_only: bool = False) -> Callable[[_Class], _Class]:
        """Return the decorator of the standard library for classes that are frozen and have slots."""
        if not (frozen and slots):
            raise TypeError("a class whose objects change is a dataclass of the standard library")

        def frozen_class(cls: _Class) -> _Class:
            return _frozen(cls, kw_only)

        return frozen_class


__all__ = ["dataclass"]

_FEW = 12
"""So many objects are made before it pays to compile how."""

_DESCRIPTION = ("__dataclass_fields__", "__dataclass_params__", "__match_args__")
"""Attributes of a class in which the standard library keeps its findings about it."""


class _Slot(NamedTuple):
    """A field as far as objects need it: ``constant`` is its default, or ``factory`` makes one."""

    name: str
    put: Callable[[Any, Any], None]
    constant: Any
    factory: Any
    is_named: bool
    is_compared: bool
    is_shown: bool


_own_slots: dict[type, list[_Slot]] = {}


def _frozen(written: Any, kw_only: bool) -> Any:
    """A class as it is written, with slots for its fields and with the methods of a frozen dataclass.

    A method that it has itself stays.
    """
    left = _FEW

    def __init__(self: Any, *values: Any, **named: Any) -> None:  # noqa: N807
        nonlocal left
        left -= 1
        if left < 0 or not _is_filled(cls, self, values, named):
            cls.__init__ = _initializer(cls)
            cls.__init__(self, *values, **named)

    names = [name for name, kind in written.__annotations__.items() if not _is_of_class(kind)]
    has = vars(written)
    parts = {"__init__": __init__, **_METHODS, **has, "__slots__": tuple(names)}
    for name in (*names, "__dict__", "__weakref__"):
        parts.pop(name, None)
    cls: Any = type(written)(written.__name__, written.__bases__, parts)
    cls.__qualname__ = written.__qualname__
    _own_slots[cls] = [_slot(cls, name, has.get(name, MISSING), kw_only) for name in names]
    for name in _DESCRIPTION:
        setattr(cls, name, _Described(name, cls, written, kw_only))
    return cls


def _is_of_class(kind: object) -> bool:
    return getattr(kind, "__origin__", kind) is ClassVar


def _slot(cls: Any, name: str, written: Any, kw_only: bool) -> _Slot:
    """A field; ``written`` is what the class says of it beside its type."""
    put = getattr(cls, name).__set__
    if not isinstance(written, Field):
        return _Slot(name, put, written, MISSING, kw_only, True, True)
    is_named = kw_only if written.kw_only is MISSING else written.kw_only
    return _Slot(name, put, written.default, written.default_factory, is_named, written.compare, written.repr)


class _Described:
    """An attribute that describes the class: the standard library is asked once somebody asks for it."""

    def __init__(self, name: str, *of: Any) -> None:
        self.name, self.of = name, of

    def __get__(self, _: object, _owner: object) -> object:
        """The attribute, which then takes the place of this one, as do the others."""
        cls, written, kw_only = self.of
        dataclasses.dataclass(kw_only=kw_only, init=False, repr=False, eq=False)(written)
        for name in _DESCRIPTION:
            setattr(cls, name, getattr(written, name))
        return getattr(cls, self.name)


@cache
def _slots(cls: Any) -> list[_Slot]:
    """The fields of a class, those of its bases first."""
    found = {slot.name: slot for base in reversed(cls.__mro__) for slot in _own_slots.get(base, ())}
    return list(found.values())


def _is_filled(cls: Any, made: object, values: tuple[Any, ...], named: dict[str, Any]) -> bool:
    """Return whether the arguments are those of the class; then they are in the slots of the object.

    Any others are left to the function that is compiled, which says what is wrong with them.
    """
    slots = _slots(cls)
    if len(values) > len(slots):
        return False
    taken = 0
    for index, (name, put, constant, factory, is_named, _, _) in enumerate(slots):
        if index < len(values) and not is_named and name not in named:
            put(made, values[index])
        elif index >= len(values) and name in named:
            put(made, named[name])
            taken += 1
        elif index >= len(values) and factory is not MISSING:
            put(made, factory())
        elif index >= len(values) and constant is not MISSING:
            put(made, constant)
        else:
            return False
    return taken == len(named)


def _initializer(cls: Any) -> Callable[..., None]:
    """``__init__`` of a class: each argument goes to the slot of its name."""
    names: dict[str, object] = {"_MISSING": MISSING}
    positional, named, body = ["self"], list[str](), list[str]()
    for slot in _slots(cls):
        argument = name = value = slot.name
        names[f"_set_{name}"] = slot.put
        if slot.factory is not MISSING:
            names[f"_new_{name}"] = slot.factory
            argument, value = f"{name}=_MISSING", f"_new_{name}() if {name} is _MISSING else {name}"
        elif slot.constant is not MISSING:
            names[f"_default_{name}"] = slot.constant
            argument = f"{name}=_default_{name}"
        (named if slot.is_named else positional).append(argument)
        body.append(f"    _set_{name}(self, {value})")
    arguments = ", ".join([*positional, *(["*", *named] if named else [])])
    text = "\n".join([f"def __init__({arguments}):", *(body or ["    pass"])])
    exec(text, names)  # noqa: S102  as dataclasses does: the names are those of the fields
    return cast(Callable[..., None], names["__init__"])


@cache
def _compared(cls: Any) -> Callable[[Any], object]:
    """The values by which objects of a class are compared."""
    return _getter([slot.name for slot in _slots(cls) if slot.is_compared])


@cache
def _all(cls: Any) -> Callable[[Any], object]:
    return _getter([slot.name for slot in _slots(cls)])


def _getter(names: list[str]) -> Callable[[Any], object]:
    if len(names) == 1:
        return lambda one: (getattr(one, names[0]),)
    return attrgetter(*names) if names else lambda _: ()


def _eq(self: Any, other: Any) -> Any:
    if other.__class__ is not self.__class__:
        return NotImplemented
    values = _compared(self.__class__)
    return values(self) == values(other)


def _hash(self: Any) -> int:
    return hash(_compared(self.__class__)(self))


def _repr(self: Any) -> str:
    shown = (f"{slot.name}={getattr(self, slot.name)!r}" for slot in _slots(self.__class__) if slot.is_shown)
    return f"{self.__class__.__qualname__}({', '.join(shown)})"


def _refuse_to_set(_self: Any, name: str, _value: object) -> None:
    raise FrozenInstanceError(f"cannot assign to field {name!r}")


def _refuse_to_delete(_self: Any, name: str) -> None:
    raise FrozenInstanceError(f"cannot delete field {name!r}")


def _state(self: Any) -> object:
    return _all(self.__class__)(self)


@cache
def _setters(cls: Any) -> list[Callable[[Any, Any], None]]:
    return [slot.put for slot in _slots(cls)]


def _restore(self: Any, state: tuple[object, ...]) -> None:
    for put, value in zip(_setters(self.__class__), state, strict=True):
        put(self, value)


_METHODS = {
    "__repr__": _repr,
    "__eq__": _eq,
    "__hash__": _hash,
    "__setattr__": _refuse_to_set,
    "__delattr__": _refuse_to_delete,
    "__getstate__": _state,
    "__setstate__": _restore,
}
