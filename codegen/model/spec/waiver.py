"""``waivers.yaml``: findings that a project knows of and keeps, each for a reason and for a time."""

from enum import StrEnum

from codegen.frozen import dataclass
from codegen.model.spec.described import Verbatim, described
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


class SetSeverity(StrEnum):
    """A severity that somebody sets: what is off is not shown."""

    ERROR = "error"
    WARNING = "warning"
    INFO = "info"
    OFF = "off"


@dataclass(frozen=True, slots=True, kw_only=True)
class SeveritySpec(Written):
    """The severity of a kind of change in codegen diff, everywhere or for some files, messages or versions."""

    kind: str = described(
        "Id of a rule of codegen diff, an area (wire, behaviour, trace, documentation), a weight (silent, breaking, "
        "person, harmless), or any."
    )
    severity: SetSeverity = described("error makes the comparison fail, warning and info do not, off is not shown.")
    reason: str = described("Why, for the next one who reads this.")
    subject: str | None = described(
        "Message, MESSAGE.field, enum, ENUM.ENTRY or any other subject of a finding; * stands for any letters.",
        default=None,
    )
    file: str | None = described(
        "File that it stands in, or the last parts of its path; * for any letters.", default=None
    )
    since: str | None = described(
        "Only where the new side is this version or a later one, such as 2.4.43.", default=None
    )
    until: str | None = described("Only where the new side is this version or an earlier one.", default=None)


@dataclass(frozen=True, slots=True, kw_only=True)
class WaiversSpec(Written):
    """``waivers.yaml``: findings that are known and kept; they are still shown, but do not count."""

    waivers: tuple[WaiverSpec, ...] = described("The waivers.", default=())
    severities: tuple[SeveritySpec, ...] = described(
        "How bad kinds of change are in codegen diff; of several for one change the last one holds.", default=()
    )
