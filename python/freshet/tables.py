# SPDX-License-Identifier: MIT
"""The CSV tables of a run, column by column."""

from __future__ import annotations

import csv
import os
import re
from typing import Any, Dict, Iterator, List, Mapping, Sequence, Tuple, Union

import numpy as np

_HEAD = re.compile(r"^(?P<name>.*?)(?: \[(?P<unit>[^\]]*)\])?$")


class Table(Mapping[str, np.ndarray]):
    """Columns of equal length by name: table["speed max"]. `units` has the unit of each.

    Columns are NumPy arrays of numbers or strings. An unknown name raises KeyError, which lists the
    columns. to_pandas() makes a DataFrame.
    """

    def __init__(self, columns: Mapping[str, Any], units: Mapping[str, str], name: str = "") -> None:
        self._columns: Dict[str, np.ndarray] = {key: _array(c) for key, c in columns.items()}
        self.units: Dict[str, str] = dict(units)
        self.name = name

    def __getitem__(self, name: str) -> np.ndarray:
        try:
            return self._columns[name]
        except KeyError:
            raise KeyError(f"no column {name!r}; columns: {', '.join(self._columns)}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def rows(self) -> int:
        """The number of rows."""
        return len(next(iter(self._columns.values()), ()))

    def label(self, name: str) -> str:
        """A column with its unit: "speed max [m/s]"."""
        return f"{name} [{self.units[name]}]" if self.units.get(name) else name

    def where(self, rows: Any) -> "Table":
        """The table of the rows that a mask, a slice or indices select."""
        return Table({key: c[rows] for key, c in self._columns.items()}, self.units, self.name)

    def to_pandas(self) -> Any:
        """A pandas.DataFrame with the units in its column names."""
        import pandas

        return pandas.DataFrame({self.label(key): c if c.ndim == 1 else list(c) for key, c in self._columns.items()})

    def __repr__(self) -> str:
        return f"<freshet.Table {self.name}: {self.rows} rows, columns {', '.join(self._columns)}>"

    def _repr_html_(self) -> str:
        def row(cells: Sequence[Any], tag: str) -> str:
            texts = (f"{c:.6g}" if isinstance(c, float) else _escaped(str(c)) for c in cells)
            return "<tr>" + "".join(f"<{tag}>{text}</{tag}>" for text in texts) + "</tr>"

        shown = range(min(self.rows, 8))
        body = "".join(row([c[k : k + 1].tolist()[0] for c in self._columns.values()], "td") for k in shown)
        more = f"<p>{self.rows} rows</p>" if self.rows > 8 else ""
        return f"<table>{row([self.label(n) for n in self], 'th')}{body}</table>{more}"


def read_table(file: Union[str, "os.PathLike[str]"]) -> Table:
    """Reads a table of a run: comments, a line of names "NAME [UNIT]", then numbers or strings.

    An empty number is NaN. A last line without its end is skipped, since a run may be writing it.
    """
    with open(file, encoding="utf-8", newline="") as stream:
        text = stream.read()
    lines = [line for line in text.splitlines(keepends=True) if not line.startswith("#")]
    if lines and not lines[-1].endswith("\n"):
        lines.pop()
    rows = list(csv.reader(lines))
    names, units = _heads(rows[0]) if rows else ([], {})
    columns = [_column([row[k] for row in rows[1:]]) for k in range(len(names))]
    return Table(dict(zip(names, columns)), units, os.path.basename(os.fspath(file)))


def _array(values: Any) -> np.ndarray:
    """Rows may be vectors, of different lengths also."""
    try:
        return np.asarray(values)
    except ValueError:
        array = np.empty(len(values), dtype=object)
        array[:] = values
        return array


def _heads(cells: Sequence[str]) -> Tuple[List[str], Dict[str, str]]:
    heads = [_HEAD.match(cell) for cell in cells]
    names = [head["name"] for head in heads if head]
    return names, {head["name"]: head["unit"] or "" for head in heads if head}


def _column(cells: Sequence[str]) -> np.ndarray:
    try:
        return np.array([float(cell) if cell else np.nan for cell in cells])
    except ValueError:
        return np.array(cells)


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;")
