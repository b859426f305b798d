"""Words by which a sentence, a cell or a line of code says that it states nothing about the messages of the dialect.

It denies, tells of the past or of a mistake, supposes, speaks of somebody's own things, or of what is shown or computed
from a value. Each kind of statement names the groups that make it none, with words of its own.
"""

import re

from codegen.pattern import pattern

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
    return pattern("|".join(patterns))


_OWN_THINGS = (
    r"(?:logs?|variables?|databases?|topics?|columns?|structs?|tables?|displays?|apps?|screens?|csv|cop(?:y|ies)|forks?"
    r"|dialects?|firmwares?|sensors?|drivers?|sliders?|radios?|files?|buffers?|node|recording|parser|enums?|page|gui|code)"
)
_OWN_PLACES = (
    r"(?:structs?|class|data ?base|logs?|log ?book|spreadsheet|csv(?: file)?|apps?|gui|source|script|program|parser"
    r"|cache"
    r"|dashboard|recordings?|export|viewer|config(?:uration)?)"
)
_HANDLED = (
    r"(?:show|keep|store|log|copy|convert|plot|display|print|cast|allocate|reserve|prefer|round|scale|limit|clip|measured"
    r"|turn|write|save|use the first|read (?:it|them|that)? ?(?:as|into))"
)
_DONE = r"filled|sent|wrote|took|packed|assumed|expected|forgot|decoded|parsed|treated"
"""Verbs of what a version or somebody did, as release notes tell of what they have mended: "3.3 read it as ..."."""
_ASIDE = words(
    r"\b(?:draft|proposals?|proposed?|rfc|suggest\w*|wish|idea)\b",
    rf"\b(?:our|my|their) (?:[a-z]+ ){{0,2}}{_OWN_THINGS}\b",
    rf"\bin (?:the|a|this|that) (?:[a-z]+ )?{_OWN_PLACES}\b",
    rf"\b(?:we|i|they) (?:then |only |first |also |had |would )*{_HANDLED}\b",
    r"\b(?:in|over|of|on|from|the|an?) (?:the |an? )?(?:[a-z]+ )?(?:i2c|spi|nmea|modbus|sensor_msgs|uorb|crsf|sbus"
    r"|dataflash|geojson|kml|gpx)"
    r" (?:mode|message|frame|sentence|packet|register|topic|log|file|bus|protocol|value|units?)\b",
    r"\b(?:shall|must|should|will|may) (?:[a-z]+ly |then |also )?(?:present|show|display|plot|draw|print|render)\b",
    r"\b(?:panel|display|screen|map|page|app|gui|dashboard|station|gateway|viewer|console|hud|instrument|gauge|chart"
    r"|graph) (?:[a-z]+ly |then |also )?(?:shows?|presents?|displays?|plots?|draws?|prints?)\b(?! [QN])",
    r"\b(?:is|are|gets?|was|were|be) (?:then )?(?:shown|converted|copied|cast|plotted|displayed|printed|rounded)"
    r" (?:to|into|as|in|with|by|on|for)\b",
    r"\b(?:after|before) (?:the |a )?(?:division|conversion|scaling|dividing|converting|truncation|trimming)\b",
    r"\bon (?:the|a) (?:screen|display|map|page|plot)\b",
    r"\b(?:old|older|earlier|previous|former|legacy|ancient) (?:[a-z]+ )?(?:firmwares?|versions?|headers?"
    r"|generations?|releases?"
    r"|builds?|code|bindings?|drafts?)\b",
    r"\b(?:before|until|up to) (?:version|v\d|release)",
    r"(?:^\W*|[.;:] )(?:(?:version|release|firmware) )?(?:N|v ?[\dN]+)(?:\.[\dNx]+)* (?:still |also |only )?"
    rf"(?:{_DONE}|read|put)\b",
    rf"\b(?:we|i|they) (?:had |first |also |only |once |always |both )*(?:{_DONE})\b",
    r"\bof (?:your|our|my|their) own\b",
    r"\bshould have (?:been|read|said)\b|\bought to (?:be|have been)\b",
    r"\bused to be\b|\bno longer\b|\bback then\b|\bat that time\b",
    r"\bwrong(?:ly)?\b|\bmistak|\bincorrect|\ba bug\b|\brejected\b|\brefused\b|\bmislead",
    r"\brevert(?:s|ed)?\b|\b(?:treated|interpreted|misread|assumed) [^.;]{1,40} as\b",
    r"\bwould (?:be better|be nicer|make|prefer|rather|like)\b|\bif [^,;]{1,40} were\b",
)
"""Words that make a sentence one about other things than the messages of the dialect."""


_DENIAL = pattern(
    r"\b(?:must|should|may|can) (?:not|never) be\b(?! (?:more|larger|greater|higher|bigger|above|over|exceed))"
)


_EXCEPTED = pattern(r"\b(?:all|every\w*|each)\b[^.;|]{0,40}\b(?:but|except|save)(?: for| of| the)* $")


def is_excepted(text: str, start: int) -> bool:
    """Return whether what begins there is left out of what is said: "all fields but the health are floats"."""
    return _EXCEPTED.search(text, max(start - _EXCEPTED_MOST, 0), start) is not None


_EXCEPTED_MOST = 70
"""Characters in which that is looked for."""


def is_denial(sentence: str) -> bool:
    """Return whether a sentence says of something what it must not be."""
    return _DENIAL.search(sentence) is not None


def is_aside(sentence: str) -> bool:
    """Return whether a sentence, in small letters but for its terms, states nothing of the messages of the dialect."""
    return _ASIDE.search(sentence) is not None


_OWN_COLUMN = pattern(
    r"\bour|\bmy\b|\bcolumn (?:type|unit)|\bcsv\b|\bsql\b|database|\bros\b|\btopic|variable|\blocal\b|\bdraft\b|propos"
    r"|\bwrong\b|shown|display",
    re.IGNORECASE,
)


def is_own_column(head: str) -> bool:
    """Return whether a column of a table tells of somebody's own things."""
    return _OWN_COLUMN.search(head) is not None
