"""Attributes that are views of a component's words: 32-bit numbers in one array, -2 ** 30 for what is unknown.

Whole numbers in the units that go out; beside them the same in the units of people. To set an attribute to None, or one
in the units of people to NaN, makes it unknown. A number that some message does not carry as it is has limits: one
beyond them is counted in `limited` of its component, by the name of the attribute, and told once, until one within them
is set.

What a view is about are defaults of its functions: closures and their cells would take twice the heap. Most are made
when they are first used, of a line in the VIEWS of their class, for a program uses few of them: until then they take
no more than the line, and their names are not among those that MicroPython keeps.
"""

from array import array

from conversion import LARGEST, limited, to_steps
from message import keep

UNKNOWN = -1073741824


class Component:
    """Base of a part of the state; `words` are its part of the array, or an array of its own.

    A class has a NAME, the SIZE of its part, and as START what is known from the start, places and values. Of several
    instances the first can be used as a list of all of them. VIEWS has a line for attributes that are made when one of
    them is first used: the names, a ":" behind each, the kind, which KINDS has, and what its function is called with.
    """

    START = ()
    VIEWS = ""

    def __init__(self, words=None, instance=0):
        self.words = array("i", [UNKNOWN] * self.SIZE) if words is None else words
        self.limited = {}
        self._all = (self,)
        self._log = print
        self.beyond = {}  # the places of what is beyond its limits
        start = self.START
        for at in range(0, len(start), 2):
            values = start[at + 1]
            self.words[start[at]] = values[instance] if isinstance(values, tuple) else values

    def __len__(self):
        return len(self._all)

    def __getitem__(self, instance):
        return self._all[instance]

    def __getattr__(self, name):
        if not self._make(name):
            raise AttributeError(f"{self.NAME} has no {name}")
        return getattr(self, name)

    def __setattr__(self, name, value):
        # CPython asks here for each attribute, MicroPython only for those that the class does not have yet.
        if hasattr(type(self), name) or not self._make(name):
            keep(self, name, value)
        else:
            setattr(self, name, value)

    def _make(self, name):
        """Make an attribute of the class of the line that has its name; return whether there is one."""
        views = self.VIEWS
        at = views.find(f" {name}:")
        if at < 0:
            return False
        words = views[views.rfind("\n", 0, at) + 1 : views.find("\n", at)].split()
        names = [word for word in words if word[-1] == ":"]
        kind = len(names)
        made = KINDS[words[kind]](*[_told(word) for word in words[kind + 1 :]])
        if kind > 1:
            made = made[0 if names[0] == f"{name}:" else 1]
        setattr(type(self), name, made)
        return True

    def tell(self, place, name):
        """Count that a number at a place is beyond its limits, and log it once; at this moment it has the limit."""
        if place not in self.beyond:
            self._begin(place, name)
        name = self.beyond[place]  # in few variables: those of a larger function lie on the heap
        count = self.limited.get(name, 0)
        if count < LARGEST:
            self.limited[name] = count + 1

    def _begin(self, place, name):
        limit = getattr(self, name)
        name = self.beyond[place] = name.lstrip("_")
        if not isinstance(limit, (int, float)):  # a list
            place = (place - limit.first) // limit.width
            name, limit = f"{name}[{place}]", limit[place]
        owner = self.NAME if len(self) == 1 else f"{self.NAME}[{self._all.index(self)}]"
        shown = limit if isinstance(limit, int) else f"{limit:.7g}"
        self._log(f"warning: {owner}.{name} beyond {shown}: limited")


def _told(word):
    """Return what a word in VIEWS stands for: a number, None or a name; - and + are the least and the largest one."""
    if word == "None":
        return None
    if word in "-+":
        return LARGEST if word == "+" else -LARGEST
    return int(word) if word[0] in "-0123456789" else word


def together(cls, words, base, size, instances, log):
    """Return the first of so many instances that share an array of words, one block behind the other."""
    whole = memoryview(words)
    every = tuple(cls(whole[base + size * at : base + size * (at + 1)], at) for at in range(instances))
    for each in every:
        each._all = every
        each._log = log
    return every[0]


def accessors(place, low, high, name):
    """Return what gets and sets a whole number; `name` is what texts call it."""

    def get(self, place=place):
        value = self.words[place]
        return None if value == UNKNOWN else value

    def put(self, value, place=place, low=low, high=high, name=name):
        if value is None:
            self.words[place] = UNKNOWN
        elif low <= value <= high:
            self.words[place] = value
            if self.beyond:
                self.beyond.pop(place, None)
        else:
            self.words[place] = limited(value, -LARGEST, LARGEST)  # raises for what is no whole number
            self.words[place] = limited(value, low, high)
            self.tell(place, name)
            self.words[place] = limited(value, -LARGEST, LARGEST)

    return get, put


def _dated(put, age):
    def put_now(self, value, put=put, age=age):
        put(self, value)
        self.words[age] = 0

    return put_now


def whole(place, low=-LARGEST, high=LARGEST, name=""):
    """Return an attribute for a whole number that all messages carry as it is from `low` to `high`.

    What is beyond a word becomes the largest that it holds; messages limit it further.
    """
    return property(*accessors(place, low, high, name))


def number(place, low, high, name, numerator, denominator=1, age=None):
    """Return two attributes, for a whole number and for it in the unit of people.

    `numerator` / `denominator` steps make one unit. The word at `age` is 0 once something is set.
    """
    get, put = accessors(place, low, high, name)
    if age is not None:
        put = _dated(put, age)

    def in_units(self, place=place, numerator=numerator, denominator=denominator):
        value = self.words[place]
        return None if value == UNKNOWN else in_unit(value, numerator, denominator)

    def put_units(self, value, put=put, numerator=numerator, denominator=denominator):
        put(self, to_steps(value, numerator, denominator))

    return property(get, put), property(get if numerator == denominator else in_units, put_units)


def result(place, numerator, denominator=1):
    """Return an attribute in the unit of people that only the firmware sets."""

    def get(self, place=place, numerator=numerator, denominator=denominator):
        value = self.words[place]
        return None if value == UNKNOWN else in_unit(value, numerator, denominator)

    return property(get)


def truth(place):
    """Return an attribute for a boolean."""

    def get(self, place=place):
        return self.words[place] != 0

    def put(self, value, place=place):
        self.words[place] = 1 if value else 0

    return property(get, put)


def known(place):
    """Return an attribute that tells whether a word is known."""

    def get(self, place=place):
        return self.words[place] != UNKNOWN

    return property(get)


def in_unit(value, numerator, denominator):
    """Return steps in the unit of people; a whole number stays one where these are the same."""
    return value if numerator == denominator else value * denominator / numerator


KINDS = {
    "known": known,
    "number": number,
    "result": result,
    "truth": truth,
    "whole": whole,
}
