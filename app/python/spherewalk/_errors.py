# SPDX-License-Identifier: Apache-2.0
"""The exceptions that spherewalk raises: all are spherewalk.Error, and each is Python's own kind besides."""

from __future__ import annotations

from typing import ClassVar


class Error(Exception):
    """What went wrong, as a sentence for people: what was tried, on what, and what to do.

    ``kind`` is what a program needs to know of it, as spherewalk-cli and the logs spell it.
    """

    kind: ClassVar[str] = "internal"


class InvalidInputError(Error, ValueError):
    """What the caller gave cannot be used; nothing was done."""

    kind = "invalid_input"


class NotFoundError(Error, FileNotFoundError):
    """A file that should be there is not."""

    kind = "not_found"


class ReadError(Error, OSError):
    """The operating system refused to read."""

    kind = "io"


class CorruptError(Error, ValueError):
    """A file contradicts itself, its format, or its dataset."""

    kind = "corrupt"


class UnsupportedError(Error, NotImplementedError):
    """Well-formed, but beyond what this version can do."""

    kind = "unsupported"


class BusyError(Error, RuntimeError):
    """In use by another thread, or made by another process."""

    kind = "busy"


class StoppedError(Error, RuntimeError):
    """The caller asked to stop."""

    kind = "stopped"


_KINDS = {
    error.kind: error
    for error in (InvalidInputError, NotFoundError, ReadError, CorruptError, UnsupportedError, BusyError, StoppedError)
}


def of_kind(kind: str, sentence: str) -> Error:
    """The exception of this kind; of one that the library has and this list has not, a plain Error."""
    return _KINDS.get(kind, Error)(sentence)
