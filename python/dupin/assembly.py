"""The builder of documents."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Mapping
from typing import Any

from . import _core
from ._parts import PartMethods
from .errors import InvalidArgument


#: Deeper than any document may be nested, by a margin.
_DEEPEST = 100


def _require_number(number: int, pointer: str) -> None:
    try:
        float(number)
    except OverflowError:
        raise InvalidArgument("the int is beyond all floats, which end at 1.8e308", where=pointer) from None


def _require_text(text: str, pointer: str) -> None:
    """Lone surrogates are in no UTF-8."""
    try:
        text.encode()
    except UnicodeEncodeError as error:
        raise InvalidArgument(f"the str has a lone surrogate, {text[error.start]!a}, which no document can hold",
                              where=pointer) from None


def plain(value: Any, pointer: str = "", around: tuple[int, ...] = ()) -> Any:
    """The value as JSON has it: NumPy's arrays and numbers become lists and numbers. Raises InvalidArgument, with the
    JSON pointer, for what no document can hold. `around` are the dicts and lists that it is in."""
    if hasattr(value, "tolist") and not isinstance(value, (list, tuple)):
        value = value.tolist()
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if isinstance(value, (Mapping, list, tuple)):
        if id(value) in around:
            raise InvalidArgument(f"a {type(value).__name__} contains itself", where=pointer)
        if len(around) == _DEEPEST:
            raise InvalidArgument(f"nested more than {_DEEPEST} deep", where=pointer[:60] + "…")
        around = (*around, id(value))
        if isinstance(value, Mapping):
            for key in value:
                _require_text(str(key), pointer)
            return {str(key): plain(item, f"{pointer}/{key}", around) for key, item in value.items()}
        return [plain(item, f"{pointer}/{index}", around) for index, item in enumerate(value)]
    if isinstance(value, str):
        _require_text(value, pointer)
    if isinstance(value, int):
        _require_number(value, pointer)
    if isinstance(value, float) and not math.isfinite(value):
        raise InvalidArgument(f"{value} is no finite number", where=pointer)
    if value is None or isinstance(value, (str, bool, int, float)):
        return value
    raise InvalidArgument(f"a {type(value).__name__} cannot be part of a document", where=pointer)


class Assembly(PartMethods):
    """A document, made part by part; each method returns the assembly, so that calls can be chained.

    There is a method for each key of docs/assembly_format.md: `pipe`, `cone`, `elbow`, `cyclic_blend`, `fillet`, ...
    Its arguments are what stands below the key, `from` being spelled `from_`, and what may stand beside it: `wall`,
    `solid`, `comment`, `for_`. Whether it all holds together is said by `build`, or by `validate` before.
    """

    def __init__(self, *, units: str = "mm", tolerance: Any = 0.05, segments: Any = None, wall: Any = None,
                 values: Mapping[str, Any] | None = None, comment: str | None = None) -> None:
        head = {"units": units, "tolerance": tolerance, "segments": segments, "wall": wall, "comment": comment,
                "values": values}
        self._document = {key: plain(value, f"/{key}") for key, value in head.items() if value is not None}
        self._document["parts"] = []

    @classmethod
    def from_dict(cls, document: Mapping[str, Any]) -> Assembly:
        """An assembly that goes on from a document."""
        assembly = cls()
        assembly._document = plain(document)
        assembly._document.setdefault("parts", [])
        return assembly

    @classmethod
    def from_json(cls, text: str) -> Assembly:
        """The same, of its text."""
        _core.document_text(text, "")  # raises with line and column
        return cls.from_dict(json.loads(text))

    def add(self, part: Mapping[str, Any]) -> Assembly:
        """Adds a part, or an entry that makes copies, as it stands in a document."""
        self._document["parts"].append(plain(part, f"/parts/{len(self)}"))
        return self

    def _add_part(self, key: str, name: str, below: dict[str, Any], beside: dict[str, Any]) -> Any:
        def given(values: dict[str, Any]) -> dict[str, Any]:
            return {word.rstrip("_"): value for word, value in values.items() if value is not None}

        return self.add({"name": name, **given(beside), key: given(below)})

    def __copy__(self) -> Assembly:
        """An assembly of its own: what is added to one is not in the other."""
        made = type(self).__new__(type(self))
        made.__dict__.update(self.__dict__, _document=self.to_dict())
        return made

    def to_dict(self) -> dict[str, Any]:
        """The document; a copy."""
        return json.loads(json.dumps(self._document))

    def to_json(self) -> str:
        """The document's text, a part on each line."""
        head = {key: value for key, value in self._document.items() if key != "parts"}
        lines = [f"  {json.dumps(key)}: {json.dumps(value)},\n" for key, value in head.items()]
        parts = ",\n".join("    " + json.dumps(part) for part in self._document["parts"])
        return "{\n" + "".join(lines) + '  "parts": [\n' + parts + "\n  ]\n}\n"

    def write(self, file: str | os.PathLike[str]) -> Assembly:
        """Writes the document to a file, in one step."""
        _core.write_text(os.fsencode(file), self.to_json())
        return self

    def validate(self) -> Assembly:
        """Raises what `build` would, before any blend is certified or meshed: bad keys, ports, numbers, blends that do
        not exist."""
        _core.require_valid(self.to_json(), "")
        return self

    def __len__(self) -> int:
        return len(self._document["parts"])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Assembly) and self._document == other._document

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"Assembly({len(self)} parts)"
