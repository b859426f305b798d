"""Checks of access: signed links obey the right key alone, and nothing twice; listed ones obey listed stations."""

import asyncio

try:
    from signing import MINUTE, Signing
except ImportError:  # no link is signed
    Signing = None

from mavlink import Link
from program_bench import (
    OTHER_SYSTEM,
    Flash,
    GroundStation,
    Port,
    live,
    main,
    messages,
    needs,
    needs_arming,
    new_craft,
    run_passes,
)
from program_facts import ACCESS, FORCE_ARM

import dialect

KEY = bytes(range(32))
OTHER = bytes(32 * [7])
NOBODY = 410  # a command that no vehicle knows: who is heard gets an answer all the same


class SignedStation(GroundStation):
    """A ground station that signs; `sent` are the frames that it sent."""

    def __init__(self, port, key, link_id=9, component_id=190):
        GroundStation.__init__(self, port)
        self.signing = Signing(key, link_id)
        self.link = Link(self, 255, component_id, 2, messages.ALL, signing=self.signing)
        self.sent = []

    def write(self, frame):
        """Keep what is sent, too."""
        self.sent.append(bytes(frame))
        return GroundStation.write(self, frame)


class Named(Port):
    """A port that is called as a link of the board."""

    def __init__(self, name):
        Port.__init__(self)
        self.name = name


def _scene(name, key=KEY, flash=None):
    """Return a vehicle with a port of that name, with a key in its flash, or, for None, with what is there."""
    flash = flash or Flash()
    if key is not None and ACCESS["signed"]:
        flash.files[ACCESS["key"]] = bytes([ord("0123456789abcdef"[half]) for each in key for half in divmod(each, 16)])
    return new_craft(ports=[Named(name)], flash=flash)


def _is_obeyed(craft, station):
    """Return whether a command of a station is answered, so that the station understands it."""
    station.received()
    station.command(NOBODY)
    run_passes(craft, 4)
    return bool(station.received(messages.CommandAck))


def _wait(milliseconds, craft):
    """Return a story in which time passes, and ports forget all frames but the last: minutes have many of them."""

    async def story():
        for _ in range(0, milliseconds, 1000):
            await asyncio.sleep_ms(1000)
            for connection in craft.connections:
                connection.port.frames = connection.port.frames[-1:]

    return story


def _talk(station):
    """Return a story in which a station sends a command each second."""

    async def story():
        for _ in range(100):
            station.command(NOBODY)
            await asyncio.sleep_ms(1000)
            station.port.frames = []

    return story


def _saves(craft, name):
    """Return how often the timestamps of a link were kept."""
    path = f"{ACCESS['key']}.{name}"
    return len([each for each, content in craft.flash.operations if each == path and content])


def _signed():
    needs(ACCESS["signed"], "a link that is signed")
    return ACCESS["signed"][0]


def _setup():
    needs(ACCESS["setup"], "a link over which a key comes")
    return ACCESS["setup"][0]


def who_has_the_key_is_obeyed():
    """On each signed link, and all that goes out there is signed with the same key."""
    _signed()
    for name in ACCESS["signed"]:
        craft = _scene(name)
        station = SignedStation(craft.port, KEY)
        assert _is_obeyed(craft, station), name
        assert station.link.signed == station.link.received > 0
        assert station.link.refused == 0


def unsigned_frames_are_not_obeyed():
    """Nor those that are signed with another key, or changed behind the signature."""
    name = _signed()
    craft = _scene(name)
    assert not _is_obeyed(craft, craft.ground_station())
    assert not _is_obeyed(craft, SignedStation(craft.port, OTHER))
    link = craft.connections[0].link
    assert link.refused == 2
    craft.ground_station().send(messages.Heartbeat, type=dialect.MAV_TYPE_GCS)
    run_passes(craft, 4)
    assert craft.connections[0].services.ground_station is None
    assert link.refused == 3
    station = SignedStation(craft.port, KEY)
    station.port = Port()
    station.command(NOBODY)
    for at in (-1, -8, -13):  # the hash, the timestamp, the link id
        frame = bytearray(station.sent[0])
        frame[at] ^= 1
        craft.port.arrives(frame)
    run_passes(craft, 4)
    assert (link.refused, link.signed) == (6, 0)


def only_who_has_the_key_can_arm():
    """Even by force."""
    name = _signed()
    needs_arming()
    craft = _scene(name)
    stations = (GroundStation(craft.port), SignedStation(craft.port, OTHER), SignedStation(craft.port, KEY))
    for station in stations:
        station.command(dialect.MAV_CMD_COMPONENT_ARM_DISARM, 1, FORCE_ARM)
        run_passes(craft, 4)
        assert craft.is_armed is (station is stations[-1])


def nothing_counts_twice():
    """A frame that arrives again is refused; so it is after a restart, and what is older, too."""
    name = _signed()
    craft = _scene(name)
    station = SignedStation(craft.port, KEY)
    assert _is_obeyed(craft, station)
    assert _is_obeyed(craft, station)
    live(craft, _wait(11000, craft))  # it is kept by itself
    for again in (craft, _scene(name, flash=craft.flash)):
        link = again.connections[0].link
        before = link.signed
        for frame in station.sent:
            again.port.arrives(frame)
        run_passes(again, 4)
        assert link.signed == before
        assert link.refused == 2
    station.port = again.port
    assert _is_obeyed(again, station)


def _put_ahead(station, ticks):
    """Let a station sign with timestamps that are ahead of any clock here."""
    signing = station.signing
    signing.timestamp = max(signing.timestamp, signing._now(), 0) + ticks


def timestamps_go_on_after_a_restart():
    """Frames that a vehicle signs are always newer than those signed before, whatever its clock says."""
    name = _signed()
    craft = _scene(name)
    station = SignedStation(craft.port, KEY)
    _put_ahead(station, 60 * MINUTE)  # of all clocks
    assert _is_obeyed(craft, station)
    live(craft, _wait(61000, craft))
    newest = int.from_bytes(craft.port.frames[-1][-12:-6], "little")
    again = _scene(name, flash=craft.flash)
    run_passes(again, 400)
    assert again.port.frames
    oldest = int.from_bytes(again.port.frames[0][-12:-6], "little")
    assert oldest > newest


def who_is_ahead_is_followed():
    """Each frame that goes out is newer than all that were accepted: a station whose clock is ahead understands it."""
    craft = _scene(_signed())
    station = SignedStation(craft.port, KEY)
    assert _is_obeyed(craft, station)
    _put_ahead(station, 60 * MINUTE)
    assert _is_obeyed(craft, station)
    run_passes(craft, 400)
    assert int.from_bytes(craft.port.frames[-1][-12:-6], "little") > station.signing.timestamp


def each_sender_counts_for_itself():
    """Of one system each component, on each of its links: what is older than a frame of another one is new."""
    for link_id, component_id in ((2, 190), (1, 191)):
        craft = _scene(_signed())
        first, second = SignedStation(craft.port, KEY, 1), SignedStation(craft.port, KEY, link_id, component_id)
        _put_ahead(first, MINUTE // 2)
        for station in (first, second, first):
            assert _is_obeyed(craft, station), (link_id, component_id, station is first)


def without_a_key_nobody_is_obeyed():
    """No file, or one with something else: a text says so, and frames go out all the same."""
    name = _signed()
    for content in (None, b"", b"00" * 31, b"xy" * 32, bytes(32)):
        flash = Flash()
        del flash.files[ACCESS["key"]]
        if content is not None:
            flash.files[ACCESS["key"]] = content
        craft = _scene(name, None, flash)
        assert craft.said(f"{ACCESS['key']} "), content
        for station in (craft.ground_station(), SignedStation(craft.port, KEY), SignedStation(craft.port, bytes(32))):
            assert not _is_obeyed(craft, station)
        run_passes(craft, 400)
        assert craft.port.frames
        assert craft.connections[0].faults == 0


def timestamps_are_kept_seldom():
    """Once in ten seconds while frames are accepted, once a minute while they go out only."""
    name = _signed()
    craft = _scene(name)
    live(craft, _talk(SignedStation(craft.port, KEY)))
    saves = _saves(craft, name)
    assert 8 <= saves <= 10, saves
    live(craft, _wait(200000, craft))
    assert 3 <= _saves(craft, name) - saves <= 4


def nothing_is_kept_while_armed():
    """Flash stands still where it is written: it waits until the vehicle is disarmed."""
    name = _signed()
    needs_arming()
    craft = _scene(name)
    assert craft.arm(force=True) is None
    live(craft, _talk(SignedStation(craft.port, KEY)))
    assert _saves(craft, name) == 0
    craft.disarm()
    live(craft, _wait(1000, craft))
    assert _saves(craft, name) == 1


def a_flash_that_fails_is_survived():
    """A text says so, and frames are judged as before; a damaged file is told at the start."""
    name = _signed()
    craft = _scene(name)
    station = SignedStation(craft.port, KEY)
    craft.flash.fail_after = 0
    assert _is_obeyed(craft, station)
    live(craft, _wait(61000, craft))
    assert craft.said("timestamps of " + name)
    assert _is_obeyed(craft, station)
    craft.flash.fail_after = None
    live(craft, _wait(61000, craft))
    path = f"{ACCESS['key']}.{name}"
    whole = craft.flash.files[path]
    craft.flash.files[path] = whole[:-1]
    again = _scene(name, flash=craft.flash)
    assert again.said(path)
    station.port = again.port
    assert _is_obeyed(again, station)


def a_new_key_comes_over_a_cable():
    """It counts at once and after a restart, and the old one does not any more; it is no secret that goes out."""
    name, cable = _signed(), _setup()
    flash = Flash()
    craft = new_craft(ports=[Named(name), Named(cable)], flash=flash)
    trusted = GroundStation(craft.connections[1].port)
    old, new = SignedStation(craft.port, bytes(32)), SignedStation(craft.port, OTHER)
    assert _is_obeyed(craft, old)
    assert not _is_obeyed(craft, new)
    trusted.send(messages.SetupSigning, secret_key=OTHER, initial_timestamp=5)
    run_passes(craft, 4)
    assert craft.said("links have a new key")
    assert not _is_obeyed(craft, old)
    assert _is_obeyed(craft, new)
    again = new_craft(ports=[Named(name), Named(cable)], flash=flash)
    new.port = again.port
    new.signing.timestamp += MINUTE  # it has heard the vehicle, which goes on a minute later after each start
    assert _is_obeyed(again, new)
    assert not [frame for frame in trusted.port.frames if OTHER in frame]


def a_key_that_comes_again_takes_nothing_back():
    """With an earlier timestamp, too, what goes out stays newer than all before: stations refuse what is older."""
    name, cable = _signed(), _setup()
    craft = new_craft(ports=[Named(name), Named(cable)], flash=_scene(name).flash)
    station, trusted = SignedStation(craft.port, KEY), GroundStation(craft.connections[1].port)
    _put_ahead(station, 60 * MINUTE)
    assert _is_obeyed(craft, station)
    trusted.send(messages.SetupSigning, secret_key=KEY, initial_timestamp=5)
    run_passes(craft, 4)
    assert craft.said("links have a new key")
    craft.port.frames = []
    run_passes(craft, 400)
    oldest = min([int.from_bytes(frame[-12:-6], "little") for frame in craft.port.frames])
    assert oldest > station.signing.timestamp, "before the station is heard again"
    assert _is_obeyed(craft, station)


def no_key_comes_otherwise():
    """Not over another link, not for another system, and not an empty one, which would switch signing off."""
    name, cable = _signed(), _setup()
    craft = new_craft(ports=[Named(name), Named(cable)], flash=_scene(name).flash)
    station, trusted = SignedStation(craft.port, KEY), GroundStation(craft.connections[1].port)
    station.send(messages.SetupSigning, secret_key=OTHER)
    craft.ground_station().send(messages.SetupSigning, secret_key=OTHER)
    trusted.send(messages.SetupSigning, secret_key=OTHER, target_system=OTHER_SYSTEM)
    trusted.send(messages.SetupSigning, secret_key=bytes(32))
    run_passes(craft, 8)
    assert craft.said("links stay signed")
    assert not craft.said("links have a new key")
    assert _is_obeyed(craft, station)


def no_key_comes_while_armed():
    """The one that controls a vehicle that moves is not taken away."""
    name, cable = _signed(), _setup()
    needs_arming()
    craft = new_craft(ports=[Named(name), Named(cable)], flash=_scene(name).flash)
    station, trusted = SignedStation(craft.port, KEY), GroundStation(craft.connections[1].port)
    assert craft.arm(force=True) is None
    trusted.send(messages.SetupSigning, secret_key=OTHER)
    run_passes(craft, 4)
    assert craft.said("a new key is refused while armed")
    assert _is_obeyed(craft, station)


def only_listed_systems_are_heard():
    """On a listed link; what others send changes nothing, and is counted."""
    needs(ACCESS["listed"], "a link with listed stations")
    for name in ACCESS["listed"]:
        craft = _scene(name)
        for system in (1, 2, 100, 254, 255):
            station = GroundStation(craft.port, system_id=system, component_id=77)
            assert _is_obeyed(craft, station) is (system in ACCESS["stations"]), system
        assert craft.connections[0].inbox.refused > 0


CHECKS = (
    (who_has_the_key_is_obeyed, "access.signed"),
    (unsigned_frames_are_not_obeyed, "access.signed"),
    (only_who_has_the_key_can_arm, "access.signed"),
    (nothing_counts_twice, "access.replay"),
    (timestamps_go_on_after_a_restart, "access.replay"),
    (who_is_ahead_is_followed, "access.signed"),
    (each_sender_counts_for_itself, "access.replay"),
    (without_a_key_nobody_is_obeyed, "access.keyless"),
    (timestamps_are_kept_seldom, "access.replay"),
    (nothing_is_kept_while_armed, "access.replay"),
    (a_flash_that_fails_is_survived, "access.replay"),
    (a_new_key_comes_over_a_cable, "access.setup"),
    (a_key_that_comes_again_takes_nothing_back, "access.setup"),
    (no_key_comes_otherwise, "access.setup"),
    (no_key_comes_while_armed, "access.setup"),
    (only_listed_systems_are_heard, "access.listed"),
)

if __name__ == "__main__":
    main(CHECKS)
