# SPDX-License-Identifier: MIT
"""The exception of the package, with places, keys and remedies."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import List, Optional, Sequence, Tuple

_PLACE = re.compile(r"(?P<file>.+?):(?P<line>\d+)(?::(?P<column>\d+))?$")
_OVERRIDE = re.compile(r"(?:override|removal) (?P<key>.+)$")
_KEY = re.compile(r"^(?:unknown key |the key )?(?P<key>[a-z_]+(?:\[\d+\])?(?:\.[a-z0-9_]+(?:\[\d+\])?)+)\b")


@dataclass(frozen=True)
class Diagnostic:
    """One error or warning."""

    severity: str
    """"error" or "warning"."""
    place: str
    """FILE:LINE:COLUMN, a path, "override KEY", or empty."""
    message: str
    """What is wrong, what is allowed, what to do."""

    @property
    def file(self) -> Optional[str]:
        """The file, or the name of the scene in memory."""
        match = _PLACE.match(self.place)
        return match["file"] if match else None

    @property
    def line(self) -> Optional[int]:
        """The line, from 1 on."""
        match = _PLACE.match(self.place)
        return int(match["line"]) if match else None

    @property
    def column(self) -> Optional[int]:
        """The column, from 1 on."""
        match = _PLACE.match(self.place)
        return int(match["column"]) if match and match["column"] else None

    @property
    def key(self) -> Optional[str]:
        """The key of the scene, for example "particles.spacing"."""
        match = _OVERRIDE.match(self.place) or _KEY.match(self.message)
        return match["key"] if match else None

    @property
    def remedy(self) -> Optional[str]:
        """What to do, where the message names it."""
        _, found, remedy = self.message.partition("; ")
        return remedy if found else None

    def __str__(self) -> str:
        override = _OVERRIDE.match(self.place)
        place = f"set {override['key']}" if override else self.place
        return f"{place}: {self.severity}: {self.message}" if place else f"{self.severity}: {self.message}"


class Error(Exception):
    """Raised for invalid scenes and requests, and for failed runs.

    Arguments of a wrong type or shape raise TypeError or ValueError, as in NumPy.

    `diagnostics` holds all errors of a scene at once. `file`, `line`, `column`, `key`, `message` and
    `remedy` are those of the first. `kind` is "scene" if the scene or the request is invalid, and
    "run" if a valid request failed.
    """

    def __init__(self, kind: str, diagnostics: Sequence[Tuple[str, str, str]]) -> None:
        super().__init__(kind, list(diagnostics))
        self.kind = kind
        self.diagnostics: List[Diagnostic] = [Diagnostic(*d) for d in diagnostics]

    def __str__(self) -> str:
        return "\n".join(str(d) for d in self.diagnostics)

    @property
    def _first(self) -> Diagnostic:
        return self.diagnostics[0]

    @property
    def file(self) -> Optional[str]:
        """The file of the first error."""
        return self._first.file

    @property
    def line(self) -> Optional[int]:
        """The line of the first error."""
        return self._first.line

    @property
    def column(self) -> Optional[int]:
        """The column of the first error."""
        return self._first.column

    @property
    def key(self) -> Optional[str]:
        """The key of the first error."""
        return self._first.key

    @property
    def message(self) -> str:
        """The message of the first error."""
        return self._first.message

    @property
    def remedy(self) -> Optional[str]:
        """What to do about the first error."""
        return self._first.remedy
