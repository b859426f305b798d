# Generated from templates/tests/program/alone_checks.py: do not edit.
# Inputs: 809da31619d7a49f
"""Parts by themselves, with rows, devices and stations that a check makes: all they can do, asked for here or not."""

import errno
import struct
from binascii import hexlify

from program_bench import (
    IS_MICROPYTHON,
    SECOND_US,
    Flash,
    GroundStation,
    machine,
    main,
    messages,
    mock_time,
    needs,
    new_craft,
    run,
    run_passes,
)
from program_facts import ABSENT, COMPONENT_ID, LINKS_US, MEASURED, PARAMETERS, SENT, STEP_LIMIT_US, SYSTEM_ID, VERSION

import asyncio
import dialect
import rare_commands
import storage
import vehicle as vehicle_module
from mavlink import Link
from message import keep

try:
    import own_commands
except ImportError:  # there are no commands of the project's own
    own_commands = None

try:
    import twins
except ImportError:  # nobody looks whether others use its ids
    twins = None

try:
    import made_floats
except ImportError:  # all floats are made without the heap
    made_floats = None

ACCEPTED, DENIED, FAILED = dialect.MAV_RESULT_ACCEPTED, dialect.MAV_RESULT_DENIED, dialect.MAV_RESULT_FAILED
GOES_ON = 5  # MAV_RESULT_IN_PROGRESS, which not every program has
REJECTED, UNSUPPORTED = dialect.MAV_RESULT_TEMPORARILY_REJECTED, dialect.MAV_RESULT_UNSUPPORTED
NAN, INFINITE = float("nan"), float("inf")
UNKNOWN = -0x3FFFFFFF - 1
NUMBER = 31999  # of no command


class Thing:
    """Has the attributes that it is given."""

    def __init__(self, **attributes):
        for name, value in attributes.items():
            setattr(self, name, value)


class Texts:
    """Notes what is told, with its severity."""

    def __init__(self):
        self.told = []

    def __call__(self, *parts):
        """Note a text, without a severity."""
        self.told.append((None, " ".join([str(part) for part in parts])))

    def say(self, severity, text):
        """Note a text."""
        self.told.append((severity, text))


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
        row = ("act", "Title", None, False, False, (param,), (), ())
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
    row = ("act", "Title", None, False, False, long_params, int_params, (0, 6))
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
    vehicle, row = Doing(), row[:6] + ((), ())  # noqa: RUF005  MicroPython
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
        answer = _answer(vehicle, ("act", "Title", armed, False, False, (), (), ()), Asked())
        assert answer == (REJECTED if text else ACCEPTED, None), (armed, is_armed)
        assert vehicle.given == [()] * (not text)
        assert vehicle.texts.told == ([(error, text)] if text else [])
    row = ("act", "Title", None, True, False, (), (), ())
    for heard, result in (((255 << 8 | 190, 7), ACCEPTED), ((254 << 8 | 255, 0), DENIED), ((), DENIED)):
        vehicle = Doing()
        assert _answer(vehicle, row, Asked(), heard) == (result, None), heard
        assert len(vehicle.given) == (result == ACCEPTED)
        assert vehicle.texts.told == [(error, "Title: only for ground stations that are heard")] * (result == DENIED)
    row = ("act", "Title", None, False, True, (), (), ())
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
    row = ("act", "Title", None, False, False, (), (), ())
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


def _measured_board(craft, measured, raised):
    """Return a board of which the reading of a component raises what is first in `raised`, None for nothing."""
    name = "read_" + measured["component"] + "_adc"

    def reading(*about):
        error = raised.pop(0) if raised else None
        if error is not None:
            raise error
        return getattr(craft.board, name)(*about)

    return Thing(**{name: reading})


def boards_that_raise_are_survived():
    """A reading that raises has failed: it is told at the first of several, and the next one is taken as ever."""
    needs(MEASURED, "something that is measured")
    for measured in MEASURED:
        craft = new_craft()
        craft.texts, told = None, []
        component = getattr(craft.state, measured["component"])[0]
        update = getattr(craft.state, "update_" + measured["component"])
        craft.state._log = lambda *parts: told.append(" ".join([str(part) for part in parts]))  # noqa: B023
        raised = []
        board = _measured_board(craft, measured, raised)

        def turns(*errors):
            for error in errors:
                raised.append(error)  # noqa: B023
                getattr(craft.state, "update_" + measured["component"])(board)  # noqa: B023
                mock_time.advance_us(measured["period_us"])  # noqa: B023

        turns(None)
        known = getattr(component, measured["attribute"])
        assert known is not None, measured["component"]
        limit = measured["invalid_after"] or 0
        turns(*[ValueError("bus") for _ in range(max(limit - 1, 1))])
        assert limit < 2 or getattr(component, measured["attribute"]) == known, "it fails too seldom yet"
        found = [text for text in told if "cannot read" in text]
        assert len(found) == 1, told
        assert found[0].endswith(": bus"), found
        if limit:
            turns(OSError())
            assert getattr(component, measured["attribute"]) is None, limit
        turns(None, RuntimeError(), None)
        assert getattr(component, measured["attribute"]) == known
        found = [text for text in told if "cannot read" in text]
        assert len(found) == 2, told
        assert found[1].endswith(": RuntimeError"), found
        for stop in (KeyboardInterrupt, SystemExit):
            try:
                turns(stop())
            except stop:
                pass
            else:
                raise AssertionError("it is not stopped")
            assert getattr(craft.state, "update_" + measured["component"]) is not update
            turns(None)
            assert getattr(component, measured["attribute"]) == known


def a_meter_calibrates():
    """What is set is the multiplier with which the reading would be that of the meter; nothing without a reading."""
    needs(MEASURED, "something that is measured")
    for measured in MEASURED:
        needs(measured["multiplier_name"], "a parameter that is calibrated")
        craft = new_craft()
        component, name = getattr(craft.state, measured["component"])[0], measured["multiplier_name"]
        calibrate = getattr(craft.state, "calibrate_" + measured["component"])
        if measured["instances"] > 1:
            several = calibrate
            calibrate = lambda meter: several(meter, 0)  # noqa: B023, E731
        getattr(craft.state, "update_" + measured["component"])(craft.board)
        reading, old = getattr(component, measured["name"]), craft.parameters.get(name)
        for meter in (reading * 1.125, reading * 0.875, reading):
            assert calibrate(meter) is True, meter
            found = craft.parameters.get(name)
            assert abs(found / old - meter / reading) < 2e-3, (meter, found, old)
            if measured["latched"]:
                continue
            craft.parameters.set(name, old)
        before = craft.parameters.get(name)
        for meter in (None, 1e9, -1e9, NAN):
            assert calibrate(meter) is False, meter
            assert craft.parameters.get(name) == before
        setattr(component, measured["attribute"], None)
        assert calibrate(reading) is False
        assert craft.parameters.get(name) == before


def twins_are_known_by_chips_and_numbers():
    """Who tells of another chip under the same ids, or has a number of this vehicle, is told of, twice a minute."""
    needs(twins, "a look at others with the same ids")
    chip = hexlify(machine.unique_id())
    size = len(chip) + 2
    for places in ((4, 0), (4, None)):
        told = Texts()
        at_hand = Thing(component_id=7, link=Thing(sequence=9), stations=[], station=None)
        watch = twins.TwinWatch(at_hand, told, "COMPONENT", ((77, 3, size, places[1]), (78, 1, 2, 0)), "NUMBER", (2, 5))
        mock_time.set_ticks_us(0)

        def heard(number, component, wire):
            before = len(told.told)  # noqa: B023
            watch.look_at(Thing(ID=number, wire=wire, source_sequence=0), component)  # noqa: B023
            return [text for _, text in told.told[before:]]  # noqa: B023

        own = bytes(3) + chip + bytes(2)
        assert heard(77, 7, own) == []
        assert heard(78, 7, b"\x00" + chip[:2]) == []
        assert heard(79, 7, bytes(99)) == []
        expected = ["warning: COMPONENT 7 is in use by another: change one"]
        for place in range(3, 3 + size):
            mock_time.advance_us(30000000)
            other = own[:place] + bytes([own[place] ^ 1]) + own[place + 1 :]
            assert heard(77, 7, other) == expected, place
            mock_time.advance_us(29999000)
            assert heard(77, 7, other) == [], "it was told just now"
        for number, texts in ((2, 1), (3, 0), (5, 1), (0, 0)):
            mock_time.advance_us(30000000)
            found = heard(77, 9, bytes([number]) + bytes(99))
            is_told = texts if places[1] is not None else 0
            assert found == [f"warning: NUMBER {number} is in use by component 9: change one"] * is_told, (
                number,
                found,
            )
    mock_time.set_ticks_us(0)


def frames_that_come_back_are_own():
    """A HEARTBEAT with a number that one of the links has sent of late is its own: two others in a row are told."""
    needs(twins, "a look at others with the same ids")
    at_hand = Thing(component_id=7, link=Thing(sequence=70), stations=[], station=Thing(sequence=0))
    at_hand.stations = [at_hand.station, Thing(sequence=200)]
    for sequence, is_own in (
        (69, True),
        (6, True),
        (5, False),
        (70, False),
        (199, True),
        (136, True),
        (135, False),
        (200, False),
    ):
        told = Texts()
        watch = twins.TwinWatch(at_hand, told, "COMPONENT", ())
        own, other = (Thing(ID=messages.Heartbeat.ID, wire=b"", source_sequence=each) for each in (69, sequence))
        counts = []
        for each, component in ((other, 8), (other, 7), (own, 7), (other, 7), (other, 8), (other, 7)):
            watch.look_at(each, component)
            counts.append(len(told.told))
        assert counts == [0, 0, 0, 0, 0, 0 if is_own else 1], (sequence, counts)


def what_a_table_takes_is_told():
    """What a table that takes a message finds wrong is told, and code that waits for it is called; each for itself."""
    opened, message = vehicle_module.open_link, messages.Ping(unknown=False)

    def open_link(port, known=(), *more):
        return opened(port, [message if each.ID == message.ID else each for each in known], *more)

    vehicle_module.open_link = open_link
    try:
        craft = new_craft()
    finally:
        vehicle_module.open_link = opened
    own, station = craft.connections[0], craft.ground_station()
    for found, has_code, notes in (
        (0, True, []),
        (1, True, ["told", "called"]),
        (2, False, ["told"]),
        (-1, True, ["called"]),
        (-1, False, []),
    ):
        noted = []
        table = Thing(tell=lambda: noted.append("told"), called=None)  # noqa: B023
        if has_code:
            table.called = lambda: noted.append("called")  # noqa: B023
        keep(message, "_take", lambda _now_ms: found)  # noqa: B023
        own.tables[message.ID] = table
        station.send(messages.Ping, target_system=SYSTEM_ID)
        run_passes(craft, 4)
        assert noted == notes, (found, has_code, noted)
        assert own.faults == 0, craft.said()


def _old_craft():
    """Return a vehicle with a link that speaks MAVLink 1, and the station behind it."""
    opened = vehicle_module.open_link
    vehicle_module.open_link = lambda port, known=(), *_more: Link(port, SYSTEM_ID, COMPONENT_ID, 1, known)
    try:
        craft = new_craft()
    finally:
        vehicle_module.open_link = opened
    assert craft.connections[0].link.version == 1
    return craft, craft.ground_station(1)


def what_the_first_version_cannot_carry_is_left_out():
    """Over MAVLink 1 long texts are cut, refusals without a message there are left out, and the rest is answered."""
    craft, station = _old_craft()
    connection = craft.connections[0]
    for number in SENT:
        if number > 255:  # a program with such messages has no link of this kind
            connection.streams.set_interval(number, -1)
    run(craft, 2 * SECOND_US, LINKS_US)
    craft.port.frames, connection.faults = [], 0
    craft.texts("warning: " + "0123456789" * 7)
    craft.texts("warning: short")
    run(craft, SECOND_US, LINKS_US)
    found = [(each.severity, each.text) for each in station.received(messages.Statustext)]
    assert found == [(dialect.MAV_SEVERITY_WARNING, "0123456789" * 5), (dialect.MAV_SEVERITY_WARNING, "short")], found
    run(craft, 2 * SECOND_US, LINKS_US)
    frames, craft.port.frames = craft.port.frames, []
    assert [frame[0] for frame in frames] == [0xFE] * len(frames)
    if PARAMETERS:
        station.send(messages.ParamRequestRead, param_id="NO_SUCH", param_index=-1)
        station.send(messages.ParamSet, param_id="NO_SUCH", param_value=1)
        station.send(messages.ParamRequestRead, param_id=PARAMETERS[0]["name"], param_index=-1)
    ask = messages.FileTransferProtocol(unknown=False)
    ask.update(target_system=SYSTEM_ID, target_component=COMPONENT_ID)
    station.link.send(ask)
    station.send(messages.Ping, seq=8, target_system=0, target_component=0)
    run(craft, SECOND_US, LINKS_US)
    kinds = [type(each) for each in station.received(messages.ParamValue, messages.Ping, messages.FileTransferProtocol)]
    assert kinds == ([messages.ParamValue] if PARAMETERS else []) + [messages.Ping], kinds
    assert (connection.faults, connection.lost_replies, connection.link.tx_errors) == (0, 0, 0), craft.said()


class Level:
    """Stands in for the module micropython: a level that can be set."""

    def __init__(self):
        self.level = 1

    def opt_level(self, *level):
        """Return the level, or set it."""
        if not level:
            return self.level
        (self.level,) = level
        return None


def the_board_is_prepared():
    """Garbage is collected often while the vehicle is made, and modules are compiled at the level that is set."""
    import main as program  # noqa: PLC0415  it is about to be looked at

    heap, compiler, thresholds = program.gc, program.micropython, []
    program.gc = Thing(threshold=thresholds.append, mem_free=lambda: 6400)
    program.micropython = Level()
    try:
        program.collect_often(True)
        program.collect_often(False)
        assert thresholds == [200, -1], thresholds
        assert (program.compile_at(3), program.micropython.level) == (1, 3)
        assert (program.compile_at(0), program.micropython.level) == (3, 0)
        program.gc = program.micropython = Thing()
        program.collect_often(True)
        assert program.compile_at(2) == 2, "there is no level"
    finally:
        program.gc, program.micropython = heap, compiler


def floats_are_made():
    """Those that a machine has to make, with their factor, in both sizes and at any place."""
    needs(made_floats, "a float that is made")
    for code, size in (("<f", 4), ("<d", 8)):
        for value, numerator, denominator in ((3, 1, 2), (-7, 5, 4), (0, 1, 3), (123456, 1, 64)):
            wire = bytearray(b"\x5a" * 20)
            made_floats.make_float(code, wire, 5, value, numerator, denominator)
            assert struct.unpack_from(code, wire, 5)[0] == value * numerator / denominator
            assert bytes(wire[:5] + wire[5 + size :]) == b"\x5a" * (20 - size)


def the_vehicle_runs_until_it_is_stopped():
    """It is made while garbage is collected often, and runs; its motors stop, whatever ends it."""
    import main as program  # noqa: PLC0415  it is about to be looked at

    kept = program.collect_often, program.new_vehicle, program.asyncio
    try:
        for error in (None, ValueError, SystemExit):
            noted = []

            def run(told):
                noted.append(told)  # noqa: B023
                if error is not None:  # noqa: B023
                    raise error  # noqa: B023

            made = Thing(run=lambda: "it runs", halt_motors=lambda: noted.append("it is stopped"))  # noqa: B023
            program.collect_often = noted.append
            program.new_vehicle = lambda: noted.append("it is made") or made  # noqa: B023
            program.asyncio = Thing(run=run)
            try:
                program.main()
                ended = None
            except (ValueError, SystemExit) as raised:
                ended = type(raised)
            assert ended is error
            stops = ["it is stopped"] * hasattr(vehicle_module.Vehicle, "halt_motors")
            assert noted == [True, "it is made", False, "it runs"] + stops, noted  # noqa: RUF005  MicroPython
    finally:
        program.collect_often, program.new_vehicle, program.asyncio = kept


def slow_steps_of_saves_are_told():
    """The longest one, if it takes longer than it may; as long as that is no matter."""
    needs(PARAMETERS, "parameters")
    for took, count in ((STEP_LIMIT_US - 1, 0), (STEP_LIMIT_US, 0), (STEP_LIMIT_US + 1, 1)):
        craft = new_craft()
        step, times = craft.storage.step, [1, took, 5]

        def save_step():
            step()  # noqa: B023
            return times.pop(0) if times else 0  # noqa: B023

        craft._save_step = save_step
        if IS_MICROPYTHON:
            asyncio.new_event_loop()
        asyncio.run(craft._save())
        told = craft.said("a step of a save took us")
        assert [text for _, text in told] == [f"a step of a save took us: {took}"] * count, told


class Counted:
    """Opens files of a flash in memory, and counts those that are open; writing may fail."""

    def __init__(self, fails):
        self.flash = Flash()
        self.flash.files = {}
        self.fails = fails
        self.is_open = 0
        self.opened = 0

    def open(self, path, mode):
        """Open a file."""
        file = self.flash.open(path, mode)
        self.opened += 1
        self.is_open += 1
        return Open(self, file)


class Open:
    """A file that is open until it is closed."""

    def __init__(self, counted, file):
        self._counted = counted
        self.read = file.read
        self._write = file.write

    def __enter__(self):
        return self

    def __exit__(self, *_raised):
        self.close()

    def write(self, data):
        """Write, or fail."""
        if self._counted.fails:
            raise OSError(errno.EIO, "broken")
        return self._write(data)

    def close(self):
        """Be open no more."""
        self._counted.is_open -= 1


def files_are_closed():
    """Whatever becomes of a save: what it has opened counts only once it is closed, and there are few at a time."""
    for fails in (False, True):
        counted = Counted(fails)
        storage.open = counted.open
        own = storage.Storage(("a", "b"), 8)
        own.load()
        assert counted.is_open == 0
        own.begin(b"a payload of several pieces")
        while own.step():
            assert counted.is_open in (0, 1)
        assert counted.is_open == 0, fails
        assert counted.opened > 0
        assert (own.problem is not None) == fails
        assert (own.load() is None) == fails
        assert counted.is_open == 0
    Flash()


def a_link_without_work_rests():
    """A pass in which nothing is left to do says so; one that has more than it may take in says that, too."""
    craft = new_craft()
    own, station = craft.connections[0], craft.ground_station()
    run(craft, SECOND_US, LINKS_US)
    for number in SENT:
        own.streams.set_interval(number, -1)
    run(craft, SECOND_US, LINKS_US)
    for _ in range(5):
        assert not own.run(mock_time.ticks_ms()), "nothing is left"
        mock_time.advance_us(LINKS_US)
    for _ in range(4 * craft.MESSAGES):
        station.send(messages.Ping, target_system=0, target_component=0)
    assert own.run(mock_time.ticks_ms()), "more has arrived"
    for _ in range(40):
        own.run(mock_time.ticks_ms())
        mock_time.advance_us(LINKS_US)
    assert not own.run(mock_time.ticks_ms())
    assert len(station.received(messages.Ping)) > 0


LIST, COUNT, CLEAR, REQUEST, REQUEST_INT, ACK, LOGS, LOG = 43, 44, 45, 40, 51, 47, 117, 118
ABSENCES = (  # a question with what its payload has at some places, and the same of the answer
    (LIST, {2: 1}, COUNT, {0: 0, 1: 0, 4: 1}),
    (LIST, {2: 255}, COUNT, {0: 0, 1: 0, 4: 255}),
    (COUNT, {0: 0, 1: 0, 4: 2}, ACK, {2: 0, 3: 2}),
    (COUNT, {0: 1, 1: 0, 4: 0}, ACK, {2: 3, 3: 0}),
    (COUNT, {0: 0, 1: 1, 4: 7}, ACK, {2: 3, 3: 7}),
    (COUNT, {0: 255, 1: 255, 4: 1}, ACK, {2: 3, 3: 1}),
    (CLEAR, {2: 3}, ACK, {2: 0, 3: 3}),
    (REQUEST, {4: 2}, ACK, {2: 13, 3: 2}),
    (REQUEST_INT, {4: 1}, ACK, {2: 13, 3: 1}),
    (LOGS, {0: 1, 2: 9}, LOG, dict.fromkeys(range(14), 0)),
)


def absences_say_what_is_true():
    """Lists are empty, take nothing, and have no item; a list that is sent without items is taken. Of the same kind."""
    needs(ABSENT, "questions about what the vehicle does not have")
    needs(VERSION == 2, "messages with kinds of lists")
    import absences  # noqa: PLC0415  as the firmware does

    craft = new_craft()
    station = craft.ground_station()
    run_passes(craft, 20)
    for question, asked, answer, expected in ABSENCES:
        if (question, answer) not in ABSENT:
            continue
        message = absences.Bare(question)
        for place, byte in asked.items():
            message.wire[place] = byte
        for place, target in zip(message.TARGETS, (SYSTEM_ID, COMPONENT_ID)):  # noqa: B905  MicroPython
            message.wire[place] = target
        craft.port.frames = []
        station.link.send(message)
        run_passes(craft, 4)
        found = [frame for frame in craft.port.frames if frame[7] | frame[8] << 8 | frame[9] << 16 == answer]
        assert len(found) == 1, (question, found)
        payload = found[0][10:-2] + bytes(20)
        assert {place: payload[place] for place in expected} == expected, (question, asked, payload)


def answers_are_for_who_asks():
    """What has a target has the ids of who asked, of whatever system and component that is."""
    craft = new_craft()
    run_passes(craft, 20)
    for system, component in ((201, 45), (255, 190), (7, 1)):
        station = GroundStation(craft.port, VERSION, system, component)
        station.command(410)
        station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, messages.Heartbeat.ID, 1000000)
        station.send(messages.Ping, target_system=0, target_component=0)
        if hasattr(messages, "Timesync"):
            station.send(messages.Timesync, ts1=5)
        if PARAMETERS:
            station.send(messages.ParamRequestRead, param_id="NO_SUCH", param_index=-1)
            station.send(messages.ParamSet, param_id="NO_SUCH", param_value=1)
        run_passes(craft, 12)
        found = [each for each in station.received() if "target_system" in each.names()]
        assert len(found) >= 3, found
        for each in found:
            assert (each.target_system, each.target_component) == (system, component), each
    assert craft.connections[0].faults == 0, craft.said()


CHECKS = (
    (parameters_of_commands_are_looked_at, "command.params"),
    (positions_of_commands_are_global, "command.params"),
    (commands_are_done_when_they_may_be, "command.allowed"),
    (refusals_are_told_once_in_a_while, "command.refusal"),
    (defaults_come_back_when_they_may,),
    (boards_that_raise_are_survived,),
    (a_meter_calibrates,),
    (twins_are_known_by_chips_and_numbers, "services.twins"),
    (frames_that_come_back_are_own, "services.twins"),
    (what_a_table_takes_is_told,),
    (floats_are_made,),
    (what_the_first_version_cannot_carry_is_left_out, "services.links"),
    (the_board_is_prepared,),
    (the_vehicle_runs_until_it_is_stopped,),
    (slow_steps_of_saves_are_told, "storage.set"),
    (files_are_closed,),
    (a_link_without_work_rests, "services.links"),
    (absences_say_what_is_true,),
    (answers_are_for_who_asks, "services.links"),
)

if __name__ == "__main__":
    main(CHECKS)
