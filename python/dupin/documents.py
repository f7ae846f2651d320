"""What is made of documents: solids, gaps, certificates, surfaces, bills of materials."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any, Union

from . import _core
from ._core import Certificate, Mesh, Solid
from .assembly import Assembly, plain
from .errors import InvalidArgument
from .meshes import Progress, same

#: An Assembly, a dict, or the name of a file: JSON, a piping file (.pcf) or a graph (.swc, .graph).
Document = Union[Assembly, Mapping, str, os.PathLike]


def _text_of(document: Document) -> tuple[str | bytes, bytes]:
    """A document's text, and its file's name, by which it is known what it is."""
    if isinstance(document, Assembly):
        return document.to_json(), b""
    if isinstance(document, Mapping):
        return json.dumps(plain(document)), b""
    if isinstance(document, (str, bytes, os.PathLike)):
        path = os.fsencode(document)
        return _core.read_text(path), path
    raise InvalidArgument(f"a {type(document).__name__} is no document; give an Assembly, a dict or a file's name")


def read_document(file: str | os.PathLike[str], *, radius: float | None = None, keep_going: bool = False,
                  snap: float | None = None, bridge: float = 0.0, wall: float | None = None) -> Assembly:
    """The document in a file. A piping file (.pcf) or a graph (.swc, .graph) becomes an assembly, in millimetres:
    `radius` is of a graph's nodes that have none, `snap` and `bridge` are how far apart ends of a piping file may be,
    `wall` the thickness of what says none; `keep_going` leaves out what is refused. Options that would
    do nothing to such a file are refused. Values and copies stay."""
    text, path = _text_of(file)
    graph, piping = path.lower().endswith((b".swc", b".graph")), path.lower().endswith(b".pcf")
    given = {"radius": (radius is not None, graph), "keep_going": (keep_going, graph or piping),
             "snap": (snap is not None, piping), "bridge": (bridge != 0, piping),
             "wall": (wall is not None, graph or piping)}
    if idle := [name for name, (is_given, is_of_use) in given.items() if is_given and not is_of_use]:
        raise InvalidArgument(f"{', '.join(idle)} would do nothing: radius is for graphs, files named .swc or .graph, "
                              "snap and bridge for piping files, named .pcf, wall and keep_going for both",
                              where=os.fsdecode(path))
    if graph or piping:
        return Assembly.from_json(_core.converted(text, path, radius, keep_going, snap, bridge, wall))
    _core.document_text(text, path)
    return Assembly.from_dict(json.loads(text))


class Built:
    """A built assembly: its solid, and what became of the parts."""

    def __init__(self, solid: Solid, report: dict[str, Any], findings: int) -> None:
        self.solid = solid
        #: Keys as of `dupin build --json`, without `output`.
        self.report = report
        #: How many pairs of ends are neither welded nor open, and how much of a graph or piping file is not as it says.
        self.findings = findings

    @property
    def unit(self) -> str:
        """Of all lengths."""
        return self.report["unit"]

    @property
    def parts(self) -> list[dict[str, Any]]:
        """A dict for each part: name, kind, margins, mesh error, ..."""
        return self.report["parts"]

    @property
    def gaps(self) -> list[dict[str, Any]]:
        """How the ends fit: from, to, verdict, and enclosures of distances."""
        return self.report["gaps"]["pairs"]

    @property
    def volumes(self) -> dict[str, float] | None:
        """Of outer, metal and fluid, where there are walls; of the insulation, if that was built."""
        return self.report.get("volumes")

    def mesh(self, **rounding: Any) -> Mesh:
        """The solid rounded once: see Solid.mesh."""
        return self.solid.mesh(**rounding)

    def write(self, file: str | os.PathLike[str], **options: Any) -> dict[str, Any]:
        """Writes the solid, verified, with its unit: see Solid.write."""
        return self.solid.write(file, **{"unit": self.unit, **options})

    def __repr__(self) -> str:
        return f"Built({len(self.parts)} parts, {self.solid!r})"


def build(document: Document, *, tolerance: float | None = None, segments: int | None = None,
          connect: float | None = None, most_triangles: int = _core.usual_triangles, contacts: str = "report",
          cross_check: str | None = None, region: str | None = None, progress: Progress = None) -> Built:
    """The whole line: resolve, certify, mesh, weld, unite, exactly.

    tolerance       largest distance between surfaces and mesh, instead of the document's, in its unit
    segments        around every ring, instead of what the tolerance asks for
    connect         ends up to this far apart belong together; the document's tolerance if not given
    most_triangles  of all parts, by an estimate made before they are meshed
    contacts        "report" or "refuse" what touches itself
    cross_check     "nef" or "corefinement": the union by another engine, compared exactly
    region          "outer", "metal", "fluid" or "insulation"; by default metal, where there are walls
    progress        progress(stage, fraction); returning False raises Cancelled

    Raises an Error that names part and place: IrregularSurface for a blend that folds, InfeasibleBlend for one that
    does not exist, InvalidArgument and ParseFailed for bad documents, LimitExceeded for too many triangles.
    """
    text, source = _text_of(document)
    solid, report, findings = _core.build(text, source, tolerance, segments, connect, most_triangles, contacts,
                                          cross_check, region, progress)
    values = json.loads(report)
    output = values.pop("output")
    if output.get("cross_check"):
        values["cross_check"] = output["cross_check"]
    return Built(solid, values, findings)


def gaps(document: Document, *, connect: float | None = None) -> dict[str, Any]:
    """How the ends of an assembly miss each other, exactly: `report["pairs"]` with verdicts, enclosures, and the
    rationals behind them; `report["findings"]` counts pairs that are neither welded nor open. Of a piping file it is the
    ends as the file has them, up to 1 mm apart if `connect` is not given, else up to the document's tolerance."""
    return json.loads(_core.gaps(*_text_of(document), connect))


def certify(document: Document, *, margin: float | None = None, tolerance: float | None = None,
            most_triangles: int = _core.usual_triangles, progress: Progress = None) -> Certificate:
    """Proves what it can about the smooth parts: no folds, no self-intersection, clearances, mesh error. What it
    cannot is undecided: `certificate.findings` counts that, `certificate.summary` says it."""
    return _core.certify(*_text_of(document), margin, tolerance, most_triangles, progress)


def verify(certificate: Certificate | str | os.PathLike[str], document: Document | None = None) -> Certificate:
    """Checks every claim of a certificate, or of one in a file, by other code than made it; and, if a document is
    given, that it is about this. Returns the certificate. Raises ParseFailed if a byte of it was changed, and
    InvalidArgument naming the part and claim that does not follow."""
    if not isinstance(certificate, Certificate):
        path = os.fsencode(certificate)
        certificate = _core.parse_certificate(_core.read_text(path), path)
    if document is not None:
        certificate._require_about(*_text_of(document))
    certificate.verify()
    return certificate


def nurbs(document: Document, *, tolerance: float | None = None) -> dict[str, Any]:
    """The parts' lateral surfaces as NURBS: exact where they are rational, else within the tolerance, proven. Keys as
    in what `dupin nurbs` writes."""
    return json.loads(_core.nurbs(*_text_of(document), tolerance))


def bill_of_materials(document: Document, *, density: float | None = None) -> dict[str, Any]:
    """Lengths, areas, volumes, masses of the parts, of their smooth surfaces; `density` in kg/m3. Keys as of
    `dupin bom --json`."""
    return json.loads(_core.bill_of_materials(*_text_of(document), density))


def schema(kind: str = "assembly") -> dict[str, Any]:
    """The JSON Schema of documents ("assembly") or certificates ("certificate")."""
    return json.loads(_core.schema(kind))


def _write_certificate(self: Certificate, file: str | os.PathLike[str]) -> None:
    """Writes the certificate to a file, in one step."""
    _core.write_text(os.fsencode(file), self.to_json())


def _summary(self: Certificate) -> dict[str, Any]:
    """What it says, without what proves it: keys as of `dupin certify --json`."""
    return json.loads(self._summary)


Certificate.write = _write_certificate
Certificate.summary = property(_summary)
Certificate.__copy__ = Certificate.__deepcopy__ = same
