"""Arguments that nobody gives by name have short names in compiled modules."""

import pytest

from codegen.emit.argument_names import with_short_arguments


def changed(text: str, *others: str) -> bool:
    return with_short_arguments({"one": text}, others)["one"] != text


def test_functions_share_short_names() -> None:
    """Those within others have them as well, attributes and texts keep theirs."""
    text = """\
def told(self, speed, limit=2):
    # speed
    def inner(speed=speed):
        return self.speed + speed
    return inner, f"{speed:{limit}} {self.limit}", lambda limit: limit, "speed"


class One:
    def put(self, value):
        self.value = value
"""
    made = """\
def told(self, _1, _0=2):
    # speed
    def inner(_1=_1):
        return self.speed + _1
    return inner, f"{_1:{_0}} {self.limit}", lambda _0: _0, "speed"


class One:
    def put(self, _0):
        self.value = _0
"""
    assert with_short_arguments({"one": text}, [])["one"] == made


def test_a_short_name_is_none_that_the_function_has() -> None:
    text = "def told(value):\n    _0 = _1(value)\n    return _0\n"
    assert with_short_arguments({"one": text}, [])["one"] == "def told(_2):\n    _0 = _1(_2)\n    return _0\n"


@pytest.mark.parametrize(
    ("text", "other"),
    [
        ("def told(value):\n    return value\n\nprint(told(value=1))\n", ""),
        ("def told(value):\n    return value\n", "from one import told\ntold(value=1)\n"),
        ("def told(value):\n    return value\n", "told(**{'value': 1})\n"),
        ("def told(value):\n    return value\n\nname = 'value'\n", "told(**given)\n"),
        ("def told(value):\n    return value\n", "this is no module: value\n"),
        ("def told(value=value):\n    return value\n", ""),
        ("def told(call):\n    return (lambda value: 1), value\n", "call=1; f(call=2)\n"),
        ("def told(name):\n    return f'name {name}'\n", ""),
        ("def told(value):\n    class One:\n        value = 1\n    return One\n", ""),
        ("def told(*, value):\n    return value\n", ""),
        ("def told(*value):\n    return value\n", ""),
    ],
)
def test_a_name_that_somebody_needs_stays(text: str, other: str) -> None:
    """In a call, perhaps in one; a global one of the same name; one that stands in a text."""
    assert not changed(text, other)


def test_what_others_say_otherwise_is_no_reason() -> None:
    assert changed("def told(value):\n    return value\n", "value = told(1)  # value\nprint(value, 'value')\n")
