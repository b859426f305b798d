"""The frames in which COMMAND_INT may state a command: of a position, and from where an altitude counts."""

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.command import CommandParam
from codegen.model.dialect.dialect import Dialect, EnumEntry
from codegen.model.spec.command import CommandSpec
from codegen.resolve.quantities.kept import UNKNOWN_ENTRY

BAD_COMMAND_FRAME = Rule(
    "bad-command-frame",
    "A command whose method is given an altitude says in which frame that is, and in one only: frames count altitudes "
    "from the sea, from home or from the ground, or downwards, and the method is not told the frame. Latitude and "
    "longitude are in global frames only.",
)
_PREFIX, _WHOLE, _GLOBAL = "MAV_FRAME_", "_INT", "MAV_FRAME_GLOBAL"


def resolve_frames(
    name: str, spec: CommandSpec, params: tuple[CommandParam, ...], dialect: Dialect, report: Report
) -> tuple[EnumEntry, ...]:
    """Return the entries of MAV_FRAME that COMMAND_INT may have; none where any is accepted."""
    enum = dialect.enums.get("MAV_FRAME")
    entries = enum.entries if enum else ()
    has_position = any(param.axis for param in params)
    altitude = next((param for param in params if param.is_altitude), None)
    known = sorted(entry.name for entry in entries)
    for written in spec.frames:
        if written not in known:
            message = f"MAV_FRAME has no entry {written}"
            report.add(UNKNOWN_ENTRY, spec.at("frames"), message, did_you_mean(written, known))
        elif has_position and not written.startswith(_GLOBAL):
            message = f"{name} has latitude and longitude, which {written} does not have"
            report.add(BAD_COMMAND_FRAME, spec.at("frames"), message, "take one that begins with MAV_FRAME_GLOBAL")
    meant = {written.removesuffix(_WHOLE) for written in spec.frames}
    is_told = any(param.enum is not None and param.enum.name == "MAV_FRAME" for param in params)
    if altitude is not None and len(meant) != 1 and not is_told:
        stated = f"is given in {' and '.join(sorted(meant))}" if meant else "has no frame"
        place = spec.at("frames") if meant else altitude.spec.place
        message = (
            f"the altitude {altitude.name} of {name} {stated}, and {spec.method}() cannot tell what it counts from"
        )
        report.add(BAD_COMMAND_FRAME, place, message, "one frame, such as frames: [MAV_FRAME_GLOBAL_RELATIVE_ALT]")
    if not meant:
        return tuple(entry for entry in entries if has_position and entry.name.startswith(_GLOBAL))
    return tuple(entry for entry in entries if entry.name.removesuffix(_WHOLE) in meant)
