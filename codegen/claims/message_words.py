"""What sentences say of whole messages: ids, lengths, and the order of fields."""

import re
from collections.abc import Iterator
from itertools import pairwise

from codegen.claims.about import Surroundings, surroundings
from codegen.claims.identifier import MESSAGE_ID
from codegen.claims.reading import Reading, between
from codegen.claims.size import RULE as SIZE
from codegen.diagnostics import Diagnostic, Rule
from codegen.load.prose import Passage, PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.model.price import HEAD_V1, HEAD_V2

ORDER = Rule(
    "claim-wire-order",
    "A document gives another order of the fields on the wire than the message has: the largest types come first, "
    "fields of one size stay as they are, extensions come behind all others. Correct it.",
)
_MESSAGE = r"(?P<message>[A-Z][A-Z0-9_]{2,60})"
_N = r"#?(?P<number>\d{1,6})(?![\w.]\d|\w| ?(?:Hz|bytes?|times|ms|s|per|%)\b)"
_IDS = tuple(
    re.compile(form, re.IGNORECASE)
    for form in (
        rf"(?-i:{_MESSAGE}),? (?:(?:is|has|uses|with|as) )?(?:(?:the|a) )?(?:MAVLink )?"
        rf"(?P<word>(?:message|msg|packet) (?:number|no\.?|id)|msgid|number|id)(?: is)?:? ?=?{_N}",
        rf"(?-i:{_MESSAGE}),? (?:is )?(?P<word>message|msg|packet) {_N}(?=\s*(?:[,.;:)|]|$|is\b|has\b|in\b|from\b))",
        rf"(?P<word>(?:message|msg)[ _]?(?:id|number)|id|number) (?:of|for) (?:the )?(?:message )?(?-i:{_MESSAGE})"
        rf"(?: message)?(?: is|:| =) ?{_N}",
        rf"(?P<word>message|msg|packet|request|msgid)(?: id| number| no\.?)? {_N},? ?\(?(?-i:{_MESSAGE})\b",
        rf"\((?P<word>message|msgid|msg) ?(?:id|number|no\.?)?[ :=]{{0,2}}{_N}\)",
        rf",? (?:with the |the |its )?(?:message )?(?P<word>id)(?: is|:)? {_N}",
    )
)
_OTHER_ID = re.compile(r"component|system|array|compid|sysid|param|sensor|camera|target|instance", re.IGNORECASE)
_HEADED = re.compile(rf"{_MESSAGE} ?(?:,|:|-|\u2013) ?#?(?P<number>\d{{1,6}})")
_LENGTH = re.compile(
    r"\b(?P<part>(?:base )?payload)(?: (?:length|size|len))?(?: of| is|:| =)? ?(?P<alone>\d{1,3})\b(?!\w| ?bytes?| ?%)"
    r"|\b(?P<total>total)(?: of|:| is)? (?P<sum>\d{1,3}) bytes?\b"
    r"|\b(?P<what>base payload|payload|frame|packet|message)s?\b(?P<between>[^.;|\d]{0,40}?)"
    r"(?<![\w.,-])(?P<number>\d{1,3}) ?bytes?\b(?![ ]?(?:/|per\b|a second|of\b|for each))"
    r"|(?<![\w.,-])(?P<each>\d{1,3}) ?bytes?(?:/| per | a )(?P<per>message|frame|packet)",
    re.IGNORECASE,
)
_OTHER = re.compile(
    r"\bplus\b|\band\b|\bid\b|header|buffer|only|bandwidth|\bup to|at most"
    r"|more than|less than|at least|begin|first|last|each",
    re.IGNORECASE,
)
_IS = re.compile(r"\b(?:has|have|is|are|takes?|needs?|length|size|long|of)\b", re.IGNORECASE)
_VERSION_1 = re.compile(r"\bMAVLink ?v?1\b|\b0xFE\b", re.IGNORECASE)
_VERSION_2 = re.compile(r"\bMAVLink ?v?2\b|\b0xFD\b|\bv2\b", re.IGNORECASE)
_CUT = re.compile(r"truncat|trimmed|\bcut\b|zeros? (?:at|are)|\bzero\b|recorded|captur|shortened|often", re.IGNORECASE)
_WIRE = re.compile(r"on the wire|wire order|in this order|order on|payload (?:begins|starts)", re.IGNORECASE)
_XML = re.compile(r"\bXML\b|as (?:declared|defined|listed)|definition|dialect", re.IGNORECASE)
_SIGNATURE = 13


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every passage."""
    for part, around in surroundings(reading):
        if isinstance(part, Passage):
            yield from _ids(reading, part, around)
            yield from _lengths(reading, part, around)
            yield from _order(reading, part, around)


def message_about(reading: Reading, passage: Passage, around: Surroundings, start: int, end: int) -> WireMessage | None:
    """The message that a statement is about: the only one of its sentence, of its passage, of the heading."""
    mentions = reading.mentioned(passage)
    low, high = passage.sentence(start, end)
    beside = {mention.name for mention in between(mentions, low, high)}
    if beside:
        return reading.messages[beside.pop()] if len(beside) == 1 else None
    inside = reading.named(passage)
    if inside:
        return inside[0] if len(inside) == 1 else None
    return around.headings[0] if around.headings else around.earlier[0] if len(around.earlier) == 1 else None


def _ids(reading: Reading, passage: Passage, around: Surroundings) -> Iterator[Diagnostic]:
    """ "NAME has the id 84", "the message id of NAME is 84", "message 84 (NAME)", a heading "NAME, 84"."""
    found = [each for form in _IDS for each in form.finditer(passage.text)]
    if passage.kind is PassageKind.HEADING:
        found += [each for each in [_HEADED.fullmatch(passage.text.strip())] if each]
    for each in found:
        groups = each.groupdict()
        if groups.get("message"):
            message = reading.messages.get(groups["message"])
        else:
            message = _before(reading, passage, around, each.start(), each.end())
        number = int(each["number"])
        if message is None or message.id < 0 or number == message.id:
            continue
        if groups.get("word", "").lower() in ("id", "number") and _has_id(message):
            continue  # "BATTERY_STATUS has id 0 for the first pack"
        text = f"{message.name} has the id {message.id}, not {number}"
        place = passage.place_at(each.start("number"))
        yield reading.found(MESSAGE_ID, place, f"{message.name} id {number}", text)


def _before(reading: Reading, passage: Passage, around: Surroundings, start: int, end: int) -> WireMessage | None:
    """The message that an id is said of which stands somewhere behind it in its sentence."""
    low, _ = passage.sentence(start, end)
    if _OTHER_ID.search(passage.text, low, start) or not between(reading.mentioned(passage), low, start):
        return None
    return message_about(reading, passage, around, start, end)


def _has_id(message: WireMessage) -> bool:
    """Whether a field of a message is an id, too."""
    return any(field.name == "id" or field.name.endswith("_id") for field in message.fields)


def _lengths(reading: Reading, passage: Passage, around: Surroundings) -> Iterator[Diagnostic]:
    """ "The base payload has 12 bytes", "A frame is 24 bytes long in MAVLink 2", "41 bytes/message"."""
    for found in _LENGTH.finditer(passage.text):
        low, high = passage.sentence(found.start(), found.end())
        sentence = passage.text[low:high]
        message = message_about(reading, passage, around, found.start(), found.end())
        if message is None or message.id < 0 or _CUT.search(sentence) or _OTHER.search(found["between"] or ""):
            continue
        if (
            found["what"]
            and found["what"].lower() in ("message", "frame", "packet")
            and not _IS.search(found["between"])
        ):
            continue
        group = next(name for name in ("number", "each", "alone", "sum") if found[name])
        number = int(found[group])
        what = (found["what"] or found["per"] or found["part"] or found["total"]).lower()
        base, full = message.base_length, message.length
        is_version_1 = _VERSION_1.search(passage.text) and not _VERSION_2.search(passage.text)
        if is_version_1:
            full = base
        frames = {HEAD_V1 + base} if is_version_1 else {HEAD_V2 + base, HEAD_V2 + full, HEAD_V1 + base}
        frames |= {each + _SIGNATURE for each in frames}
        wanted = {base} if what == "base payload" else {base, full} if what == "payload" else frames
        if what in ("message", "total") or found["per"]:
            wanted = {base, full} | frames
        if number in wanted:
            continue
        own = f"a payload of {base} bytes" + (f", {full} with extensions" if full > base else "")
        text = f"{message.name} has {own}, and frames of {HEAD_V2 + base} in MAVLink 2, not {number}"
        words = passage.text[found.start() : found.end()]
        yield reading.found(SIZE, passage.place_at(found.start(group)), words, text)


def _order(reading: Reading, passage: Passage, around: Surroundings) -> Iterator[Diagnostic]:
    """A list of fields in one sentence that says that it is the order on the wire."""
    if not _WIRE.search(passage.text) or _XML.search(passage.text) or len(passage.codes) < 3:
        return
    message = message_about(reading, passage, around, passage.codes[0][0], passage.codes[0][1])
    if message is None:
        return
    found = [(message.field(passage.text[low:high]), low) for low, high in passage.codes]
    fields = [(field, low) for field, low in found if field is not None]
    if len(fields) < 3:
        return
    for (first, _), (second, low) in pairwise(fields):
        if first.offset > second.offset:
            order = ", ".join(field.name for field in message.fields)
            text = f"{message.name}: {second.name} comes before {first.name} on the wire"
            place = passage.place_at(fields[0][1])
            yield reading.found(ORDER, place, f"{message.name} order {low}", text, f"on the wire: {order}")
            return
