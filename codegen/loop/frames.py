"""The work of sending messages, and the messages that are due together."""

from collections.abc import Iterable

from codegen.loop.parts import Part, Work
from codegen.loop.pass_share import messages_of_a_pass
from codegen.model.price import frame_size, on_by_default, sent_messages
from codegen.model.program import Program
from codegen.model.system import PopulatedMessage, System

_HEARD_IN_A_PASS = 2
"""So many messages that arrive are handled in a pass on a link, as templates/firmware/program/connection.py has it."""


def streamed(system: System) -> tuple[PopulatedMessage, ...]:
    """Return the messages that streams send by default, in the order in which they go out."""
    return tuple(message for message in sent_messages(system) if message.stream and message.stream.default_rate)


def message_work(message: PopulatedMessage, system: System, *, most: bool = False) -> Work:
    """Return what it takes to send a message once: about each instance that is on by default, or about all of them."""
    protocol = system.spec.project.protocol
    on = on_by_default(message.component, system)
    sizes = [
        int(frame_size(message, number, protocol).high) for number in range(message.instances) if most or on[number]
    ]
    frames = len(sizes) * message.pages
    values = sum(answer.covers.count for answer in message.answers if answer.always is None)
    return Work(
        {
            Part.MESSAGE: 1,
            Part.FRAME: frames,
            Part.BYTE: sum(sizes) * message.pages,
            Part.VALUE: values * frames,
        }
    )


def sent_together(messages: Iterable[PopulatedMessage], system: System, program: Program) -> Work:
    """Return what a pass of a link takes in which these messages are sent, and nothing arrives."""
    works = [message_work(message, system) for message in messages]
    return sum(works, _looked(system)) + _ending(program, len(works))


def heard_work(program: Program, heard: int = 1) -> Work:
    """Return what a pass of a link takes in which so many messages arrive, and nothing is due."""
    return Work({Part.HEARD: heard}) + _ending(program, heard)


def due_work(system: System, program: Program, *, most: bool = False) -> Work:
    """Return what a station takes at which everything is due at once that streams send by default.

    So many messages as a pass sends, of all of them the dearest. ``most``: everything that there is is sent.
    """
    return _sent_work(system, program, most=most)


def busiest_works(system: System, program: Program) -> tuple[Work, ...]:
    """Return what the fullest passes of a link take: with none, one, ... of their messages being one that arrives."""
    share = messages_of_a_pass(program)
    return tuple(
        _sent_work(system, program, most=True, heard=heard) for heard in range(min(share, _HEARD_IN_A_PASS) + 1)
    )


def _sent_work(system: System, program: Program, *, most: bool, heard: int = 0) -> Work:
    """Return what a pass takes in which some messages arrive, and as many are sent as it may beside them."""
    count = messages_of_a_pass(program) - heard
    if not count:  # what is to be sent waits for the next pass
        return heard_work(program, heard)
    due = system.messages if most else streamed(system)
    works = sorted((message_work(message, system, most=most) for message in due), key=_weight, reverse=True)[:count]
    return sum(works, _looked(system)) + Work({Part.HEARD: heard}) + _ending(program, len(works) + heard)


def _looked(system: System) -> Work:
    return Work({Part.STREAMS: 1, Part.TABLE: len(system.messages)})


def _ending(program: Program, count: int) -> Work:
    """Return what is more where a pass takes in and sends so many messages, if it may do more."""
    return Work({Part.ENDING: 1} if count < messages_of_a_pass(program) else {})


def _weight(work: Work) -> tuple[int, int, int]:
    return work[Part.FRAME], work[Part.BYTE], work[Part.VALUE]
