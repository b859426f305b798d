"""Links that are signed: where their key comes from, and how their timestamps outlive a restart.

The key is a file with 64 hexadecimal digits. Beside it lies a file with the timestamps of each link, so that no frame
counts a second time after a restart. What arrived after the last save can, once: a save is ten seconds ago at most, but
longer while the vehicle is armed, for flash stands still where it is written.
"""

import os
import time
from binascii import hexlify, unhexlify

from micropython import const
from signing import Signing, load

_HEARD_MS = const(10000)  # timestamps are kept so soon after a frame was accepted
_SENT_MS = const(60000)  # and so soon while frames only go out: load() goes on a minute later


class Access:
    """Signs and judges the frames of each link of `links`, which are (name, number).

    `path` is the file of the key. Without a right one the links have a key that nobody knows, and so obey nobody.
    """

    def __init__(self, path, links, log):
        self._path = path
        self._log = log
        self._key = self._read_key(links)
        self._signings = {name: self._restored(name, number) for name, number in links}
        self._kept_ms = time.ticks_ms()
        self._heard = 0

    def signing(self, name):
        """Return what signs and judges the frames of a link; None for one that is open."""
        return self._signings.get(name)

    def keep(self):
        """Keep the timestamps, where that is due. It writes into flash, and raises nothing."""
        passed_ms = time.ticks_diff(time.ticks_ms(), self._kept_ms)
        if passed_ms >= _SENT_MS or (passed_ms >= _HEARD_MS and self._accepted() != self._heard):
            self.save()

    def save(self):
        """Keep the timestamps of each link."""
        self._kept_ms = time.ticks_ms()
        self._heard = self._accepted()
        for name, signing in self._signings.items():
            try:
                signing.save(self._path + "." + name)
            except OSError as error:
                self._log("error: timestamps of", name, "are not kept:", repr(error))

    def replace(self, key, timestamp):
        """Take another key from now on; frames that are signed with the old one do not count any more."""
        try:
            with open(self._path + ".new", "wb") as file:
                file.write(hexlify(key))
            os.rename(self._path + ".new", self._path)
        except OSError as error:
            self._log("error: the new key is not kept:", repr(error))
            return
        for signing in self._signings.values():
            signing.renew(key, timestamp)
        self.save()
        self._log("notice: links have a new key:", ", ".join(self._signings))

    def _accepted(self):
        return sum([signing.accepted for signing in self._signings.values()])

    def _read_key(self, links):
        try:
            with open(self._path, "rb") as file:
                key = unhexlify(file.read(80).strip())
            problem = None if len(key) == 32 else "has no 64 digits"
        except OSError:
            problem = "is missing"
        except ValueError:
            problem = "has other characters than hexadecimal digits"
        if problem is None:
            return key
        self._log(f"warning: {self._path} {problem}:", ", ".join([name for name, _ in links]), "obeys nobody")
        return os.urandom(32)

    def _restored(self, name, number):
        """Return what goes on where the last save was; that of another key has a timestamp to begin with."""
        timestamp = 0
        try:
            signing = load(self._path + "." + name)
            if signing.key == self._key and signing.link_id == number:
                return signing
            timestamp = signing.timestamp
        except ValueError as error:
            self._log("warning:", error, "and old frames may count again")
        except OSError:
            pass  # it is the first start
        return Signing(self._key, number, timestamp)
