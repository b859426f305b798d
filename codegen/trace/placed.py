"""The files of symbols where a build puts them: a module that all programs of a project have alike lies once."""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from codegen.trace.graph import Row, Symbol


def placed(rows: Iterable[Row], shared: Mapping[str, str]) -> tuple[Row, ...]:
    """Return the rows with the files of their symbols where they lie, as ``shared`` has them."""

    def where(symbol: Symbol) -> Symbol:
        return symbol._replace(file=shared.get(symbol.file, symbol.file))

    return tuple(replace(row, symbols=tuple(dict.fromkeys(map(where, row.symbols)))) for row in rows)
