"""Changes of what the dialect says about the use of a message, an enum or an entry."""

from collections.abc import Iterator, Sequence

from codegen.diff.change import Change, changed
from codegen.diff.dialect.wire_rules import LIFECYCLE
from codegen.model.dialect.dialect import Lifecycle
from codegen.source import Place


def lifecycle_changes(
    subject: str, old: Lifecycle, new: Lifecycle, places: tuple[Place, Place], messages: Sequence[str]
) -> Iterator[Change]:
    """Yield one change with the lifecycle before and after, if these differ."""
    if old != new:
        yield changed(LIFECYCLE, subject, _said(old), _said(new), places, messages=messages)


def _said(lifecycle: Lifecycle) -> str:
    words = ["work in progress"] if lifecycle.wip else []
    if lifecycle.deprecated_since is not None:
        words.append(f"deprecated since {lifecycle.deprecated_since or 'some time'}")
    if lifecycle.superseded_since is not None:
        words.append(f"superseded since {lifecycle.superseded_since or 'some time'}")
    if lifecycle.replaced_by:
        words.append(f"replaced by {lifecycle.replaced_by}")
    if lifecycle.remark:
        words.append(lifecycle.remark)
    return ", ".join(words) or "in use"
