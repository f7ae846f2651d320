#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dupin/blends/assembly.h"
#include "dupin/blends/canal_fillet.h"
#include "dupin/blends/part_surface.h"
#include "dupin/blends/regularity.h"
#include "dupin/blends/resolve.h"
#include "dupin/blends/tangency.h"

namespace dupin {

/// What a certificate is about: a part as `resolve` made it. A solid chain with smooth joints is
/// the union of its discs, which move for t in [0, 1] along every piece: the circles of a surface
/// filled or, for an elliptic tube, the larger circles about its ellipses. Of one with kneecaps
/// they leave out what the joints' balls have between them. A sphere is a ball. Of a chain without
/// pieces nothing is proven: all claims about it are undecided.
struct CertifiedPart {
  std::string name, kind;
  PartSurface shape;
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

/// The discs are pairwise disjoint; those of a chain with kneecaps in each piece, and of its pieces
/// and kneecaps all that are not neighbours.
struct EmbeddedClaim {
  Verdict verdict = Verdict::undecided;
  std::vector<DiscPairs> leaves;   ///< proved: they cover all pairs first <= second
  std::optional<Overlap> overlap;  ///< refuted
};

/// How the pieces of a chain with kneecaps are meshed (docs/certificate_format.md).
struct KneecapMesh {
  double turn = 0;   ///< radians by which columns turn at most from row to row
  double apart = 0;  ///< what is no further apart at a joint may count as one
  /// Of every joint, and then of every one of the inner skin: its kneecap's triangles lie in
  /// circles of at most the radius r sin(pi / segments), r being that of its ball.
  std::vector<std::uint32_t> segments;
};

/// The mesh with vertices on the circles or ellipses at `knots` (those of spheres follow from the
/// segments) stays within `error_bound` of the part, both ways.
struct MeshClaim {
  std::uint32_t segments = 0;
  double grid = 0;
  std::vector<double> knots;
  double error_bound = 0;
  double axes = 0;  ///< radians by which the axes of its ellipses may be turned in their planes
  std::vector<double> inner_knots = {};  ///< those of a hollow chain's inner skin
  std::optional<KneecapMesh> kneecaps = {};
};

struct PartClaims {
  std::optional<RegularClaim> regular;    ///< none for spheres
  std::optional<EmbeddedClaim> embedded;  ///< none for spheres
  std::vector<TangencyClaim> tangency;    ///< at start and end of every piece; none for spheres
  std::optional<MeshClaim> mesh;          ///< none: undecided
};

/// How far apart two parts are. Proved without an overlap: no two points of them are closer than
/// `distance` > 0 or, for parts that are joined, they have nothing in common but the disc of the
/// joint, or, for an arm and its hub, the arm's circles lie outside but for the last. With one:
/// they overlap, which proves that parts that are not joined are connected anyhow, and refutes the
/// claim for others.
struct ClearanceClaim {
  std::uint32_t first = 0, second = 0;
  Verdict verdict = Verdict::undecided;
  double distance = 0;
  std::vector<DiscPairs>
      leaves;  ///< cover all pairs of parameters; a direction is missing near a joint only
  std::optional<Overlap> overlap;
  /// Of a loop that meets a part, or one of another fillet, in corners: what counts as one corner
  /// is nowhere further apart. 0: they do not meet so.
  double corner = 0;
};

/// A fillet as `resolve` made it: `between` are indices of parts. Its loops have the parameters
/// [0, 2] (docs/certificate_format.md), and their quadrics are those of these parts' end rings.
struct CertifiedFillet {
  std::string name;
  std::array<std::uint32_t, 2> between{};
  std::array<std::array<bool, 2>, 2> buried{};
  std::vector<CanalFillet> loops;
};

/// A junction as `resolve` made it: indices of parts. The hub is a ball in which all arms end,
/// touching it along their last circles; its surface is what these leave of the ball's.
struct CertifiedJunction {
  std::uint32_t hub = 0;
  std::vector<std::uint32_t> arms;
};

/// Upper bounds, all along both feet.
struct ContactClaim {
  double offset = 0;     ///< of how much nearer or further the quadric is than the ball's radius
  double deviation = 0;  ///< of the angle between the envelope and the quadric, radians
};

/// What is claimed of a loop of a fillet.
struct LoopClaims {
  RegularClaim regular;  ///< least_regularity > margin, and radius > 0
  /// The arcs are pairwise disjoint, but in corners.
  EmbeddedClaim embedded;
  std::optional<ContactClaim> contact;  ///< none: undecided
  /// The mesh with vertices on the arcs at `knots`, each divided equally into so many segments.
  std::optional<MeshClaim> mesh;
};

/// What is larger is no certificate: whoever reads it knows what it may cost before it is checked.
struct CertificateLimits {
  /// Of a spine, a radius law or a rotation: 1 more than the degree. Blends have up to 8.
  static constexpr std::size_t kCoefficients = 13;
  static constexpr double kWeight = 0x1p100;  ///< of a spine's points, and not below its inverse
  static constexpr double kNumber = 0x1p300;  ///< of all numbers but digests' and parameters'
  static constexpr std::uint32_t kSegments = 1'000'000;  ///< the most that a tessellation has
  /// Work of the checker in units of about a microsecond: so much for any certificate, and so much
  /// more for every number in its shapes and claims.
  static constexpr std::uint64_t kWork = 3'000'000, kWorkPerNumber = 12;
};

/// What a certificate of an assembly is about.
struct CertifiedInputs {
  std::vector<CertifiedPart> parts;
  std::vector<CertifiedFillet> fillets;
  std::vector<CertifiedJunction> junctions;
};

/// Parts are those of `resolve`, then the hubs. Throws as `resolve`.
[[nodiscard]] CertifiedInputs certified_inputs(const Assembly& assembly);

/// Three directions in space, of any lengths.
using Directions = std::array<Vec3, 3>;

/// Claims about an assembly, each with what is needed to check it again: see `verify`.
struct Certificate {
  std::string document, document_sha256;  ///< the file that the parts were read from, if any
  Unit unit = Unit::millimetre;
  double tolerance = 0;
  std::vector<CertifiedPart> parts;
  std::vector<CertifiedFillet> fillets;
  std::vector<CertifiedJunction> junctions;
  std::vector<PartClaims> claims;                      ///< one per part
  std::vector<std::vector<LoopClaims>> fillet_claims;  ///< one per loop of every fillet
  /// No two parts without a clearance claim of their own are closer; 0: all have one.
  double apart = 0;
  /// Along which boxes tell that; none: along the axes of coordinates. For `apart` only.
  std::optional<Directions> axes;
  std::vector<ClearanceClaim> clearances;  ///< ascending by their parts
  /// Of every loop and every part but the two that it joins, then of it and every later loop, loop
  /// by loop: `first` and `second` are surfaces, which are numbered parts first, then loops in the
  /// order of the fillets. What meets in corners is claimed to have only these in common.
  std::vector<ClearanceClaim> fillet_clearances;

  /// The part's name, or that of the fillet that a loop belongs to.
  [[nodiscard]] const std::string& surface_name(std::uint32_t surface) const;

  /// Claims that are refuted or undecided, missing ones included.
  [[nodiscard]] std::size_t findings() const;

  /// Whether the two parts are joined at a port, or an arm and its hub.
  [[nodiscard]] bool joined(const ClearanceClaim& claim) const;
};

/// Checks every proved and every refuted claim again from the certificate's own inputs, by other
/// code than the prover's. Throws Error{invalid_argument} naming the part and claim that does not
/// follow.
void verify(const Certificate& certificate);

}  // namespace dupin
