"""Texts in UTF-8: where they are cut, and how the words of the state keep them.

A word has two bytes of a text, the first one in its low half, and bytes behind its end are 0: what is set is cut to the
bytes that are kept, and what goes out to those of the field. A cut falls between two characters, and a NUL ends a text,
as it does on the wire.
"""

NUL = "\0"


def cut(text: str, size: int) -> str:
    """The text up to its first NUL, and as many whole characters of that as ``size`` bytes hold."""
    data = text.partition(NUL)[0].encode()
    end = min(len(data), size)
    while end < len(data) and data[end] & 0xC0 == 0x80:
        end -= 1
    return data[:end].decode()


def on_one_line(text: str) -> str:
    """Return a text for people, with what would end their line, or show as nothing, as Python writes it."""
    return "".join(one if one.isprintable() else one.encode("unicode_escape").decode("ascii") for one in text)


def words_of(size: int) -> int:
    """Return how many words keep so many bytes."""
    return -(-size // 2)


def letter_words(text: str, size: int) -> tuple[int, ...]:
    """The words of a text of which ``size`` bytes are kept."""
    data = cut(text, size).encode().ljust(2 * words_of(size), b"\0")
    return tuple(data[at] | data[at + 1] << 8 for at in range(0, len(data), 2))
