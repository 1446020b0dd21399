# SPDX-License-Identifier: MIT
"""Progress bars by tqdm if it is installed, else a line on a terminal."""

from __future__ import annotations

import math
import sys
from contextlib import contextmanager
from typing import Callable, Iterator


@contextmanager
def progress_bar(wanted: bool, total: float, unit: str) -> Iterator[Callable[[float], None]]:
    """Yields a function that takes the progress so far. `total` may be infinite."""
    if not wanted:
        yield lambda done: None
        return
    try:
        from tqdm.auto import tqdm
    except ImportError:
        with _line(total, unit) as show:
            yield show
        return
    form = "{percentage:3.0f} %|{bar}| {n:.3g}/{total:.3g} {unit} [{elapsed}<{remaining}]"
    if math.isinf(total):
        form = "{n:.3g} {unit} [{elapsed}]"
    with tqdm(total=total, unit=unit, bar_format=form) as bar:

        def show(done: float) -> None:
            bar.n = min(done, total)
            bar.refresh()

        yield show


@contextmanager
def _line(total: float, unit: str) -> Iterator[Callable[[float], None]]:
    terminal = sys.stderr.isatty()

    def show(done: float) -> None:
        if terminal:
            share = 100 * done / total if total else 100
            print(f"\r{share:3.0f} %  {done:.3g} of {total:.3g} {unit}", end="", file=sys.stderr)

    try:
        yield show
    finally:
        if terminal:
            print(file=sys.stderr)
