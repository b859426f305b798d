"""References of the numbers in a text: axes, heights, clocks, and what else there are several of.

Most of two texts may be alike, and still one word decide what each number means: ``positive forward`` for ``positive
north``.
"""

import re
from collections.abc import Mapping
from functools import cache
from typing import NamedTuple

from codegen.pattern import pattern


class _Reference(NamedTuple):
    """A reference by its kind and name: the ``words`` one of which a text has that tells of it, and an expression."""

    kind: str
    name: str
    words: tuple[str, ...]
    expression: re.Pattern[str]


def _first_number(number: str) -> str:
    """Return an expression for texts that say with which number counting begins."""
    return (
        rf"\b(?:{number})[- ](?:based|indexed)|\b(?:{number}) (?:for|is) the first\b"
        rf"|\bfirst (?:\w+ )?(?:being|is|has) (?:number |index )?(?:{number})\b"
        rf"|\b(?:count|start|begin|number|index)\w* (?:counting )?(?:from|at|with) (?:{number})\b"
    )


_FLOWING = r"(?:flow(?:s|ing)?|rate|current|energy|charge|fuel|water|air|power|data|bytes|packets)"
_PER_UNIT = r"(?:second|minute|hour|day|week|cent|unit|[a-z]*(?:met(?:er|re)|gram|volt|degree|bit|byte|lit(?:er|re)))"
_MOVING = r"(?:zoom|reel|pull|roll|wind|fade|slide|draw|let)(?:s|ed|ing)?"
_REFERENCES = tuple(
    _Reference(kind, name, tuple(words.split("|")), pattern(expression))
    for kind, name, words, expression in (
        ("axes", "earth", "north|east|ned|enu", r"\bnorth|\beast(?:wards?)?\b|\bned\b|\benu\b"),
        ("axes", "body", "forward|frd|flu|body|nose|starboard|heading",
         r"\bforwards?\b|\bfrd\b|\bflu\b|\bbody\b|\bnose\b|\bstarboard\b"
         r"|\bfrom the (?:present |current |vehicle'?s? )*heading"),
        ("axes", "ned", "ned", r"\bned\b"),
        ("axes", "enu", "enu", r"\benu\b"),
        ("axes", "frd", "frd", r"\bfrd\b"),
        ("axes", "flu", "flu", r"\bflu\b"),
        ("height", "sea", "msl|sea|geoid", r"\ba?msl\b|\bsea[- ]level|\bgeoid"),
        ("height", "ellipsoid", "ellipsoid|wgs|hae", r"\bellipsoid|\bwgs ?84\b|\bhae\b"),
        ("height", "home", "home|above",
         r"\babove home|\b(?:relative|with respect) to (?:the )?home|\babove (?:the )?take-?off"),
        ("height", "terrain", "above|over|agl|relative to",
         r"\b(?:above|relative to) (?:the )?(?:terrain|ground)|\bover (?:the )?terrain|\bagl\b"),
        ("height", "target", "above", r"\babove (?:the )?target"),
        ("pressure", "qnh", "qnh", r"\bqnh\b"),
        ("pressure", "qne", "qne", r"\bqne\b"),
        ("pressure", "qfe", "qfe", r"\bqfe\b"),
        ("clock", "utc", "utc|gmt|unix|epoch", r"\butc\b|\bgmt\b|\bunix|\bepoch"),
        ("clock", "boot", "boot|since",
         r"\bsince (?:the )?(?:system |vehicle )?(?:was )?(?:boot|start|power)|\bboot time"
         r"|\bfrom (?:the )?(?:system |vehicle )?boot"),
        ("clock", "arming", " arm", r"\b(?:since|from) (?:the )?(?:vehicle )?(?:was )?(?:last )?arm"),
        ("clock", "take-off", "take", r"\b(?:since|from) (?:the )?take-?off"),
        ("clock", "the last message", "message|report",
         r"\b(?:since|from) (?:the )?(?:previous|last) (?:message|report)"),
        ("clock", "local time", "local time", r"\blocal time"),
        ("clock", "gps time", "gps", r"\bgps (?:time|week)"),
        ("airspeed", "indicated", "indicated|ias", r"\bindicated\b(?! (?:by|in|with|at|as|through)\b)|\bias\b"),
        ("airspeed", "true", "true|tas", r"\btrue (?:air ?)?speed|\btas\b"),
        ("airspeed", "calibrated", "calibrated|cas", r"\bcalibrated (?:air ?)?speed|\bcas\b"),
        ("airspeed", "equivalent", "equivalent|eas", r"\bequivalent (?:air ?)?speed|\beas\b"),
        ("statistic", "a mean", "averag|mean", r"\baverag|\bmean (?:value|of|over)|\bmean\b(?= \w+ over)"),
        ("statistic", "a peak", "peak|highest|maximum", r"\bpeak|\bhighest|\bmaximum (?:value|seen)"),
        ("spread", "a variance", "variance", r"\bvariance"),
        ("spread", "a share of all cases", "percent|confidence|cep",
         r"\b(?:percent|%) (?:of (?:all|the)|confidence|probab)|\bconfidence|\bcep\b"),
        ("spread", "a deviation", "deviation|std|rms|sigma", r"\bdeviation|\bstd\b|\brms\b|\b(?:1|one)[- ]sigma"),
        ("count", "all together", "total|sum|together|in series|combined|whole|pack",
         r"\btotal|\bsum of|\ball \w+ (?:together|in series)|\bcombined|\bwhole\b|\bof the pack\b"),
        ("count", "a single one", "this", r"\bthis (?:flight|mission|charge|cycle)\b"),
        ("count", "each", "each|per", rf"\b(?:of|in|for) each\b|\bper (?!{_PER_UNIT})[a-z]{{3,}}\b"),
        ("statistic", "a moment", "instantaneous|momentary|at the time|latest|most recent",
         r"\binstantaneous|\bmomentary|\bat the time of sending|\blatest|\bmost recent"),
        ("one of several", "an extreme", "est", r"\b(?:hott|cold|weak|strong|slow|fast|clos|near|farth)est\b"),
        ("medium", "the ground", "ground", r"\bground ?speed|\bover (?:the )?ground"),
        ("medium", "the air", "air", r"\bair ?speed|\bthrough (?:the )?air|\brelative to (?:the )?(?:air|wind)"),
        ("medium", "the water", "water", r"\bthrough (?:the )?water|\brelative to (?:the )?water"),
        ("origin", "what was asked for", "command|request|desire|as set by|setpoint|set-point|demand|sent to",
         r"\bcommanded|\brequested|\bdesired|\bas set by|\bset-?points?\b|\bdemanded|\b(?:is|was|as) sent to\b"),
        ("origin", "what was set up", "set |configured",
         r"\b(?:set|configured) (?:in|by|with) (?:the |a |its )?(?:param|config|operator|user|pilot)"),
        ("origin", "what was measured", "measured|read |actual|feedback|encoder|report",
         r"\bmeasured|\bread (?:back|from|by)\b|\breported by\b|\bas (?:the )?\w+ reports?\b"
         r"|\bactual\b|\bfeedback|\bencoder"),
        ("amount", "what is left", "remain|free|unused|left in|can still",
         r"\bremain(?:s|ing)\b|\bfree\b|\bunused (?:space|memory|bytes|capacity)|\bleft in\b|\bcan still be\b"),
        ("amount", "what is used", "in use|consumed|occupied|used|burnt|burned|spent",
         r"\bin use\b|\bconsumed|\boccupied|\balready used|\bused since|\bburn(?:t|ed)\b|\bspent\b"),
        ("signal", "raw values", "raw|unfiltered", r"\braw\b|\bunfiltered"),
        ("signal", "filtered values", "filtered|smoothed", r"(?<!un)\bfiltered|\bsmoothed"),
        ("speed", "the shaft", "shaft|mechanical", r"\bshaft|\bmechanical"),
        ("speed", "the field", "electrical|erpm", r"\belectrical (?:rotation|speed|rpm)|\berpm\b"),
        ("first number", "0", "based|indexed|from|at|with|first", _first_number("0|zero")),
        ("first number", "1", "based|indexed|from|at|with|first", _first_number("1|one")),
        ("byte order", "the most significant first", "big|most",
         r"\bbig[- ]endian|\bmost significant byte first|\bmsb first"),
        ("byte order", "the least significant first", "little|least",
         r"\blittle[- ]endian|\bleast significant byte first|\blsb first"),
        ("course", "what is to come", "until|till|time left|remaining time|to go",
         r"\btime (?:left |remaining |that remains )?(?:until|till)|\btime left|\bremaining time|\btime to go"),
        ("course", "how long it takes", "time for which|duration", r"\btime for which|\bduration"),
        ("course", "when it is", "time at which|time when|moment", r"\btime (?:at which|when)\b|\bmoment"),
        ("course", "what has passed", "time since|passed|elapsed",
         r"\btime since\b|\btime (?:that )?(?:has |have )?(?:passed|elapsed)|\belapsed"),
        ("amount of it", "a change", "by which", r"\bby which\b"),
        ("amount of it", "a state", "which", r"\b(?:at|to) which\b"),
        ("way", "in", " in", rf"\b{_FLOWING}\b[^.;]* into\b|\b{_MOVING} in\b"),
        ("way", "out", " out", rf"\b{_FLOWING}\b[^.;]* out of\b|\b{_MOVING} out\b"),
        ("flow", "where it comes from", "from",
         r"\bfrom (?:which|where)|\b(?:comes?|coming|blows?|blowing|flows?|flowing) from"),
        ("flow", "where it goes to", "to", r"\bto(?:wards?)? which|\b(?:goes|going|blows?|blowing|flows?|flowing) to"),
        ("observer", "behind", "behind", r"\b(?:observer|seen from|viewed from) behind"),
        ("observer", "in front", "front", r"\bobserver in front|\b(?:seen|viewed) from (?:the )?front"),
        ("observer", "above", "from above", r"\b(?:seen|viewed) from above"),
        ("observer", "below", "from below", r"\b(?:seen|viewed) from below"),
    )
)  # fmt: skip
"""References that numbers are measured from."""

STATED_LATE = frozenset({"height", "pressure", "airspeed", "first number", "one of several", "medium"})
"""Of what a text that says nothing leaves open which of several it is, so that vehicles differ."""

_DENIED = pattern(r"\((?:and )?not [^)]*\)|\bnot relative to (?:the )?\w+")


def references(text: str) -> Mapping[str, frozenset[str]]:
    """Return what a text measures from, by the kind of it; ``not relative to north`` is no mention of north."""
    small = text.lower()
    return _mentioned(_DENIED.sub(" ", small) if "not " in small else small)


def denied_references(text: str) -> Mapping[str, frozenset[str]]:
    """Return what a text says that it does not measure from."""
    small = text.lower()
    return _mentioned(" ".join(found[0] for found in _DENIED.finditer(small))) if "not " in small else {}


@cache
def _mentioned(text: str) -> Mapping[str, frozenset[str]]:
    found: dict[str, frozenset[str]] = {}
    for kind, name, words, expression in _REFERENCES:
        for word in words:
            if word in text:
                if expression.search(text):
                    found[kind] = found.get(kind, frozenset()) | {name}
                break
    return found
