#pragma once

#include <concepts>
#include <utility>
#include <variant>
#include <vector>

#include "dupin/blends/cyclide_piece.h"
#include "dupin/blends/elliptic_tube.h"
#include "dupin/blends/end.h"
#include "dupin/blends/rational_ringed_surface.h"
#include "dupin/blends/ringed_surface.h"
#include "dupin/kernel/vec.h"

namespace dupin {

/// A tube between the two rings that it stores, swept by a disc for t in [0, 1]. What every kind of
/// piece must be able to do is stated, and checked, in blends/src/surfaces/pieces/surface_piece.h.
using Piece = std::variant<RingedSurface, EllipticTube, CyclidePiece, RationalRingedTube>;

struct Sphere {
  Vec3 center = Vec3::Zero();
  double radius = 1;
};

/// How the pieces of a chain meet.
enum class Joints {
  smooth,     ///< in one ring, which is the end of one piece and, flipped, the start of the next
  spherical,  ///< in a sphere that both touch: cyclide pieces only, see cyclide_tube.h
};

/// Pieces one after the other, piece i being that of the parameters [i, i + 1]. Nearly every part
/// is one: a single piece for a pipe, cone, elbow or blend.
struct Chain {
  /// None: a shape of which nothing is known, which what asks for more than pieces refuses by
  /// Error{invalid_argument}.
  std::vector<Piece> pieces;
  bool closed = false;  ///< it begins again where it ends
  /// Thickness of a hollow chain, inwards, whose rims are conical strips along the normals; 0 for a
  /// solid one. Cyclide pieces only.
  double wall = 0;
  Joints joints = Joints::smooth;

  Chain() = default;
  /// The chain of a single piece.
  template <std::convertible_to<Piece> Single>
  Chain(Single piece) : pieces{std::move(piece)} {}
  /// Of pieces of one kind.
  template <std::convertible_to<Piece> Single>
  explicit Chain(const std::vector<Single>& all, bool is_closed = false)
      : pieces(all.begin(), all.end()), closed(is_closed) {}
};

/// The geometry of a part.
using PartSurface = std::variant<Chain, Sphere>;

/// The ring stored at an end, its normal pointing out.
template <class Tube>
requires std::same_as<decltype(Tube::start), Ring>
[[nodiscard]] const Ring& end_ring(const Tube& tube, End end) {
  return end == End::start ? tube.start : tube.end;
}
[[nodiscard]] const Ring& end_ring(const Piece& piece, End end);
/// That of the first or last piece.
[[nodiscard]] const Ring& end_ring(const Chain& chain, End end);

/// The ring of a part's port, its normal pointing out of the part; none where the part is closed.
[[nodiscard]] const Ring* port_ring(const PartSurface& surface, End end);

/// How the ring of a part's port moves as it leaves the part, at unit speed.
[[nodiscard]] MovingRing leaving(const PartSurface& surface, End end);

/// The arcs of a chain's cyclide pieces; none of other pieces.
[[nodiscard]] std::vector<PeArc> cyclide_pieces(const Chain& chain);
[[nodiscard]] std::vector<PeArc> cyclide_pieces(const PartSurface& surface);

}  // namespace dupin
