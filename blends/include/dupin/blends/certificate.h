#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "dupin/blends/assembly.h"
#include "dupin/blends/elliptic_tube.h"
#include "dupin/blends/pe_arc.h"
#include "dupin/blends/regularity.h"
#include "dupin/blends/resolve.h"
#include "dupin/blends/ringed_tube.h"
#include "dupin/blends/sphere.h"

namespace dupin {

/// A piece of a cyclide: the canal surface of the spheres (m; r) on the rational quadratic with the
/// homogeneous points first, (e first + D tangent / 2) / chord, D / chord^2 last and the weights 1,
/// e / chord, D / chord^2, where d = last - first, D = <d, d>, e = <d, tangent>. It is defined by
/// these numbers exactly, even where the tangent is a PE-unit vector only up to rounding.
struct CyclidePiece {
  Ring start, end;
  PeVector first, tangent, last;
  double chord = 1;
};

/// Discs that move for t in [0, 1]: the circles of a surface filled, or, for an elliptic tube, the
/// larger circles about its ellipses.
using CertifiedPiece = std::variant<RingedSurface, EllipticTube, CyclidePiece, RationalRingedTube>;

/// Pieces one after the other, piece i being that of the parameters [i, i + 1]; a closed chain
/// begins again where it ends.
struct PieceChain {
  std::vector<CertifiedPiece> pieces;
  bool closed = false;
  double wall = 0;  ///< of a hollow chain of cyclide pieces, inwards; 0: solid
};

/// A shape that nothing is proven about: all claims about it are undecided.
struct OtherShape {};

/// What a certificate is about: a part as `resolve` made it. A tube is the union of its discs; a
/// sphere is a ball.
struct CertifiedPart {
  std::string name, kind;
  std::variant<PieceChain, Sphere, OtherShape> shape;
  std::array<std::optional<EndIndex>, 2> joined;
};

/// R > 0 and 1 - R |n'| / (c'.n) > margin for centres c and normals n: 1 - kappa R where the discs
/// are normal to the curve of their centres.
struct RegularClaim {
  Verdict verdict = Verdict::undecided;
  double margin = 0;
  std::vector<ParameterInterval> leaves;  ///< proved: they cover all parameters, in order
  ParameterInterval where;                ///< refuted: the claim fails at one of its ends
};

/// A rectangle of pairs of parameters and why their discs are apart: all of `first` lie behind and
/// all of `second` in front of a plane across `direction`; or, without one, they do not turn enough
/// on the way to come back (docs/certificate_format.md has the proofs).
struct DiscPairs {
  ParameterInterval first, second;
  std::optional<Vec3> direction;
};

/// A point that lies inside a disc at some parameter within `first`, and inside another one, of the
/// other part or of the same, at some parameter within `second`. An interval of length 0 at an end
/// of an open chain stands for the disc of the stored ring there, border included.
struct Overlap {
  Vec3 point;
  ParameterInterval first, second;
};

/// The discs are pairwise disjoint.
struct EmbeddedClaim {
  Verdict verdict = Verdict::undecided;
  std::vector<DiscPairs> leaves;   ///< proved: they cover all pairs first <= second
  std::optional<Overlap> overlap;  ///< refuted
};

/// Upper bounds at an end of a piece.
struct TangencyClaim {
  /// Tangency::deviation, in radians; none for elliptic tubes and general ringed surfaces.
  std::optional<double> deviation;
  double axis_angle = 0;  ///< between the disc's normal and the ring's, in radians
  double offset = 0;      ///< of the disc's centre from the ring's, plus that of the radii
  /// Of ringed surfaces, their curvature along the parameter lines: what it jumps by where a
  /// cylinder or cone goes on (curvature_jump.h).
  std::optional<double> curvature = {};
};

/// The mesh with vertices on the circles at `knots` (those of spheres follow from the segments)
/// stays within `error_bound` of the part, both ways.
struct MeshClaim {
  std::uint32_t segments = 0;
  double grid = 0;
  std::vector<double> knots;
  double error_bound = 0;
};

struct PartClaims {
  std::optional<RegularClaim> regular;    ///< none for spheres
  std::optional<EmbeddedClaim> embedded;  ///< none for spheres
  std::vector<TangencyClaim> tangency;    ///< at start and end of every piece; none for spheres
  std::optional<MeshClaim> mesh;          ///< none: undecided
};

/// How far apart two parts are. Proved without an overlap: no two points of them are closer than
/// `distance` > 0 or, for parts that are joined, they have nothing in common but the disc of the
/// joint. With one: they overlap, which proves that parts that are not joined are connected anyhow,
/// and refutes the claim for others.
struct ClearanceClaim {
  std::uint32_t first = 0, second = 0;
  Verdict verdict = Verdict::undecided;
  double distance = 0;
  std::vector<DiscPairs>
      leaves;  ///< cover all pairs of parameters; a direction is missing near a joint only
  std::optional<Overlap> overlap;
};

/// Claims about an assembly, each with what is needed to check it again: see `verify`.
struct Certificate {
  std::string document, document_sha256;  ///< the file that the parts were read from, if any
  Unit unit = Unit::millimetre;
  double tolerance = 0;
  std::vector<CertifiedPart> parts;
  std::vector<PartClaims> claims;  ///< one per part
  std::vector<ClearanceClaim> clearances;

  /// Claims that are refuted or undecided, missing ones included.
  [[nodiscard]] std::size_t findings() const;

  /// Whether the two parts are joined at a port.
  [[nodiscard]] bool joined(const ClearanceClaim& claim) const;
};

struct CertifyOptions {
  /// To be proven of every part, in [0, 1); none: nearly the largest that holds.
  std::optional<double> margin = {};
  /// Boxes of parameters that one claim may be divided into before it is left undecided.
  std::size_t boxes = 1 << 14;
};

/// Proves what it can about the smooth parts and their meshes, in exact rational or outward rounded
/// arithmetic; what it cannot is undecided. Throws as `resolve` and `tessellate` do, and
/// Error{invalid_argument} for a margin outside [0, 1).
[[nodiscard]] Certificate certify(const Assembly& assembly, const CertifyOptions& options = {});

}  // namespace dupin
