"""Checks of views while several report one pack, and of a pack that was swapped, on whatever interpreter reads this."""

from mavlink import Link
from pack_tools import SECOND, TURN_MS, feed, info, main, status, status_v2
from packs import Packs


def contested_numbers_are_told():
    """Two components report number 0: one view that says so, until one of them has been silent."""
    packs = Packs()
    feed(packs, status(), 0)
    feed(packs, status(), SECOND)
    view = packs.view(7, 0)
    assert (view.components, view.is_contested) == ((1,), False)
    feed(packs, status(), 2 * SECOND, source=180)
    assert (view.components, view.is_contested) == ((1, 180), True)
    assert view.contest == "reported by components 1, 180"
    feed(packs, status(), 6 * SECOND + 1, source=180)
    assert (view.components, view.is_contested) == ((1, 180), False)


def two_of_one_name(packs, seconds, frames, ends=(1 << 30, 1 << 30), lost=()):
    """Two senders with the same ids: each sends status each second and info each 2 s, until it ends.

    `frames` are the sequence numbers that they begin with; those of `lost` do not arrive.
    """
    links = [Link(None, 7, 180), Link(None, 7, 180)]
    said = []
    for link, first in zip(links, frames):  # noqa: B905  MicroPython has no strict
        link.sequence = first
    for second in range(seconds):
        for place, link in enumerate(links):
            sent = [status(voltages=[(12000, 11400)[place] - second] + [65535] * 9)]
            sent += [info(("A", "B")[place])] if second % 2 == 0 else []
            for message in sent:
                frame = bytes(link.encode(message))
                link.sequence += 1
                if second < ends[place] and (second, place) not in lost:
                    packs.feed(frame, second * SECOND + 300 * place)
        view = packs.view(7, 0)
        said.append((view.swaps, view.is_contested))
    return said


def two_serial_numbers_are_no_swap():
    """Two with the same ids: contested once the first one is heard again, whatever their sequence numbers are."""
    for frames in ((0, 0), (0, 1), (3, 100), (200, 40)):
        for lost in ((), ((0, 1), (3, 0), (4, 0), (7, 1), (8, 0), (9, 1), (9, 0))):
            packs = Packs()
            said = two_of_one_name(packs, 30, frames, lost=lost)
            assert said[0][0] <= 1, said
            assert said[8:] == [(0, True)] * 22, (frames, lost, said)
            assert packs.view(7, 0).contest == "reported by several as component 180: serial numbers A, B"


def one_that_leaves_ends_the_contest():
    """It is over when only one is heard: no swap if that is the one from before, and one if it is the other."""
    for ends, swaps in (((1 << 30, 10), 0), ((10, 1 << 30), 1)):
        packs = Packs()
        said = two_of_one_name(packs, 40, (0, 60), ends)
        assert (9 - 1, said[8]) == (8, (0, True))
        assert said[20:] == [(swaps, False)] * 20, (ends, said)
        assert packs.view(7, 0).info.serial == "AB"[swaps]


def several_of_one_name_are_no_swaps():
    """Three take turns: none of them replaces another."""
    packs = Packs()
    for second in range(12):
        feed(packs, info("ABC"[second % 3]), second * SECOND)
    view = packs.view(7, 0)
    assert (view.swaps, view.is_contested) == (0, True)
    assert view.contest == "reported by several as component 1: serial numbers A, B, C", view.contest


def one_more_while_it_is_contested_is_no_swap():
    """Nor is it one later on, unless it is the one that is left."""
    for last, swaps in (("A", 0), ("B", 1), ("C", 1)):
        packs = Packs()
        for second, serial in enumerate(["A", "B", "A", "C", "B"] + [last] * 20):
            feed(packs, info(serial), second * SECOND)
            if second in range(2, 8):
                assert (packs.view(7, 0).swaps, packs.view(7, 0).is_contested) == (0, True), (last, second)
        view = packs.view(7, 0)
        assert (view.swaps, view.is_contested) == (swaps, False), (last, view.swaps)


def both_infos_of_two_are_no_swap():
    """Numbers that two kinds of message cut differently: what one kind has told holds for the other."""
    packs = Packs()
    for second in range(6):
        for serial in ("A", "B"):
            feed(packs, info(serial), second * SECOND)
            feed(packs, status(voltages=[12000] + [65535] * 9), second * SECOND)
    assert (packs.view(7, 0).swaps, packs.view(7, 0).is_contested) == (0, True)


def a_swap_and_back_are_two():
    """The pack that comes back after a while, when the one before is gone, was swapped in twice."""
    packs = Packs()
    for second in range(30):
        feed(packs, info("ABA"[second // 10]), second * SECOND)
    view = packs.view(7, 0)
    assert (view.swaps, view.is_contested, view.info.serial) == (2, False, "A")
    packs = Packs()
    for serial, second in (("A", 0), ("B", 5), ("A", 7)):
        feed(packs, info(serial), second * SECOND)
    assert (packs.view(7, 0).swaps, packs.view(7, 0).is_contested) == (2, False), "A is older than 6 s"


def values_that_take_turns_are_two():
    """Without serial numbers: two series of sequence numbers, each with a voltage of its own, also with frames lost."""
    for frames in ((0, 0), (5, 15), (15, 5), (0, 128), (250, 100)):
        for lost in (0, 3, 5):
            packs = Packs()
            links = [Link(None, 7, 180), Link(None, 7, 180)]
            for link, first in zip(links, frames):  # noqa: B905  MicroPython has no strict
                link.sequence = first
            for second in range(40):
                for place, link in enumerate(links):
                    frame = bytes(link.encode(status_v2(voltage=(12.0, 11.4)[place] - second / 1000)))
                    link.sequence += 1 + second % 3
                    for _ in range(1 if lost else 2):  # over two links
                        if not lost or (2 * second + place) % lost:
                            packs.feed(frame, second * SECOND + 300 * place)
            view = packs.view(7, 0)
            assert (view.swaps, view.contest) == (0, "reported by several as component 180"), (frames, lost)
            packs.feed(None, 46 * SECOND)
            assert not view.is_contested


def one_sender_is_not_contested():
    """Other traffic between its messages, lost frames, a restart, a second link and a load that comes and goes."""
    for step in (1, 3, 63, 64, 65, 127, 128, 129, 130, 200, 255, 256):
        for late in (0, 1, 3):
            packs = Packs()
            link = Link(None, 7, 1)
            frames = []
            for second in range(120):
                volts = 12 - second / 500 + (second * 7 % 5) / 1000 - (1 if second % 11 < 4 else 0)
                frames.append(bytes(link.encode(status_v2(voltage=volts))))
                link.sequence += step if second != 60 else 77
                if second % 9:
                    packs.feed(frames[-1], second * SECOND)
                if late and second >= late:
                    packs.feed(frames[-late], second * SECOND + 10)
                view = packs.view(7, 0)
                assert view is None or (view.swaps, view.contest) == (0, None), (step, late, second, view.contest)


def busy_senders_are_not_contested():
    """One whose sequence numbers say nothing, for it sends so much: values that jump, or take turns one by one."""
    state = 1
    for steps in ((1, 255), (129, 129), (129, 131)):
        packs = Packs()
        link = Link(None, 7, 1)
        for second in range(2000):
            state = (state * 75 + 74) % 65537
            volts = 11 + (state >> 8) % 2 if steps[0] == 1 else 11 + state / 65537
            packs.feed(bytes(link.encode(status_v2(voltage=volts))), second * SECOND)
            link.sequence += steps[0] + state % (steps[1] - steps[0] + 1)
            assert packs.view(7, 0).contest is None, (steps, second)
    packs = Packs()
    link = Link(None, 7, 1)
    for second in range(100):
        volts, amperes = ((11 - second // 2 % 2, 1), (12, 2 + second // 2 % 2))[second % 2]
        packs.feed(bytes(link.encode(status_v2(voltage=volts, current=amperes))), second * SECOND)
        link.sequence += 129
        assert packs.view(7, 0).contest is None, second


def a_load_that_comes_and_goes_is_not_contested():
    """Each second message tells another voltage, also after a restart."""
    for restart in (None, 10, 40, 100, 200):
        packs = Packs()
        link = Link(None, 7, 1)
        link.sequence = 50
        for second in range(60):
            packs.feed(bytes(link.encode(status_v2(voltage=12 - second % 2))), second * SECOND)
            link.sequence = restart if second == 20 and restart else link.sequence + 3
            assert packs.view(7, 0).contest is None, (restart, second)


def counts_that_take_turns_do_not_begin_anew():
    """Two without serial numbers, of which one has drawn little: no swap is left; one alone that begins anew is one."""

    class View(Packs.VIEW):
        IS_COUNTED_ANEW = True

    class Anew(Packs):
        VIEW = View

    for frames in ((0, 0), (0, 10), (10, 0), (0, 100)):
        packs = Anew()
        links = [Link(None, 7, 180), Link(None, 7, 180)]
        for link, first in zip(links, frames):  # noqa: B905  MicroPython has no strict
            link.sequence = first
        for second in range(60):
            for place, link in enumerate(links):
                frame = bytes(link.encode(status_v2(capacity_consumed=(2.0, 0.02)[place] + second / 10000)))
                packs.feed(frame, second * SECOND)
                link.sequence += 1
        assert (packs.view(7, 0).swaps, packs.view(7, 0).is_contested) == (0, True), frames
    for serial, swaps in (("A", 0), ("", 1)):
        packs = Anew()
        for number, consumed in enumerate((2, 2.1, 0.02, 0.03)):
            if number == 0:
                feed(packs, info(serial), number * SECOND)
            feed(packs, status_v2(capacity_consumed=consumed), number * SECOND)
        assert packs.view(7, 0).swaps == swaps, serial


def an_old_contest_stays_over():
    """Senders that alternated before the clock started again do not now, and none is a pack that comes back."""
    for names in ("AB", "ABA"):
        packs = Packs()
        for second, serial in enumerate(names):
            feed(packs, info(serial), second * SECOND)
        links = [Link(None, 7, 1), Link(None, 7, 1)]
        for second in range(30):
            for place, link in enumerate(links):
                packs.feed(bytes(link.encode(status_v2(voltage=12 + place))), second * 100)
                link.sequence += 1 + (100 if second == 0 and place else 0)
        view = packs.view(7, 0)
        assert view.is_contested
        for day in range(1, 13):
            packs.feed(None, day * 86400 * SECOND % TURN_MS)
            assert not view.is_contested, day
        packs.feed(None, 4 * SECOND)  # the clock has started again
        assert not view.is_contested
        swaps = view.swaps
        feed(packs, info("ABA"[len(names) - 2]), 4 * SECOND)
        assert (view.swaps, view.is_contested) == (swaps + 1, False), names


CHECKS = (
    contested_numbers_are_told,
    two_serial_numbers_are_no_swap,
    one_that_leaves_ends_the_contest,
    several_of_one_name_are_no_swaps,
    one_more_while_it_is_contested_is_no_swap,
    both_infos_of_two_are_no_swap,
    a_swap_and_back_are_two,
    values_that_take_turns_are_two,
    one_sender_is_not_contested,
    busy_senders_are_not_contested,
    a_load_that_comes_and_goes_is_not_contested,
    counts_that_take_turns_do_not_begin_anew,
    an_old_contest_stays_over,
)

if __name__ == "__main__":
    main(CHECKS)
