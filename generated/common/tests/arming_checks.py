# Generated from templates/tests/program/arming_checks.py: do not edit.
# Inputs: 722764bc08cd8d26
"""Arming: what it is refused for, in which order, and what the user's code has to do with it."""

from failsafe_bench import TIMER, armed_watch, new_watch
from program_bench import SECOND_US, main, messages, needs, needs_arming, ready_craft, run, run_passes
from program_facts import ARMING_US, FAILSAFES

import dialect


def reasons_not_to_arm():
    """The table of answers, in the order of precedence; what is at a threshold may be armed."""
    watch = new_watch()
    facts = watch.facts
    title = "PreArm: " + facts["title"]
    failsafe = f" {facts['quantity']} failsafe"
    good = watch.low + 100
    rows = [
        (None, 0, {}, f"{title} unhealthy"),
        (watch.low, 0, {}, None),
        (watch.low - 1, 0, {}, title + " low" + failsafe),
        (watch.deep, 0, {}, title + " low" + failsafe),
        (watch.deep, 0, {"low": 0}, title + " critical" + failsafe),
        (good, 0, {"critical": watch.low}, title + failsafe + " critical >= low"),
        (good, 0, {}, None),
    ]
    if facts["minimum"]:
        step = facts["minimum_scale"]
        minimum = good // step
        below = f"{title} below minimum arming {facts['quantity']}"
        rows += [(minimum * step - 1, minimum, {}, below), (minimum * step, minimum, {}, None)]
        rows += [(None, minimum, {}, f"{title} unhealthy"), (watch.deep, minimum, {"critical": watch.low}, below)]
    for value, minimum, changed, expected in rows:
        watch = new_watch()
        watch.set(changed.get("low", watch.low), changed.get("critical", watch.critical), TIMER)
        if facts["minimum"]:
            setattr(watch.parameters, facts["minimum"], minimum)
        watch.readings(value)
        assert watch.craft.state.vehicle.ready == (expected is None), (value, expected)
        assert watch.craft.arm() == expected, (value, minimum, changed, watch.craft.arm())
        assert watch.craft.is_armed == (expected is None)
        assert watch.craft.arm(force=True) is None, "force passes over all"


def latched_level_is_a_reason():
    """After a failsafe the vehicle is not armed again before the next start, but by force."""
    for value, word in (("between", "low"), ("deep", "critical")):
        watch = armed_watch(1)
        watch.readings(getattr(watch, value), 2 * watch.per_second)
        watch.craft.disarm()
        watch.readings(watch.low + 100)
        title = watch.facts["title"]
        assert watch.craft.arm() == f"PreArm: {title} {word} {watch.facts['quantity']} failsafe"
        assert watch.craft.arm(force=True) is None


def users_check_comes_last():
    """check_arming() of the user's code is asked behind the failsafe's, and its text is the answer."""
    watch = new_watch()
    watch.craft.problem = "door open"
    watch.readings(watch.low)
    assert watch.craft.arm() == "PreArm: door open"
    watch.readings(None)
    assert watch.craft.arm() == f"PreArm: {watch.facts['title']} unhealthy"


def arming_calls_the_user():
    """on_arm() before it is armed, and an exception there keeps it disarmed; on_disarm() afterwards; each once."""
    watch = armed_watch()
    watch.arm()
    watch.craft.disarm()
    watch.craft.disarm()
    assert watch.craft.calls == ["on_arm", "on_disarm"], watch.craft.calls

    def fail():
        raise ValueError("no")

    watch.craft.on_arm = fail
    assert watch.craft.arm(force=True) == "Arm: on_arm() failed: " + repr(ValueError("no"))
    assert not watch.craft.is_armed
    watch = armed_watch()
    watch.arm()
    watch.craft.on_disarm = fail
    watch.craft.disarm()
    assert not watch.craft.is_armed
    assert watch.craft.said("on_disarm() failed")


def what_cannot_be_asked_speaks_against_arming():
    """An exception in check_arming() is the reason, each time that somebody asks, and is no fault of anything else."""
    needs_arming()
    craft = ready_craft()

    def fail():
        raise ValueError("no")

    craft.check_arming = fail
    run(craft, SECOND_US)
    assert not [text for _, text in craft.said() if "failed" in text]
    assert not craft.state.vehicle.ready
    assert craft.arm() == "PreArm: check_arming() failed: " + repr(ValueError("no"))
    station = craft.ground_station()
    station.command(dialect.MAV_CMD_COMPONENT_ARM_DISARM, 1)
    run_passes(craft, 4)
    assert [ack.result for ack in station.received(messages.CommandAck)] == [dialect.MAV_RESULT_FAILED]
    assert craft.connections[0].faults == 0
    assert craft.arm(force=True) is None


def nothing_is_watched_without_the_monitor():
    """With the monitor off neither arming nor the failsafe looks at the value."""
    needs(FAILSAFES and FAILSAFES[0]["enabled"], "a parameter that switches the component off")
    facts = FAILSAFES[0]
    watch = new_watch(1)
    setattr(watch.component, facts["enabled"], False)
    watch.readings(None)
    assert watch.craft.arm() is None
    assert watch.readings(1, 5 * watch.per_second) == []


def no_answer_is_left_behind_a_fault():
    """While nobody can find out what speaks against arming, the vehicle does not tell that it is ready."""
    needs_arming()
    craft = ready_craft()
    craft.state.vehicle.ready = True

    def fail():
        raise ValueError("broken")

    craft._is_ready = fail
    run(craft, max(SECOND_US, ARMING_US))
    assert not craft.state.vehicle.ready


CHECKS = (
    (reasons_not_to_arm, "pair.reasons"),
    (latched_level_is_a_reason, "pair.reasons"),
    (users_check_comes_last, "pair.reasons"),
    (arming_calls_the_user, "pair.reasons"),
    (what_cannot_be_asked_speaks_against_arming, "arming.reasons"),
    (no_answer_is_left_behind_a_fault, "arming.reasons"),
    (nothing_is_watched_without_the_monitor, "reading.monitor"),
)

if __name__ == "__main__":
    main(CHECKS)
