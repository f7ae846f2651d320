"""What goes wrong, as exceptions: one class for each code of the library, all of them Error."""

from __future__ import annotations


class Error(Exception):
    """Every error of the library.

    `str(error)` is a sentence for people: part, place, fault, remedy. For programs there are

    code     "infeasible_blend", "parse_failed", ...: the name of the fault
    part     the part or operand at fault; may be empty
    where    the place in it: file:line, a JSON pointer, an argument; may be empty
    message  the sentence without part and place
    """

    code = ""

    def __init__(self, message: str, part: str = "", where: str = "", text: str | None = None) -> None:
        super().__init__(text if text is not None else ": ".join(filter(None, [where, part, message])))
        self.message = message
        self.part = part
        self.where = where

    def __reduce__(self):  # copies, and travels between processes, with all it knows
        return type(self), (self.message, self.part, self.where, str(self))


class InvalidArgument(Error, ValueError):
    """A value outside its documented range, or a document that does not hold together."""

    code = "invalid_argument"


class NotClosed(Error, ValueError):
    """A mesh with boundary edges where a solid is needed."""

    code = "not_closed"


class NotManifold(Error, ValueError):
    """An edge or vertex whose faces do not form one fan."""

    code = "not_manifold"


class NotOriented(Error, ValueError):
    """Neighbouring faces that disagree, or an inside-out shell."""

    code = "not_oriented"


class SelfIntersecting(Error, ValueError):
    """Faces that meet where they should not."""

    code = "self_intersecting"


class IrregularSurface(Error):
    """A part that folds or crosses itself."""

    code = "irregular_surface"


class InfeasibleBlend(Error):
    """No blend of the asked kind exists between these ends."""

    code = "infeasible_blend"


class BooleanFailed(Error):
    """A boolean operation that an engine refuses."""

    code = "boolean_failed"


class ContactRefused(Error):
    """A result that touches itself, where that is forbidden or the format cannot hold it."""

    code = "contact"


class Unroundable(Error):
    """No valid mesh with representable coordinates within the allowed move."""

    code = "unroundable"


class LimitExceeded(Error):
    """More data than the stated limits."""

    code = "limit_exceeded"


class Cancelled(Error):
    """The caller's progress callback returned False."""

    code = "cancelled"


class ParseFailed(Error, ValueError):
    """Text or bytes that are not what the format demands."""

    code = "parse_failed"


class IoFailed(Error, OSError):
    """The operating system refused to read or write `filename`, for the reason `errno`, which is `strerror` in words;
    both are None where it gave none, as for a file that changed while it was read."""

    code = "io_failed"

    def __init__(self, message: str, part: str = "", where: str = "", text: str | None = None,
                 reason: tuple[int, str] | None = None) -> None:
        super().__init__(message, part, where, text)
        self.filename = where or None
        self.errno, self.strerror = reason or (None, None)

    def __reduce__(self):
        reason = None if self.errno is None else (self.errno, self.strerror)
        return type(self), (self.message, self.part, self.where, str(self), reason)

    def __str__(self) -> str:  # OSError's own, where it has a filename, says nothing else
        return self.args[0]


class InternalError(Error, RuntimeError):
    """A bug of Dupin's."""

    code = "internal"


_CLASSES = {kind.code: kind for kind in Error.__subclasses__()}


def error_of(code: str, message: str, part: str = "", where: str = "", text: str | None = None,
             reason: tuple[int, str] | None = None) -> Error:
    """The exception of a code; `reason` is an errno and its text."""
    more = (reason,) if code == IoFailed.code else ()
    return _CLASSES.get(code, Error)(message, part, where, text, *more)
