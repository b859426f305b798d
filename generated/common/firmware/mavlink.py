# Generated from templates/codec/mavlink.py: do not edit.
# Inputs: ebbabe14fc3811c1
"""One end of a MAVLink connection: it sends messages over a stream and turns into messages what is received."""

from receiver import Receiver
from sender import LONGEST_PAYLOAD, Sender


class Link(Sender, Receiver):
    """Sends and receives, in MAVLink 2 or 1; frames of both are understood.

    `stream` needs a method write(bytes) only: what arrives is given to feed(). `messages` are those that feed()
    knows, see Receiver. `longest` is the longest payload that is sent, `lengths` are those that go out, see Sender.
    `signing` signs what goes out and refuses what is not signed with the same key, see signing.Signing.
    """

    def __init__(
        self,
        stream,
        system_id=1,
        component_id=1,
        version=2,
        messages=(),
        longest=LONGEST_PAYLOAD,
        signing=None,
        lengths=None,
    ):
        Sender.__init__(self, stream, system_id, component_id, version, longest, signing, lengths)
        Receiver.__init__(self, messages, signing)

    # Found here, they are found sooner than in the classes above, which counts where microseconds do.
    send = Sender.send
