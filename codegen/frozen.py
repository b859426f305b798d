"""Frozen dataclasses that are made sooner: what only some programs ask of them is compiled when it is asked for.

The decorator of the standard library compiles six methods of each class while its module is imported. Codegen has
hundreds of these classes; a run makes objects of some of them and compares still fewer, and half of the time that its
imports took went into methods that nobody called.
"""

import dataclasses
from collections.abc import Callable
from dataclasses import MISSING, Field, FrozenInstanceError
from functools import cache, partial
from operator import attrgetter
from typing import TYPE_CHECKING, Any, TypeVar, cast

_Class = TypeVar("_Class")

if TYPE_CHECKING:
    from dataclasses import dataclass
else:

    def dataclass(*, frozen: bool, slots: bool, kw_only: bool = False) -> Callable[[_Class], _Class]:
        """As the decorator of the standard library, for classes that are frozen and have slots."""
        if not (frozen and slots):
            raise TypeError("a class whose objects change is a dataclass of the standard library")

        def frozen_class(cls: _Class) -> _Class:
            return _frozen(dataclasses.dataclass(slots=True, kw_only=kw_only, init=False, repr=False, eq=False)(cls))

        return frozen_class


__all__ = ["dataclass"]

_FEW = 12
"""So many objects are made before it pays to compile how."""


def _frozen(cls: Any) -> Any:
    """The class, of which only the fields are known so far, with the methods of a frozen dataclass.

    One that the class has itself stays.
    """

    left = _FEW

    def __init__(self: Any, *values: Any, **named: Any) -> None:  # noqa: N807
        nonlocal left
        left -= 1
        if left < 0 or not _is_filled(cls, self, values, named):
            cls.__init__ = _initializer(cls)
            cls.__init__(self, *values, **named)

    for name, method in {"__init__": __init__, **_METHODS}.items():
        if name not in vars(cls):
            setattr(cls, name, method)
    return cls


def _is_filled(cls: Any, made: object, values: tuple[Any, ...], named: dict[str, Any]) -> bool:
    """Whether the arguments are those of the class; then they are in the slots of the object.

    Any others are left to the function that is compiled, which says what is wrong with them.
    """
    slots = _slots(cls)
    if len(values) > len(slots):
        return False
    taken = 0
    for index, (name, put, default, is_named) in enumerate(slots):
        if index < len(values) and not is_named and name not in named:
            put(made, values[index])
        elif index >= len(values) and name in named:
            put(made, named[name])
            taken += 1
        elif index >= len(values) and default is not None:
            put(made, default())
        else:
            return False
    return taken == len(named)


@cache
def _slots(cls: Any) -> list[tuple[str, Callable[[Any, Any], None], Callable[[], Any] | None, bool]]:
    """Name, setter, what makes the default if there is one, and whether it has to be named, of each field."""
    found: list[tuple[str, Callable[[Any, Any], None], Callable[[], Any] | None, bool]] = []
    for field in dataclasses.fields(cls):
        default: Any = None
        if field.default_factory is not MISSING:
            default = field.default_factory
        elif field.default is not MISSING:
            default = partial(_same, field.default)
        found.append((field.name, getattr(cls, field.name).__set__, default, field.kw_only is True))
    return found


def _same(value: object) -> object:
    return value


def _initializer(cls: type[Any]) -> Callable[..., None]:
    """``__init__`` of a class: each argument goes to the slot of its name."""
    names: dict[str, object] = {"_MISSING": MISSING}
    positional, named, body = ["self"], list[str](), list[str]()
    for field in dataclasses.fields(cls):
        name = field.name
        names[f"_set_{name}"] = getattr(cls, name).__set__
        value = name
        if field.default_factory is not MISSING:
            names[f"_new_{name}"] = field.default_factory
            value = f"_new_{name}() if {name} is _MISSING else {name}"
        elif field.default is not MISSING:
            names[f"_default_{name}"] = field.default
        (named if field.kw_only else positional).append(name + _default(field))
        body.append(f"    _set_{name}(self, {value})")
    arguments = ", ".join([*positional, *(["*", *named] if named else [])])
    text = "\n".join([f"def __init__({arguments}):", *(body or ["    pass"])])
    exec(text, names)  # noqa: S102  as dataclasses does: the names are those of the fields
    return cast(Callable[..., None], names["__init__"])


def _default(field: "Field[Any]") -> str:
    """The default of an argument as the text of the function has it."""
    if field.default_factory is not MISSING:
        return "=_MISSING"
    return "" if field.default is MISSING else f"=_default_{field.name}"


@cache
def _compared(cls: type[Any]) -> Callable[[Any], object]:
    """The values by which objects of a class are compared."""
    names = [field.name for field in dataclasses.fields(cls) if field.compare]
    return attrgetter(*names) if names else lambda _: ()


@cache
def _setters(cls: type[Any]) -> tuple[Callable[[Any, Any], None], ...]:
    return tuple(getattr(cls, field.name).__set__ for field in dataclasses.fields(cls))


def _eq(self: Any, other: Any) -> Any:
    if other.__class__ is not self.__class__:
        return NotImplemented
    values = _compared(self.__class__)
    return values(self) == values(other)


def _hash(self: Any) -> int:
    return hash(_compared(self.__class__)(self))


def _repr(self: Any) -> str:
    shown = (f"{field.name}={getattr(self, field.name)!r}" for field in dataclasses.fields(self) if field.repr)
    return f"{self.__class__.__qualname__}({', '.join(shown)})"


def _refuse_to_set(_self: Any, name: str, _value: object) -> None:
    raise FrozenInstanceError(f"cannot assign to field {name!r}")


def _refuse_to_delete(_self: Any, name: str) -> None:
    raise FrozenInstanceError(f"cannot delete field {name!r}")


def _state(self: Any) -> list[object]:
    return [getattr(self, field.name) for field in dataclasses.fields(self)]


def _restore(self: Any, state: list[object]) -> None:
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
