"""Words by which a sentence, a cell or a line of code says that it states nothing about the messages of the dialect.

It denies, tells of the past or of a mistake, supposes, speaks of somebody's own things, or of what is shown or computed
from a value. Each kind of statement names the groups that make it none, with words of its own.
"""

import re

DENIED = (r"\bnot\b", r"n't\b", r"\bnever\b", r"\bno longer\b")
REPLACED = (r"\binstead\b", r"\brather\b", r"\bunlike\b")
PAST = (r"\bwas\b", r"\bwere\b", r"\bold\b", r"\bearlier\b", r"\bformerly\b", r"\bpreviously\b", r"\bused to\b")
CHANGED = (r"\bchanged?\b", r"\buntil\b", r"becomes?\b", r"\bwrote\b")
MISTAKEN = (r"\bwrong", r"\bmistake", r"\bincorrect", r"\bbug\b", r"\btypo\b")
SUPPOSED = (r"\bwould\b", r"\bcould\b")
CONDITIONAL = (r"\bif\b", r"\bwhen\b")
PROPOSED = (r"\bpropos", r"\bdraft\b", r"\bplanned\b", r"\bfuture\b", r"\brfc\b")
OWN = (r"\bour\b", r"\bours\b", r"\bmy\b", r"\bwe\b", r"\bown\b", r"\bprivate\b", r"\bcustom\b", r"\binternal")
SHOWN = (r"\bshow", r"display", r"\bplot", r"\blogs?\b", r"\bprint", r"\bscreen", r"\bgraph", r"\bchart", r"\bcsv\b")
CONVERTED = (r"divid", r"multipl", r"convert", r"\binto\b", r"\bscaled", r"\bround", r"\bstor(?:e|ed|es|ing)\b")
COMPARED = (r"\bthan\b", r"\blike\b", r"\bagainst\b", r"\bcompared\b")
TEMPORARY = (r"\bbuffer", r"\btruncat", r"\btrimmed\b", r"\bcut\b")
ASKED = (r"\?",)


def words(*groups: tuple[str, ...] | str) -> "re.Pattern[str]":
    """Return what finds any word of some groups, and of further patterns, in a short text."""
    patterns = [pattern for group in groups for pattern in ((group,) if isinstance(group, str) else group)]
    return re.compile("|".join(patterns))


NO_CLAIM = words(DENIED, REPLACED, PAST, MISTAKEN, SUPPOSED, PROPOSED, OWN, SHOWN, CONVERTED, ASKED)
"""What says of any sentence about a value that it states none of the dialect."""
