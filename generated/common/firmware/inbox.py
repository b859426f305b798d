# Generated from templates/firmware/program/inbox.py: do not edit.
# Inputs: e2bc88f8e205447a
"""Taking in what arrives at a port, a limited share in each pass of the main loop: a flood must not hold it up."""

from time import ticks_diff

from micropython import const

_SIZE = const(256)  # bytes that one readinto() takes
_WORK = const(256)  # bytes that are searched for frames in a pass; to check a frame counts as much as its length
_PATIENCE_MS = const(500)  # for the end of a frame, where a port does not know better

# The places in the state of a link: frames_plain says more.
_FIRST = const(0)  # byte in the buffer that was not looked at
_END = const(1)  # of the buffer
_KEPT = const(12)
_WORKED = const(15)
_SHARE = const(16)
_COUNT = const(17)  # how many bytes of what is put in count


class Inbox:
    """Messages that arrive at a port.

    next(now_ms), at time.ticks_ms(), returns the next message, or None: nothing more arrived, or the pass has had its
    share, which is counted in the state of the link; who begins a pass sets that to 0.

    A datagram, which ports with `ends` read(), has whole frames: what is not whole at its end is given up at once, so
    that nobody's bytes become part of another one's frame; a port that has keep(link) brings what several streams sent,
    and takes that back until more of the same stream arrives. Other ports readinto() a buffer and may bring a frame in
    parts: it is given up when its end did not come within the time that the longest one takes, the `patience_ms`.
    """

    def __init__(self, port, link):
        self._port = port
        self._link = link
        self._state = link._state
        self._state[_SHARE] = _WORK
        self._patience_ms = getattr(port, "patience_ms", _PATIENCE_MS)
        self._total = 0  # bytes that arrived
        self._start = -1  # at which of them the frame begins that is not whole
        self._since_ms = 0  # when that was noticed
        self._read_ms = 0
        self._resume()

    def _resume(self):
        is_whole = getattr(self._port, "ends", None) is not None
        turn = self._messages(None if is_whole else bytearray(_SIZE))
        next(turn)
        self.next = turn.send

    def _messages(self, buffer):  # noqa: C901, PLR0912  calls are dear
        """Yield messages, and None where there is none in this pass, for ever; connection.py says why as a generator.

        Without a buffer what arrives are datagrams.
        """
        port, link, state = self._port, self._link, self._state
        put, receive = link.put, link.receive
        keep = getattr(port, "keep", None)
        is_open = False  # whether the link may find more in what it has
        try:
            now_ms = yield
            while True:
                message = None
                if is_open:
                    message = receive()
                    if message is None and state[_WORKED] < _WORK:
                        if buffer is None and state[_FIRST] < state[_END]:
                            if keep is None:
                                link.give_up()
                                continue
                            keep(link)
                        is_open = False
                if is_open:
                    is_open = state[_FIRST] != state[_END] or state[_KEPT] != 0
                    now_ms = yield message
                elif buffer is None:
                    data = port.read()
                    if data:
                        put(data)
                        is_open = True
                    else:
                        now_ms = yield
                else:
                    count = port.readinto(buffer)
                    if count:
                        self._total = (self._total + count) & 0x3FFFFFFF
                        self._read_ms = now_ms
                        state[_COUNT] = count
                        put(buffer)
                        is_open = True
                    elif state[_FIRST] != state[_END] and self._is_given_up(now_ms):
                        is_open = True
                    else:
                        now_ms = yield
        except BaseException:  # what is wrong with a port ends this pass, and nothing else
            self._resume()
            raise

    def _is_given_up(self, now_ms):
        """Give up the frame that is not whole, if its end does not come; return whether that was done."""
        start = (self._total - self._state[_END] + self._state[_FIRST]) & 0x3FFFFFFF
        if start != self._start:
            self._start = start
            self._since_ms = self._read_ms
        if ticks_diff(now_ms, self._since_ms) < self._patience_ms:
            return False
        self._link.give_up()
        return True
