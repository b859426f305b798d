"""A proposal as the text of a population table, each row with the line of the document that it comes from."""

from collections.abc import Iterator

from codegen.frozen import dataclass
from codegen.importing.proposal import Proposal, ReadAnswer


@dataclass(frozen=True, slots=True)
class Heading:
    """The head of a table, above its fields. ``document`` is its name in comments: the document's id, or its file name.

    ``schema`` is the path of the JSON Schema for editors; what is None is left out, or stands in a comment.
    """

    document: str
    requirement: str | None
    for_each: str | None = None
    stream: str | None = None
    schema: str | None = None


def table_text(proposal: Proposal, heading: Heading) -> str:
    """The whole file. What could not be read, or is not mentioned, stands in comments with a proposal."""
    return "\n".join([*_head(proposal, heading), "fields:", *_fields(proposal, heading.document)]) + "\n"


def answer_line(answer: ReadAnswer, document: str) -> str:
    """One line of ``fields``, two blanks in front."""
    comment = source_comment(answer, document)
    if answer.reading.answer is not None:
        return f"  {answer.target.label}: {answer.reading.answer}  # {comment}"
    proposal = "..." if answer.reading.proposal is None else answer.reading.proposal
    written = _plain(answer.written)
    return f"  # {answer.target.label}: {proposal}  # {comment}" + (f": {written}" if written else "")


def source_comment(answer: ReadAnswer, document: str) -> str:
    """``FR-00068 line 67``, or ``FR-00068 lines 68, 69``."""
    plural = "" if len(answer.lines) == 1 else "s"
    return f"{_plain(document)} line{plural} {', '.join(map(str, answer.lines))}"


def _head(proposal: Proposal, heading: Heading) -> Iterator[str]:
    if heading.schema is not None:
        yield f"# yaml-language-server: $schema={heading.schema}"
    yield f"message: {proposal.message.name}"
    yield (
        "# requirement: ...  # the document has no id"
        if heading.requirement is None
        else (f"requirement: {heading.requirement}")
    )
    if heading.for_each is not None:
        yield f"for_each: {heading.for_each}"
    if heading.stream is None:
        yield "# stream: ...  # without one the message is sent when somebody asks for it"
    else:
        yield f"stream: {heading.stream}"


def _fields(proposal: Proposal, document: str) -> Iterator[str]:
    order = {field.name: index for index, field in enumerate(proposal.message.definition.fields)}
    lines = [
        (order[answer.target.field.name], answer.target.first, answer_line(answer, document))
        for answer in proposal.answers
    ]
    for missing in proposal.unmentioned:
        text = f"  # {missing.target.label}: {missing.proposal or '...'}  # {_plain(document)} does not mention it"
        lines.append((order[missing.target.field.name], missing.target.first, text))
    return (text for _, _, text in sorted(lines))


def _plain(text: str) -> str:
    """A text of a document on one line, without what YAML does not allow in a comment."""
    return "".join(one if one.isprintable() else "?" for one in " ".join(text.split()))
