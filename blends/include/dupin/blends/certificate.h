#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "dupin/blends/assembly.h"
#include "dupin/blends/regularity.h"
#include "dupin/blends/resolve.h"
#include "dupin/blends/sphere.h"

namespace dupin {

/// A shape that nothing is proven about: all claims about it are undecided.
struct OtherShape {};

/// What a certificate is about: a part as `resolve` made it. A tube is the union of its discs, the
/// circles of the ringed surface filled; a sphere is a ball.
struct CertifiedPart {
  std::string name, kind;
  std::variant<RingedSurface, Sphere, OtherShape> shape;
  std::array<std::optional<EndIndex>, 2> joined;
};

/// 1 - kappa R > margin and R > 0 on [0, 1].
struct RegularClaim {
  Verdict verdict = Verdict::undecided;
  double margin = 0;
  std::vector<ParameterInterval> leaves;  ///< proved: they cover [0, 1], in order
  ParameterInterval where;                ///< refuted: the claim fails at one of its ends
};

/// A rectangle of pairs of parameters and why their discs are apart: all of `first` lie behind and
/// all of `second` in front of a plane across `direction`; or, without one, the spine turns by at
/// most a right angle between them (docs/certificate_format.md has the proof).
struct DiscPairs {
  ParameterInterval first, second;
  std::optional<Vec3> direction;
};

/// A point that lies inside a disc at some parameter within `first`, and inside another one, of the
/// other part or of the same, at some parameter within `second`.
struct Overlap {
  Vec3 point;
  ParameterInterval first, second;
};

/// The discs are pairwise disjoint, together with those of straight pipes or cones that go on from
/// the ends: of length extension[0] for parameters in [-1, 0] and extension[1] in [1, 2]; 0 for
/// none.
struct EmbeddedClaim {
  Verdict verdict = Verdict::undecided;
  std::array<double, 2> extension = {};
  std::vector<DiscPairs> leaves;   ///< proved: they cover all pairs first <= second
  std::optional<Overlap> overlap;  ///< refuted
};

/// Upper bounds, in radians, of Tangency::deviation and Tangency::axis_angle at an end.
struct TangencyClaim {
  double deviation = 0, axis_angle = 0;
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
  std::vector<TangencyClaim> tangency;    ///< at start and end; none for spheres
  std::optional<MeshClaim> mesh;          ///< none for other shapes
};

/// How far apart two parts are that are not joined. Proved without an overlap: no two points of
/// them are closer than `distance` > 0. Proved with one: they overlap, so that they are connected
/// anyhow.
struct ClearanceClaim {
  std::uint32_t first = 0, second = 0;
  Verdict verdict = Verdict::undecided;
  double distance = 0;
  std::vector<DiscPairs> leaves;  ///< cover all pairs of parameters; each has a direction
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

  /// Claims that are refuted or undecided.
  [[nodiscard]] std::size_t findings() const;
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

/// Checks every proved and every refuted claim again from the certificate's own inputs, by other
/// code than the prover's. Throws Error{invalid_argument} naming the part and claim that does not
/// follow.
void verify(const Certificate& certificate);

}  // namespace dupin
