"""Checks of views about packs that report over a while, on whatever interpreter reads this file."""

import messages
from consumption import Consumption
from mavlink import Link
from pack_tools import LINKS, SECOND, TURN_MS, equals, feed, info, main, status, status_v2
from packs import Packs


def new_generation_wins():
    """Both arrive: one view; the new one's numbers, and the old one's where only it has them."""
    packs = Packs()
    old = status(current_battery=1234, battery_remaining=50, charge_state=1, voltages=[12000] + [65535] * 9)
    new = status_v2(current=12.345, voltage=12.0625, state_of_charge=50.25)
    for first, second in ((old, new), (new, old)):
        feed(packs, first, 0)
        feed(packs, second, 100)
        view = packs.view(7, 0)
        assert len(packs.views()) == 1
        equals(view.current, 12.345)
        assert view.voltage == 12.0625
        assert view.charge == 50.25
        assert (view.state, view.state_name) == (1, "MAV_BATTERY_CHARGE_STATE_OK")
        assert view.messages == ("BATTERY_STATUS", "BATTERY_STATUS_V2")


def stale_alone_leaves_the_word():
    """The new generation stops: after its time the old one speaks; what only the new one says is unknown."""
    packs = Packs()
    feed(packs, status_v2(current=2, voltage=12), 0)
    feed(packs, status(current_battery=300), 0)
    view = packs.view(7, 0)
    feed(packs, status(current_battery=300), 6000)
    assert (view.current, view.status_flags) == (2, ())
    feed(packs, status(current_battery=300), 6001)
    assert (view.current, view.status_flags, view.messages) == (3, None, ("BATTERY_STATUS",))
    assert not view.is_stale()
    assert view.is_stale(11002)


def unknown_is_none():
    """Each message with nothing known: None, also beside names of flags and facts."""
    for message in (status(), status_v2()):
        packs = Packs()
        feed(packs, message, 0)
        view = packs.view(7, 0)
        values = [view.voltage, view.current, view.used, view.temperature, view.charge, view.time_left_s()]
        assert values == [None] * 6, values
        assert view.info.serial is None


def flags_have_names():
    """Names in the order of the bits; what has none comes as a number; booleans follow their bit."""
    packs = Packs()
    feed(packs, status_v2(), 0)
    view = packs.view(7, 0)
    assert (view.flags, view.status_flags, view.fault_bitmask) == ((), (), None)
    assert (view.charging, view.is_charging) == (False, False)
    message = status_v2().update(status_flags=2 | 32 | 1 << 29 | 1 << 30)
    feed(packs, message, 1)
    names = ("MAV_BATTERY_STATUS_FLAGS_CHARGING", "MAV_BATTERY_STATUS_FLAGS_REQUIRES_SERVICE", "0x60000000")
    assert view.status_flags == names, view.status_flags
    assert (view.charging, view.is_charging, view.time_left_s()) == (True, True, None)
    feed(packs, status(fault_bitmask=4), 2)
    assert view.flags[0] == "MAV_BATTERY_FAULT_CELL_FAIL"
    assert view.flags[1:] == names


def facts_are_read():
    """Names, texts and numbers in units, kept while nothing more comes."""
    packs = Packs()
    fields = {"type": 3, "capacity_full": 3300, "weight": 1250, "device_name": "two packs"}
    feed(packs, info("SN-0042", cells_in_series=6, discharge_minimum_voltage=18600, **fields), 0)
    facts = packs.view(7, 0).info
    for now in (0, 60 * SECOND):
        packs.feed(None, now)
        assert facts.chemistry == "MAV_BATTERY_TYPE_LION"
        assert (facts.serial, facts.device_name, facts.cells) == ("SN-0042", "two packs", 6)
        equals(facts.capacity_full, 3.3)
        equals(facts.discharge_minimum_voltage, 18.6)
        assert (facts.weight, facts.resting_minimum_voltage) == (1.25, None)


def time_left_from_full_charge():
    """3.3 Ah, 50 % left, 3 A and then 6 A: 1.65 Ah / 3 A = 1980 s, falling to 990 s as the mean goes up."""
    packs = Packs()
    view = None
    for second in range(60):
        if second % 3 == 0:  # later than after 5 s nothing would be known
            feed(packs, info("A", capacity_full=3300), second * SECOND)
        feed(packs, status(current_battery=300 if second < 30 else 600, battery_remaining=50), second * SECOND)
        view = packs.view(7, 0)
        if second < 30:
            equals(view.mean_current_a, 3)
            equals(view.time_left_s(), 1980)
        if second == 40:  # 10 of 20 s; the step itself takes half a second of each
            equals(view.mean_current_a, 3 + 3 * 10.5 / 20, 0.05)
    equals(view.charge_left_ah, 1.65)
    equals(view.mean_current_a, 6)
    equals(view.time_left_s(), 990)


def mean_current_counts_durations():
    """10 A for a moment among 1 A for long is not 5.5 A: 1 s up and down of 18 s."""
    packs = Packs()
    for second, current in enumerate([1] * 9 + [10] + [1] * 9):
        feed(packs, status_v2(current=current), second * SECOND)
    equals(packs.view(7, 0).mean_current_a, (18 * 1 + 9) / 18)


def time_left_from_consumption():
    """No current: 40 mAh a minute are 2.4 A; 25 % left after 2.25 Ah: 0.75 Ah last 1125 s."""
    packs = Packs()
    for second in range(61):
        used = 2.25 - (60 - second) * 0.04 / 60
        feed(packs, status_v2(capacity_consumed=used, state_of_charge=25), second * SECOND)
        view = packs.view(7, 0)
        assert (view.time_left_s() is None) == (second < 10), second  # half of 20 s
    equals(view.mean_current_a, 2.4, 1e-3)
    equals(view.charge_left_ah, 0.75)
    equals(view.time_left_s(), 1125, 1e-3)


def the_charge_that_is_reported_goes_first():
    """1 Ah is left, whatever percentage and capacity say; without it, and without percent, full less consumed."""
    packs = Packs()
    feed(packs, info("A", capacity_full=4000), 0)
    feed(packs, status_v2(capacity_remaining=1, state_of_charge=90, capacity_consumed=0.5, current=2), 0)
    equals(packs.view(7, 0).time_left_s(), 1800)
    feed(packs, status_v2(capacity_consumed=0.5, current=2), 1)
    equals(packs.view(7, 0).charge_left_ah, 3.5)


def no_time_without_a_reason():
    """While charging, while nothing is drawn, while the charge or the current is unknown, and once it is stale."""
    cases = (
        ({"current": -1, "capacity_remaining": 1}, True),
        ({"current": 0, "capacity_remaining": 1}, False),
        ({"capacity_remaining": 1}, False),
        ({"current": 1}, False),
    )
    for fields, is_charging in cases:
        packs = Packs()
        feed(packs, status_v2(**fields), 0)
        view = packs.view(7, 0)
        assert (view.time_left_s(), bool(view.is_charging)) == (None, is_charging), fields
    packs = Packs()
    feed(packs, status_v2(current=1, capacity_remaining=1), 0)
    packs.feed(None, 5000)
    assert packs.view(7, 0).time_left_s() == 3600
    assert packs.view(7, 0).time_left_s(5001) is None
    feed(packs, status_v2(current=1, capacity_remaining=1).update(status_flags=2), 6000)
    assert packs.view(7, 0).time_left_s() is None, "the flag says that it is charging"


def several_batteries_last_together():
    """1 Ah at 1 A and 2 Ah at 5 A: one after the other 3600 s and 1440 s, together 3 Ah / 6 A = 1800 s."""
    packs = Packs()
    feed(packs, status_v2(0, current=1, capacity_remaining=1), 0)
    feed(packs, status_v2(1, current=5, capacity_remaining=2), 0)
    assert [view.number for view in packs.views()] == [0, 1]
    assert [view.time_left_s() for view in packs.views()] == [3600, 1440]
    assert packs.total_time_left_s(7) == 1800
    assert packs.total_time_left_s(7, [0]) == 3600
    assert packs.total_time_left_s(7, [0, 2]) is None
    assert packs.total_time_left_s(8) is None
    feed(packs, status_v2(1, current=5), 1)
    assert packs.total_time_left_s(7) is None


def a_swap_is_noticed():
    """Another serial number: counted once, what the old pack drew and said is forgotten."""
    packs = Packs()
    feed(packs, info("A", capacity_full=3300), 0)
    feed(packs, status_v2(current=9, capacity_remaining=1), 0)
    feed(packs, status_v2(current=9, capacity_remaining=1), SECOND)
    view = packs.view(7, 0)
    feed(packs, info("A", capacity_full=3300), 2 * SECOND)
    assert (view.swaps, view.mean_current_a) == (0, 9)
    feed(packs, info("B", capacity_full=2200), 3 * SECOND)
    assert (view.swaps, view.mean_current_a, view.current) == (1, None, None)
    equals(view.info.capacity_full, 2.2)
    feed(packs, status_v2(current=1, capacity_remaining=1), 4 * SECOND)
    assert (view.swaps, view.mean_current_a) == (1, 1)
    feed(packs, info("", capacity_full=2200), 5 * SECOND)
    feed(packs, info("B", capacity_full=2200), 6 * SECOND)
    assert view.swaps == 1
    feed(packs, info("", cycle_count=5), 7 * SECOND)
    feed(packs, info("C", cycle_count=6), 8 * SECOND)
    assert view.swaps == 2, "B was known, though one message left it out"


def what_cannot_be_is_unknown():
    """More than all of the charge is no number, and has no age."""
    packs = Packs()
    feed(packs, status_v2(state_of_charge=130, voltage=12), 0)
    view = packs.view(7, 0)
    assert view.charge is None
    packs.tell(300)
    assert (view.age_ms(of="voltage"), view.age_ms(of="charge")) == (300, None)
    feed(packs, status_v2(state_of_charge=100), SECOND)
    assert view.charge == 100


def cycles_tell_packs_apart():
    """Without a serial number: one cycle more is the same pack after a charge, fewer or several more are another."""
    packs = Packs()
    for cycles, swaps in ((7, 0), (8, 0), (8, 0), (7, 1), (9, 2), (20, 3)):
        feed(packs, info("", cycle_count=cycles), 0)
        assert packs.view(7, 0).swaps == swaps, (cycles, swaps)


def systems_are_apart():
    """The same number of two vehicles is two batteries."""
    packs = Packs()
    feed(packs, status(current_battery=100), 0)
    packs.feed(bytes(Link(None, 8, 1).encode(status(current_battery=200))), 0)
    assert [(view.system, view.number, view.current) for view in packs.views()] == [(7, 0, 1), (8, 0, 2)]


def the_clock_starts_again():
    """The mean and the age go on over the turn of ticks_ms(), and a long silence is not taken for a short one."""
    packs = Packs()
    for second in range(-10, 11):
        feed(packs, status_v2(current=3, capacity_remaining=1), second * SECOND % TURN_MS)
    view = packs.view(7, 0)
    equals(view.mean_current_a, 3)
    assert view.age_ms(12 * SECOND) == 2 * SECOND
    for day in range(1, 13):
        packs.feed(None, (10 * SECOND + day * 86400 * SECOND) % TURN_MS)
        assert view.is_stale(), day
    packs.feed(None, 11 * SECOND)  # the clock has started again
    assert view.is_stale()
    assert (view.age_ms(), view.current) == (None, None)


def an_old_message_stays_old():
    """The other generation alone goes on until the clock has started again: what came before stays too old."""
    packs = Packs()
    feed(packs, status_v2(current=3), 0)
    for day in range(1, 13):
        feed(packs, status(current_battery=100), day * 86400 * SECOND % TURN_MS)
    feed(packs, status(current_battery=100), 0)
    assert (packs.view(7, 0).current, packs.view(7, 0).messages) == (1, ("BATTERY_STATUS",))


def a_clock_can_be_given():
    """With a clock nobody tells the time."""
    now = [0]
    packs = Packs(now=lambda: now[0])
    packs.feed(bytes(LINKS[1].encode(status(current_battery=100))))
    view = packs.view(7, 0)
    now[0] = 5000
    assert (view.current, view.age_ms(), view.is_stale()) == (1, 5000, False)
    now[0] = 5001
    assert (view.current, view.is_stale()) == (None, True)


def decoded_messages_are_handled():
    """handle() takes what another parser found; what is of no concern is passed over."""
    packs = Packs()
    link = Link(None, 3, 1, messages=messages.ALL)
    (message,) = list(link.feed(bytes(link.encode(status(1, current_battery=100)))))
    view = packs.handle(message, 0)
    assert (view.system, view.number, view.current) == (3, 1, 1)
    other = type("Other", (), {"ID": 200})()
    assert packs.handle(other, 0) is None


def made_up_numbers_fill_no_memory():
    """So many views there are and no more; one that is stale makes room, and none else."""
    packs = Packs(most=3)
    for number in range(3):
        feed(packs, status(number, current_battery=100), number)
    for number in range(3, 200):
        assert packs.feed(bytes(LINKS[1].encode(status(number, current_battery=100))), 1000) == 0
    assert packs.refused == 197
    assert [view.number for view in packs.views()] == [0, 1, 2]
    feed(packs, status(0, current_battery=200), 5000)
    late = 1 + packs.VIEW.SILENT_MS + 1
    feed(packs, status(77, current_battery=300), late)
    assert [view.number for view in packs.views()] == [0, 2, 77]
    assert packs.feed(bytes(LINKS[1].encode(status(78))), late) == 0, "number 2 is only about to be stale"
    packs.tell(late + (1 << 28) + 1)
    for number in (79, 80, 81):
        feed(packs, status(number), late + (1 << 28) + 2)
    assert [view.number for view in packs.views()] == [79, 80, 81], "all others were silent for days"


def no_quantity_is_infinite():
    """A float without end is unknown, and neither the mean nor the time left is spoilt by it or by absurd numbers."""
    packs = Packs()
    endless = float("inf")
    feed(packs, status_v2(current=endless, voltage=-endless, capacity_remaining=endless), 0)
    view = packs.view(7, 0)
    assert (view.current, view.voltage, view.charge_left_ah, view.mean_current_a) == (None, None, None, None)
    feed(packs, status_v2(current=2, capacity_remaining=1), 1000)
    feed(packs, status_v2(current=2, capacity_remaining=1), 3000)
    equals(view.mean_current_a, 2)
    equals(view.time_left_s(3000), 1800)
    feed(packs, status_v2(current=2, capacity_remaining=-1), 4000)
    assert view.time_left_s(4000) == 0


def a_total_without_end_begins_anew():
    """On a board floats end at 3.4e38, here later: what is drawn at absurd currents adds up to infinity there."""
    mean = Consumption(30000, 10000)
    for now_ms in range(0, 4000, 1000):
        mean.note(now_ms, 1e306, None)
    for now_ms in range(4000, 100000, 1000):
        mean.note(now_ms, 2, None)
    equals(mean.mean_a(), 2)


def the_shortest_window_has_a_mean():
    """One millisecond: a first total has no rise yet, and the next one has."""
    mean = Consumption(1, 10000)
    mean.note(0, None, 1)
    assert mean.mean_a() is None
    mean.note(3600, None, 1.002)
    equals(mean.mean_a(), 2)


CHECKS = (
    new_generation_wins,
    stale_alone_leaves_the_word,
    unknown_is_none,
    flags_have_names,
    facts_are_read,
    time_left_from_full_charge,
    mean_current_counts_durations,
    time_left_from_consumption,
    the_charge_that_is_reported_goes_first,
    no_time_without_a_reason,
    several_batteries_last_together,
    a_swap_is_noticed,
    what_cannot_be_is_unknown,
    cycles_tell_packs_apart,
    systems_are_apart,
    the_clock_starts_again,
    an_old_message_stays_old,
    a_clock_can_be_given,
    decoded_messages_are_handled,
    made_up_numbers_fill_no_memory,
    no_quantity_is_infinite,
    a_total_without_end_begins_anew,
    the_shortest_window_has_a_mean,
)

if __name__ == "__main__":
    main(CHECKS)
