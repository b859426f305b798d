"""Commands by rows that a check makes: all that a row can say, asked for here or not; and what sets defaults."""

from program_bench import (
    main,
    messages,
    mock_time,
    needs,
)
from program_facts import PARAMETERS

import dialect
import rare_commands
from stand_ins import Texts, Thing

try:
    import own_commands
except ImportError:  # there are no commands of the project's own
    own_commands = None


ACCEPTED, DENIED, FAILED = dialect.MAV_RESULT_ACCEPTED, dialect.MAV_RESULT_DENIED, dialect.MAV_RESULT_FAILED

GOES_ON = 5  # MAV_RESULT_IN_PROGRESS, which not every program has

REJECTED, UNSUPPORTED = dialect.MAV_RESULT_TEMPORARILY_REJECTED, dialect.MAV_RESULT_UNSUPPORTED

NAN, INFINITE = float("nan"), float("inf")

NUMBER = 31999  # of no command


class Asked:
    """A command that arrived: `params` from the first on."""

    def __init__(self, *params, message=None, system=255):
        self.number = NUMBER
        self.params = params
        self.message = message or messages.CommandLong(unknown=False)
        self.system = system
        self.progress = None

    def param(self, number):
        """Return one."""
        return self.params[number - 1]

    def whole(self, number, _least, _most):
        """Return one that is whole."""
        return self.params[number - 1]


class Doing:
    """A vehicle that does commands of its own: what it was given stands in `given`."""

    def __init__(self):
        self.texts = Texts()
        self.given = []
        self.is_armed = False
        self.going_on = None
        self.begun = []
        self.long_commands = self

    def act(self, *values):
        """Do it."""
        self.given.append(values)

    def running(self, method):
        """Return what goes on."""
        assert method == "act"
        return self.going_on

    def begin(self, row, command, _connection):
        """Note what goes on from now on."""
        self.begun.append((row[0], command.number))


def _answer(vehicle, row, command, heard=()):
    """Return what becomes of a command with a row of its own."""
    at_hand = Thing(services=Thing(listeners=Thing(names=heard)))
    own_commands.COMMANDS[NUMBER] = row
    try:
        return own_commands.OwnCommands(vehicle, at_hand).do(command)
    finally:
        del own_commands.COMMANDS[NUMBER]


WHOLE, ROUNDED = 1, 2

PARAMS = (  # what a parameter may be, values, and for each what the method gets, None where it is denied
    (
        (-10, 10, 1, 1, 0, None, None),
        (-10, 10, 0.5, 10.5, -10.5, NAN, INFINITE, -INFINITE),
        (-10, 10, 0.5) + (None,) * 5,
    ),
    ((-10, 10, 1, 1, 0, None, 7), (NAN, 11), (7, None)),
    ((0, 60, 3, 2, 0, None, None), (4, 60, 1), (6.0, 90.0, 1.5)),
    ((0, 60, 1, 4, 0, None, None), (2, 61), (0.5, None)),
    ((0, 9, 1, 1, WHOLE, None, None), (3.0, 3.5, 9, 9.5), (3, None, 9, None)),
    ((0, 9, 1, 1, ROUNDED, None, None), (3.25, 3.75, 9), (3, 4, 9)),
    ((0, 9, 1, 1, 3, None, None), (3.25, 3.75), (3, 3)),
    ((0, 9, 10, 1, ROUNDED, None, None), (3.26, 0.04), (33, 0)),
    ((0, 9, 1, 1, WHOLE, (1, 3), None), (1, 2, 3, 3.5), (1, None, 3, None)),
    ((0, 9, 1, 1, WHOLE, 5, None), (0, 1, 2, 3, 4, 5, 7), (0, 1, None, None, 4, 5, None)),
)


def parameters_of_commands_are_looked_at():
    """Ends, factors, whole numbers, entries and flags; NaN is what it stands for, and a refusal says why."""
    needs(own_commands, "a command of the project's own")
    for (least, most, multiplier, divisor, form, among, default), values, expected in PARAMS:
        param = (2, least, most, multiplier, divisor, form, among, default, "it is wrong")
        row = ("act", "Title", None, False, False, (param,), (), (), None)
        for value, given in zip(values, expected):  # noqa: B905  MicroPython's takes nothing else
            vehicle = Doing()
            answer = _answer(vehicle, row, Asked(1, value))
            if given is None:
                assert (answer, vehicle.given) == ((DENIED, None), []), (row, value)
                assert vehicle.texts.told == [(dialect.MAV_SEVERITY_ERROR, "Title: it is wrong")], vehicle.texts.told
                continue
            assert (answer, vehicle.given) == ((ACCEPTED, None), [(given,)]), (row, value, vehicle.given)
            assert not form or isinstance(vehicle.given[0][0], int)


def positions_of_commands_are_global():
    """COMMAND_INT has parameters of its own where it has a position, whose unknown is the largest."""
    needs(own_commands, "a command of the project's own")
    long_params = ((1, 0, 9, 1, 1, 0, None, None, "long"),)
    int_params = ((2, -90, 2e10, 1, 1, 0, None, 5, "int"),)
    row = ("act", "Title", None, False, False, long_params, int_params, (0, 6), "positions have to be global")
    for frame, value, result, given, text in (
        (0, 8, ACCEPTED, [(8,)], None),
        (6, 0x7FFFFFFF, ACCEPTED, [(5,)], None),
        (6, 0x7FFFFFFE, ACCEPTED, [(0x7FFFFFFE,)], None),
        (6, -91, DENIED, [], "Title: int"),
        (1, 8, DENIED, [], "Title: positions have to be global"),
    ):
        vehicle = Doing()
        asked = Asked(3, value, message=messages.CommandInt(unknown=False).update(frame=frame))
        assert _answer(vehicle, row, asked) == (result, None), (frame, value)
        assert vehicle.given == given, (frame, value)
        assert [told for _, told in vehicle.texts.told] == [text] * (text is not None)
        vehicle = Doing()
        assert _answer(vehicle, row, Asked(3, value)) == (ACCEPTED, None)
        assert vehicle.given == [(3,)], "COMMAND_LONG has the others"
    vehicle, row = Doing(), row[:6] + ((), (), None)  # noqa: RUF005  MicroPython
    asked = Asked(4, message=messages.CommandInt(unknown=False).update(frame=1))
    assert _answer(vehicle, row, asked) == (ACCEPTED, None)
    assert vehicle.given == [(4,)], "they are the same without a position"


def commands_are_done_when_they_may_be():
    """Armed or disarmed, of stations that are heard, and one at a time; what is repeated is told how far it is."""
    needs(own_commands, "a command of the project's own")
    error = dialect.MAV_SEVERITY_ERROR
    for armed, is_armed, text in (
        (None, True, None),
        (True, True, None),
        (False, False, None),
        (True, False, "Title: arm first"),
        (False, True, "Title: disarm first"),
    ):
        vehicle = Doing()
        vehicle.is_armed = is_armed
        answer = _answer(vehicle, ("act", "Title", armed, False, False, (), (), (), None), Asked())
        assert answer == (REJECTED if text else ACCEPTED, None), (armed, is_armed)
        assert vehicle.given == [()] * (not text)
        assert vehicle.texts.told == ([(error, text)] if text else [])
    row = ("act", "Title", None, True, False, (), (), (), None)
    for heard, result in (((255 << 8 | 190, 7), ACCEPTED), ((254 << 8 | 255, 0), DENIED), ((), DENIED)):
        vehicle = Doing()
        assert _answer(vehicle, row, Asked(), heard) == (result, None), heard
        assert len(vehicle.given) == (result == ACCEPTED)
        assert vehicle.texts.told == [(error, "Title: only for ground stations that are heard")] * (result == DENIED)
    row = ("act", "Title", None, False, True, (), (), (), None)
    for is_again, result in (
        (None, dialect.MAV_RESULT_IN_PROGRESS),
        (True, dialect.MAV_RESULT_IN_PROGRESS),
        (False, REJECTED),
    ):
        vehicle, asked = Doing(), Asked()
        if is_again is not None:
            vehicle.going_on = Thing(progress=66, is_asked_again=lambda command: command is asked and is_again)  # noqa: B023
        assert _answer(vehicle, row, asked) == (result, None), is_again
        assert asked.progress == (66 if is_again else None)
        assert (len(vehicle.given), vehicle.begun) == ((1, [("act", NUMBER)]) if is_again is None else (0, [])), (
            is_again
        )
        assert vehicle.texts.told == [(error, "Title: is going on already")] * (is_again is False)


def refusals_are_told_once_in_a_while():
    """The same text a second later, another one at once."""
    needs(own_commands, "a command of the project's own")
    vehicle = Doing()
    own = own_commands.OwnCommands(vehicle, None)
    row = ("act", "Title", None, False, False, (), (), (), None)
    told = []
    mock_time.set_ticks_us(((1 << 30) - 1500) * 1000)  # ticks start again meanwhile
    for wait_ms, text in (
        (0, "a"),
        (999, "a"),
        (1, "a"),
        (999, "a"),
        (0, "b"),
        (0, "a"),
        (0, None),
        (500, "a"),
        (500, "a"),
    ):
        mock_time.advance_us(1000 * wait_ms)
        before = len(vehicle.texts.told)
        assert own._refuse(row, FAILED, text) == (FAILED, None)
        told.append(len(vehicle.texts.told) - before)
    mock_time.set_ticks_us(0)
    assert told == [1, 0, 1, 0, 1, 1, 0, 0, 1], told
    assert [text for _, text in vehicle.texts.told] == ["Title: a", "Title: a", "Title: b", "Title: a", "Title: a"]


def defaults_come_back_when_they_may():
    """Only disarmed, and not before a restart; what writes is taken, all else is not known."""
    needs(PARAMETERS, "parameters")
    from parameters import Parameters  # noqa: PLC0415  there are some

    storage, check = dialect.MAV_CMD_PREFLIGHT_STORAGE, NUMBER
    changed = [each for each in PARAMETERS if each["maximum"] != each["default"]]
    for action, restart_ms, is_armed, result, text in (
        (None, None, False, DENIED, None),
        (1, None, False, ACCEPTED, None),
        (1, 5, True, ACCEPTED, None),
        (0, None, False, UNSUPPORTED, None),
        (3, None, False, UNSUPPORTED, None),
        (2, 0, False, REJECTED, None),
        (2, None, True, FAILED, "Defaults: disarm first"),
        (2, None, False, ACCEPTED, "notice: all parameters have their defaults"),
    ):
        own = Parameters()
        for facts in changed:
            setattr(own, facts["attribute"], facts["maximum"])
        vehicle = Thing(parameters=own, restart_ms=restart_ms, is_armed=is_armed, texts=Texts())
        asked = Asked(action)
        asked.number = storage
        assert rare_commands.do(vehicle, asked) == result, (action, restart_ms, is_armed)
        assert [told for _, told in vehicle.texts.told] == [text] * (text is not None), vehicle.texts.told
        is_done = action == 2 and result == ACCEPTED
        for facts in changed:
            kept = facts["default" if is_done else "maximum"]
            assert getattr(own, facts["attribute"]) == kept, (facts["name"], action)
    reminded = []
    vehicle = Thing(is_armed=True, remind=lambda: reminded.append(True))
    asked = Asked(0)
    asked.number = check
    assert (rare_commands.do(vehicle, asked), reminded) == (REJECTED, [])
    vehicle.is_armed = False
    assert (rare_commands.do(vehicle, asked), reminded) == (ACCEPTED, [True])


CHECKS = (
    (parameters_of_commands_are_looked_at, "command.params"),
    (positions_of_commands_are_global, "command.params"),
    (commands_are_done_when_they_may_be, "command.allowed"),
    (refusals_are_told_once_in_a_while, "command.refusal"),
    (defaults_come_back_when_they_may,),
)

if __name__ == "__main__":
    main(CHECKS)
