"""The kinds of answers for fields of a table. Each kind has a module here, which knows all about it.

Stages know none of them: they ask the methods of ``codegen.model.answers.answer.Answer``. Beside the kinds lies what
several of them share: ``scope`` (what a table can name), ``source`` and ``fitting`` (whether it fits the field),
``constant``, ``limits`` and ``scaled``.
"""

from codegen.answers.chip import ChipAnswer
from codegen.answers.chosen import ChosenAnswer
from codegen.answers.clock import ClockAnswer
from codegen.answers.copied import CopiedAnswer
from codegen.answers.count import CountAnswer
from codegen.answers.each.answer import EachAnswer
from codegen.answers.fact import FactAnswer
from codegen.answers.fixed import FixedAnswer
from codegen.answers.flags import FlagsAnswer
from codegen.answers.instance import InstanceAnswer
from codegen.answers.kind import KindOfAnswer
from codegen.answers.live import LiveAnswer
from codegen.answers.page import PageAnswer
from codegen.answers.row import RowAnswer
from codegen.answers.split import SplitAnswer
from codegen.answers.text import TextAnswer

KINDS: tuple[type[KindOfAnswer], ...] = (
    EachAnswer,
    PageAnswer,
    InstanceAnswer,
    CountAnswer,
    SplitAnswer,
    ClockAnswer,
    TextAnswer,
    RowAnswer,
    CopiedAnswer,
    LiveAnswer,
    ChipAnswer,
    FactAnswer,
    FlagsAnswer,
    ChosenAnswer,
    FixedAnswer,
)
"""The kinds. An answer is of the first one that takes what is written: the particular ones come first."""
