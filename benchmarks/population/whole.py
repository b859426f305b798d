"""The proof over whole dialects: in batches, on all processors, and what it comes to."""

import importlib
import os
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

from population.comparing import Outcome, prove
from population.fields import Message, read_messages

LARGEST, INCLUDED = "ardupilotmega", "common"
"""The dialect that is proven, and one that it includes, message by message the same."""
MOST = 400
"""Values of the messages of a batch, unless one alone has more: a project of so many is built in seconds."""

KNOWN: dict[str, str] = {}
"""Elements that the generator is known to refuse, by label, each with the rule of its error."""


def prove_all(seed: int, rounds: int, tell: Callable[[str], None]) -> Outcome:
    """Prove every message of the largest dialect; ``tell`` is called with a line for each batch."""
    module = importlib.import_module(f"pymavlink.dialects.v20.{LARGEST}")
    messages = read_messages(LARGEST, module)
    whole = Outcome()
    with tempfile.TemporaryDirectory() as temporary, ProcessPoolExecutor(os.cpu_count()) as pool:
        names = [[each.name for each in batch] for batch in batches(messages.values())]
        tasks = [
            pool.submit(_batch, batch, str(Path(temporary) / str(number)), seed, rounds)
            for number, batch in enumerate(names)
        ]
        for batch, task in zip(names, tasks, strict=True):
            found = task.result()
            whole.add(found)
            tell(f"{batch[0]} to {batch[-1]}: {len(batch)} messages, {len(found.differences)} differences")
    whole.differences += unlisted(whole)
    return whole


def included(messages: Mapping[str, Message]) -> list[str]:
    """The names of the messages of the dialect that is included: they are the very same in the other one."""
    module = importlib.import_module(f"pymavlink.dialects.v20.{INCLUDED}")
    found = read_messages(INCLUDED, module)
    for name, message in found.items():
        # A dialect may add entries to an enum of the one that it includes.
        assert [_without_enum(each) for each in message.fields] == [
            _without_enum(each) for each in messages[name].fields
        ]
    return list(found)


def batches(messages: Iterable[Message]) -> Iterator[list[Message]]:
    """Messages in the order of their ids, as many together as make a project of a good size; large ones come first."""
    batch: list[Message] = []
    for message in sorted(messages, key=lambda each: (each.elements < MOST // 2, each.id)):
        if batch and sum(each.elements for each in batch) + message.elements > MOST:
            yield batch
            batch = []
        batch.append(message)
    yield batch


def unlisted(outcome: Outcome) -> list[str]:
    """Refusals that are not known, and known ones that are none any more: either has to be looked at."""
    found = [f"{label} is refused: {rule}" for label, rule in outcome.refused.items() if KNOWN.get(label) != rule]
    return found + [f"{label} is no longer refused" for label in KNOWN.keys() - outcome.refused.keys()]


def _batch(names: Sequence[str], folder: str, seed: int, rounds: int) -> Outcome:
    module = importlib.import_module(f"pymavlink.dialects.v20.{LARGEST}")
    messages = read_messages(LARGEST, module)
    return prove(LARGEST, module, [messages[name] for name in names], Path(folder), seed, rounds)


def _without_enum(field: object) -> dict[str, object]:
    return {key: value for key, value in vars(field).items() if key != "enum"} | {
        "unknown": repr(vars(field)["unknown"])
    }
