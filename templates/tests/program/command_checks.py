"""The commands and the modes of this vehicle: what they are given, when they are done, and what is answered."""

from command_facts import COMMANDS, MODE_FLAGS, MODES
from program_bench import (
    OTHER_SYSTEM,
    OTHER_COMPONENT,
    SECOND_US,
    main,
    messages,
    needs,
    new_craft,
    run,
    run_passes,
    turns,
)
from program_facts import COMPONENT_ID, SYSTEM_ID
from station_checks import Scene as Stations

import dialect

ACCEPTED = dialect.MAV_RESULT_ACCEPTED
DENIED = dialect.MAV_RESULT_DENIED
FAILED = dialect.MAV_RESULT_FAILED
REJECTED = dialect.MAV_RESULT_TEMPORARILY_REJECTED
UNSUPPORTED = dialect.MAV_RESULT_UNSUPPORTED
IN_PROGRESS = getattr(dialect, "MAV_RESULT_IN_PROGRESS", None)
CANCELLED = getattr(dialect, "MAV_RESULT_CANCELLED", None)
LONG = tuple(facts for facts in COMMANDS if facts["long"])


class Method:
    """A method of the vehicle that notes what it is given; it returns or raises what `says` has."""

    def __init__(self, craft, name, says=None):
        self.given = []
        self.says = says
        setattr(craft, name, self.do)

    def do(self, *given):
        """Stand in for the method."""
        self.given.append(given)
        if isinstance(self.says, Exception):
            raise self.says
        return self.says


class Scene:
    """A vehicle that may do a command, its methods, and a ground station that is heard."""

    def __init__(self, facts, *, is_armed=None):
        self.facts = facts
        self.craft = new_craft()
        self.station = self.craft.ground_station()
        if facts["armed"] if is_armed is None else is_armed:
            assert self.craft.arm(force=True) is None
        self.method = Method(self.craft, facts["method"])
        self.progress = Method(self.craft, facts["method"] + "_progress")
        self.cancel = Method(self.craft, facts["method"] + "_cancel")
        self.station.send(messages.Heartbeat, type=dialect.MAV_TYPE_GCS)
        run_passes(self.craft, 4)
        self.station.received()

    def asked(self, params=None, passes=4, **values):
        """Return the acknowledgements of a COMMAND_LONG, and the texts that begin with the command's title."""
        self.station.command(self.facts["number"], *(params or self.facts["good"][0]), **values)
        return self.answers(passes)

    def told(self):
        """Return the same where the answer has a text, which waits for its turn, and nothing goes on."""
        return self.asked(passes=turns(4))

    def answers(self, passes=4):
        """Return what comes in some passes: the acknowledgements, and the texts."""
        run_passes(self.craft, passes)
        found = self.station.received(messages.CommandAck, messages.Statustext)
        acks = [each for each in found if each.ID == messages.CommandAck.ID and each.command == self.facts["number"]]
        texts = [each.text for each in found if each.ID == messages.Statustext.ID]
        return acks, [text for text in texts if text.startswith(self.facts["title"] + ": ")]

    def result(self, params=None, **values):
        """Return the result of the only acknowledgement."""
        acks, _ = self.asked(params, **values)
        assert len(acks) == 1, (self.facts["name"], params, acks)
        assert (acks[0].raw("target_system"), acks[0].raw("target_component")) == (255, 190)
        return acks[0].result

    @property
    def done(self):
        """Return the answer to a command that is done."""
        return IN_PROGRESS if self.facts["long"] else ACCEPTED

    def settle(self):
        """Let what takes long come to its end."""
        if self.facts["long"]:
            run(self.craft, SECOND_US // 2)
            self.station.received()


def _is_near(given, expected):
    """Return whether arguments are the expected ones: whole ones exactly, floats as boards have them."""
    if len(given) != len(expected):
        return False
    for each, wanted in zip(given, expected):  # noqa: B905  MicroPython
        if wanted is None or each is None:
            if each is not wanted:
                return False
            continue
        if isinstance(wanted, int) and (not isinstance(each, int) or each != wanted):
            return False
        if abs(each - wanted) > 1e-6 * abs(wanted):
            return False
    return True


def ends_are_done():
    """The smallest and the largest value of each parameter, and what NaN stands for, reach the method in its units."""
    for facts in COMMANDS:
        scene = Scene(facts)
        for params, expected in [facts["good"]] + facts["ends"] + facts["unknown"]:
            assert scene.result(params) == scene.done, (facts["name"], params)
            assert _is_near(scene.method.given[-1], expected), (facts["name"], params, scene.method.given[-1])
            scene.settle()
        assert scene.craft.connections[0].faults == 0


def command_int_is_the_same():
    """COMMAND_INT gives the method what COMMAND_LONG does; its position is in 1e-7 degrees."""
    for facts in COMMANDS:
        scene = Scene(facts)
        assert _result_as_int(scene, (facts["frames"] or [0])[0]) == scene.done, facts["name"]
        assert _is_near(scene.method.given[-1], facts["good"][1]), (facts["name"], scene.method.given)


def _result_as_int(scene, frame):
    """Return the result of the good parameters as a COMMAND_INT in a frame."""
    names = ("param1", "param2", "param3", "param4", "x", "y", "z")
    values = {name: value for name, value in zip(names, scene.facts["as_int"])}  # noqa: B905,C416  MicroPython
    values["x"], values["y"] = int(values["x"]), int(values["y"])
    scene.station.send(messages.CommandInt, command=scene.facts["number"], frame=frame, **values)
    acks, _ = scene.answers()
    assert len(acks) == 1, (scene.facts["name"], frame, acks)
    return acks[0].result


def other_frames_are_denied():
    """A COMMAND_INT in a frame that the command does not have does not reach the method."""
    for facts in COMMANDS:
        for frame in list(range(22)) + [255]:  # noqa: RUF005  MicroPython
            scene = Scene(facts)
            is_meant = not facts["frames"] or frame in facts["frames"]
            assert _result_as_int(scene, frame) == (scene.done if is_meant else DENIED), (facts["name"], frame)
            assert len(scene.method.given) == is_meant, (facts["name"], frame)


def beyond_is_denied():
    """A value beyond an end, infinite, NaN without a meaning, no entry or no whole number does not reach the method."""
    for facts in COMMANDS:
        scene = Scene(facts)
        for params in facts["beyond"]:
            assert scene.result(params) == DENIED, (facts["name"], params)
        assert scene.method.given == [], (facts["name"], scene.method.given)
        assert scene.craft.connections[0].faults == 0


def others_are_left_alone():
    """A command for another system or component is not done; 0 is everybody."""
    for facts in COMMANDS:
        for system, component, count in (
            (OTHER_SYSTEM, COMPONENT_ID, 0),
            (SYSTEM_ID, OTHER_COMPONENT, 0),
            (0, COMPONENT_ID, 1),
            (0, 0, 1),
        ):
            scene = Scene(facts)
            acks, _ = scene.asked(target_system=system, target_component=component)
            assert (len(acks), len(scene.method.given)) == (count, count), (facts["name"], system, component)


def refusals_have_failed():
    """False has failed, a text has failed and is told; nothing goes on."""
    for facts in COMMANDS:
        scene = Scene(facts)
        scene.method.says = False
        acks, texts = scene.told()
        assert ([ack.result for ack in acks], texts) == ([FAILED], []), (facts["name"], texts)
        scene.method.says = "not now"
        acks, texts = scene.told()
        assert [ack.result for ack in acks] == [FAILED], (facts["name"], acks)
        assert texts == [facts["title"] + ": not now"], texts
        scene.method.says = True
        assert scene.result() == scene.done


def exceptions_have_failed():
    """An exception of the code is told, and each command is answered all the same."""
    for facts in COMMANDS:
        scene = Scene(facts)
        scene.method.says = ValueError("broken")
        acks, texts = scene.told()
        assert [ack.result for ack in acks] == [FAILED], (facts["name"], acks)
        assert texts == [facts["title"] + ": ValueError: broken"], texts
        scene.method.says = None
        assert scene.result() == scene.done
        assert scene.craft.connections[0].faults == 0


def unwritten_is_unsupported():
    """Until code overrides its method, a command is unsupported."""
    for facts in COMMANDS:
        if facts["unwritten"]:
            scene = Scene(facts)
            delattr(scene.craft, facts["method"])
            assert scene.result() == UNSUPPORTED, facts["name"]


def each_of_a_flood_is_answered():
    """Commands that arrive at once are answered one after another, in their order."""
    for facts in COMMANDS:
        scene = Scene(facts)
        for _ in range(8):
            scene.station.command(facts["number"], *facts["beyond"][0] if facts["beyond"] else facts["good"][0])
            scene.station.command(65535)
        run_passes(scene.craft, 40)
        acks = [ack.command for ack in scene.station.received(messages.CommandAck)]
        assert acks[:16] == [facts["number"], 65535] * 8, (facts["name"], acks)


def only_when_it_is_allowed():
    """While the vehicle is armed, or disarmed, and must not be, a command is rejected for now."""
    restricted = [facts for facts in COMMANDS if facts["armed"] is not None]
    needs(restricted, "a command that is not always allowed")
    for facts in restricted:
        scene = Scene(facts, is_armed=not facts["armed"])
        acks, texts = scene.told()
        assert [ack.result for ack in acks] == [REJECTED], (facts["name"], acks)
        assert texts == [facts["title"] + (": arm first" if facts["armed"] else ": disarm first")], texts
        assert scene.method.given == []
        assert (scene.craft.arm(force=True) if facts["armed"] else scene.craft.disarm()) is None
        assert scene.result() == scene.done


def only_who_is_heard():
    """A system of which no ground station is heard on the link is denied."""
    restricted = [facts for facts in COMMANDS if facts["stations"]]
    needs(restricted, "a command for ground stations only")
    for facts in restricted:
        scene = Scene(facts)
        stranger = scene.craft.ground_station()
        stranger.link = type(stranger.link)(stranger, 7, 190, 2, messages.ALL)
        stranger.command(facts["number"], *facts["good"][0])
        acks, _ = scene.answers()
        assert [ack.result for ack in acks] == [DENIED], (facts["name"], acks)
        assert scene.method.given == []
        assert scene.result() == scene.done


def progress_is_told():
    """A station that asked is told the progress each second, and the end: done, refused, or an exception."""
    needs(LONG, "a command that takes long")
    for facts in LONG:
        for end, result in ((None, ACCEPTED), (True, ACCEPTED), (False, FAILED), (ValueError("broken"), FAILED)):
            scene = Scene(facts)
            scene.progress.says = 30
            acks, _ = scene.asked()
            run(scene.craft, 3 * SECOND_US + SECOND_US // 2)
            acks += scene.station.received(messages.CommandAck)
            assert {(ack.raw("target_system"), ack.raw("target_component")) for ack in acks} == {(255, 190)}, acks
            told = [(ack.result, ack.raw("progress")) for ack in acks]
            assert told == [(IN_PROGRESS, 0)] + [(IN_PROGRESS, 30)] * 3, (facts["name"], told)
            scene.progress.says = end
            run(scene.craft, SECOND_US // 2)
            ended = [(ack.result, ack.raw("progress")) for ack in scene.station.received(messages.CommandAck)]
            assert ended == [(result, 0)], (facts["name"], end, ended)  # progress is of what goes on
            asked = len(scene.progress.given)
            run(scene.craft, 2 * SECOND_US)
            assert len(scene.progress.given) == asked, "what is over is asked for its progress"
            assert scene.station.received(messages.CommandAck) == []


def progress_is_for_who_asked():
    """Of two stations at one port, the one that asked is told how far it is, and the end; the other one nothing."""
    needs(LONG, "a command that takes long")
    for facts in LONG:
        for asking, other in ((1, 2), (2, 1)):
            scene = Stations()
            if facts["armed"]:
                assert scene.craft.arm(force=True) is None
            Method(scene.craft, facts["method"])
            progress = Method(scene.craft, facts["method"] + "_progress", 10)
            scene.seconds(1, 1, 2)
            scene.air.taken = {}
            scene.station(asking).command(facts["number"], *facts["good"][0])
            scene.seconds(2, 1, 2)
            progress.says = None
            scene.seconds(1, 1, 2)
            told = [ack.result for ack in scene.station(asking).received(messages.CommandAck)]
            assert told[:2] + told[-1:] == [IN_PROGRESS, IN_PROGRESS, ACCEPTED], (facts["name"], asking, told)
            assert scene.station(other).received(messages.CommandAck) == [], (facts["name"], asking)


def repeated_is_begun_once():
    """The same command with a confirmation is answered and not begun again; without one it is another, and rejected."""
    needs(LONG, "a command that takes long")
    for facts in LONG:
        scene = Scene(facts)
        scene.progress.says = 55
        assert scene.result() == IN_PROGRESS
        run(scene.craft, SECOND_US // 2)
        acks, _ = scene.asked(confirmation=1)
        assert [(ack.result, ack.raw("progress")) for ack in acks] == [(IN_PROGRESS, 55)], (facts["name"], acks)
        assert scene.result() == REJECTED
        assert len(scene.method.given) == 1, scene.method.given


def cancelled_ends():
    """COMMAND_CANCEL ends what goes on, if the vehicle can end it; what does not go on is not cancelled."""
    needs(LONG and hasattr(messages, "CommandCancel"), "something to cancel, and COMMAND_CANCEL")
    for facts in LONG:
        scene = Scene(facts)
        scene.progress.says = 5
        scene.station.send(messages.CommandCancel, command=facts["number"])
        assert scene.answers() == ([], [])
        assert scene.result() == IN_PROGRESS
        scene.cancel.says = False
        scene.station.send(messages.CommandCancel, command=facts["number"])
        acks, texts = scene.answers()
        assert [ack.result for ack in acks] == [IN_PROGRESS], (facts["name"], acks)
        assert texts == [facts["title"] + ": cannot be cancelled"], texts
        scene.cancel.says = None
        scene.station.send(messages.CommandCancel, command=facts["number"])
        acks, _ = scene.answers()
        assert [ack.result for ack in acks] == [CANCELLED], (facts["name"], acks)
        assert len(scene.cancel.given) == 2
        run(scene.craft, 2 * SECOND_US)
        assert scene.station.received(messages.CommandAck) == []


def modes_are_entered():
    """MAV_CMD_DO_SET_MODE and SET_MODE change to each mode, and what is true in it follows; to no other number."""
    needs(MODES, "modes")
    custom = dialect.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
    craft = new_craft()
    station = craft.ground_station()
    vehicle = craft.state.vehicle
    for by_command in (True, False):
        for number, name, flags in MODES:
            before = vehicle.mode_number
            _ask_for_mode(craft, station, by_command, custom, number)
            assert vehicle.mode_number == number, (by_command, number, vehicle.mode_number)
            for flag in MODE_FLAGS:
                assert bool(getattr(vehicle, flag)) == (flag in flags), (number, flag)
            if number != before:
                _, text = craft.texts.get(craft.texts.last)
                assert text == "Mode " + name, (text, name)
        before = vehicle.mode_number
        unknown = max([number for number, _, _ in MODES]) + 1
        for flags, number in ((custom, unknown), (custom ^ 0xFF, MODES[0][0])):
            _ask_for_mode(craft, station, by_command, flags, number, DENIED)
            assert vehicle.mode_number == before, (by_command, number)
        craft.check_mode = _refused
        _ask_for_mode(craft, station, by_command, custom, MODES[0][0], FAILED)
        assert vehicle.mode_number == before
        craft.check_mode = lambda _mode: None


def _refused(_mode):
    return "not now"


def _ask_for_mode(craft, station, by_command, flags, number, result=ACCEPTED):
    if not by_command:
        if hasattr(messages, "SetMode"):
            station.send(messages.SetMode, target_system=SYSTEM_ID, base_mode=flags, custom_mode=number)
            run_passes(craft, 4)
        elif result == ACCEPTED:
            craft.set_mode(number)
        assert station.received(messages.CommandAck) == []
        return
    station.command(dialect.MAV_CMD_DO_SET_MODE, flags, number)
    run_passes(craft, 4)
    assert [ack.result for ack in station.received(messages.CommandAck)] == [result], (flags, number)


CHECKS = (
    (ends_are_done, "command.done", "command.params"),
    (command_int_is_the_same, "command.done"),
    (beyond_is_denied, "command.params"),
    (other_frames_are_denied, "command.params"),
    (others_are_left_alone, "command.done"),
    (refusals_have_failed, "command.refusal"),
    (exceptions_have_failed, "command.refusal"),
    (unwritten_is_unsupported, "command.done"),
    (each_of_a_flood_is_answered, "command.done"),
    (only_when_it_is_allowed, "command.allowed"),
    (only_who_is_heard, "command.from"),
    (progress_is_told, "command.progress"),
    (progress_is_for_who_asked, "command.progress"),
    (repeated_is_begun_once, "command.progress"),
    (cancelled_ends, "command.cancel"),
    (modes_are_entered, "mode.change"),
)

if __name__ == "__main__":
    main(CHECKS)
