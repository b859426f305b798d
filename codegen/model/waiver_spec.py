"""``waivers.yaml``: findings that a project knows of and keeps, each for a reason and for a time."""

from codegen.frozen import dataclass
from codegen.model.described import Verbatim, described
from codegen.source import Written


@dataclass(frozen=True, slots=True, kw_only=True)
class WaiverSpec(Written):
    """One finding that is known and kept."""

    id: str = described("Name of the waiver, for people to refer to.")
    rule: str = described("Id of the rule that finds it.")
    document: str = described(
        "The file that it is found in: its name, with as many folders before it as make it clear. Only a run that "
        "reads this file can say that the waiver is not used."
    )
    fingerprint: Verbatim = described(
        "What the finding is about, as 12 hex digits: --format json prints it with the finding. It stays the same when "
        "lines move, and changes with the words of the claim."
    )
    reason: str = described("Why it is kept, for the next one who reads this.")
    owner: str = described("Who decided so.")
    expires: str = described("Day from which the finding counts again, such as 2027-06-30.")


@dataclass(frozen=True, slots=True, kw_only=True)
class WaiversSpec(Written):
    """``waivers.yaml``: findings that are known and kept; they are still shown, but do not count."""

    waivers: tuple[WaiverSpec, ...] = described("The waivers.", default=())
