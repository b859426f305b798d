"""Single values of cells: from one message that may have the pack's voltage in their place, and from pages."""

from readings import added, joined, page, single, values_of
from view import View

UNUSED = 65535


class Clock:
    """A receiver, as far as a view needs one."""

    def now_ms(self):
        """Return the only time."""
        return 0


class CellView(View):
    """Two messages about cells: all of them at once, and pages of four."""

    MESSAGES = ("ALL", "PAGES")
    STALE_MS = (1000, 0)
    SILENT_MS = 1000
    WINDOW_MS = 1000
    CARRIERS = {"cells": (1, 0), "info.cells": (0,)}  # noqa: RUF012
    ROLES = {"count": (("info.cells", 1),)}  # noqa: RUF012


def at_once(*volts):
    """Return what fields of ten and four elements say together."""
    first = list(volts[:10]) + [UNUSED] * (10 - len(volts))
    rest = list(volts[10:]) + [0] * (4 - len(volts[10:]))
    values = values_of(first, 0, 10, UNUSED, 1, 1000) + values_of(rest, 0, 4, 0, 1, 1000)
    whole = added(joined(first, 0, 10, UNUSED), joined(rest, 0, 4, 0))
    return single(values, 65.534), whole


def view_of(values, count=None, pages=()):
    """Return the cells of a view to which these were told."""
    view = CellView(Clock(), 1, 0)
    for first, found in pages:
        view.take(1, {"cells": page(first, values_of(found, 0, 4, 0, 1, 1000, keep=True))}, 1, 0, 0)
    view.take(0, {"cells": values, "info.cells": count}, 1, 0, 0)
    return view._elements("cells")


assert at_once() == (None, None)
assert at_once(4100, 4200) == ((4.1, 4.2), 8300)
assert at_once(*range(3000, 3012)) == (tuple([n / 1000 for n in range(3000, 3012)]), sum(range(3000, 3012)))
assert at_once(65534, 65534, 100) == (None, 131168), "one value that is spread over three elements"
assert at_once(4100, 65534) == ((4.1, 65.534), 69634), "nothing comes after the one that is full"

three, one = at_once(4100, 4200, 4000)[0], at_once(12300)[0]
assert view_of(three) == three
assert view_of(three, 3) == three
assert view_of(three, 4) is None
assert view_of(one) is None, "more likely the voltage of the pack"
assert view_of(one, 3) is None
assert view_of(one, 1) == (12.3,)
assert view_of(None) is None

pages = ((4, (3500, 3600, 0, 0)), (0, (3100, 3200, 0, 3400)))
assert view_of(None, None, pages) == (3.1, 3.2, None, 3.4, 3.5, 3.6), "the third is unknown, two are not there"
assert view_of(None, 7, pages) == (3.1, 3.2, None, 3.4, 3.5, 3.6, None)
assert view_of(one, None, pages)[:2] == (3.1, 3.2), "where the other one has no cells"
assert view_of(three, None, pages) == three
assert view_of(None, 7, pages[:1]) == (None, None, None, None, 3.5, 3.6, None), "the first page is missing"
assert view_of(None, None, ((0, (0, 0, 0, 0)),)) is None
newer = (pages[0], pages[1], (4, (3000, 3000, 3000, 0)))
assert view_of(None, None, newer) == (None,) * 4 + (3.0,) * 3, "a page comes again: it begins anew"
assert view_of(None, None, ((0, (3100, 3200, 0, 3400)), (300, (3000, 0, 0, 0)))) == (3.1, 3.2, None, 3.4), "too many"
odd = tuple((first, (3000, 3000, 3000, 3000)) for first in range(250))
assert view_of(None, None, odd) == (None,) * 249 + (3.0,) * 4, "of pages that overlap the newest stays"
print("done")  # noqa: T201
