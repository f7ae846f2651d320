#pragma once

#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "certification/moving_disc.h"
#include "certification/swept_disc_tube.h"
#include "dupin/blends/certificate.h"
#include "numbers/interval.h"

namespace dupin::certification {

/// Encloses the discs of a stretch of a part. A ball counts as a disc of any normal.
struct DiscHull {
  std::vector<numbers::IntervalVec> centers;  ///< their convex hull contains all centres
  std::vector<numbers::IntervalVec>
      tangents;              ///< the cone they span contains all normals, but for `spread`
  Vec3 axis = Vec3::Zero();  ///< roughly the mean normal
  double cosine = 0;         ///< below those of all angles between axis and normals; 0: any normal
  numbers::Interval radius;  ///< of all radii; infinite where nothing is known
  double spread = 0;         ///< the largest angle between a normal and the cone

  [[nodiscard]] Vec3 middle() const;
  /// A length that falls as the stretch does.
  [[nodiscard]] double extent() const;
};

/// Encloses the largest value of x.w over the discs' points from above.
[[nodiscard]] double support(const DiscHull& hull, const Vec3& w);

/// Roughly the point of the hull furthest in this direction.
[[nodiscard]] Vec3 support_point(const DiscHull& hull, const Vec3& direction);

[[nodiscard]] inline double size(const ParameterInterval& t) { return t.to - t.from; }
[[nodiscard]] std::pair<ParameterInterval, ParameterInterval> halves(const ParameterInterval& t);

/// The discs of a piece; parameters are in [0, 1].
using PieceDiscs = std::variant<SweptDiscTube, CyclidePiece, RationalRingedSurface>;

[[nodiscard]] PieceDiscs piece_discs(const CertifiedPiece& piece);
[[nodiscard]] DiscHull hull_over(const PieceDiscs& piece, const ParameterInterval& t);
/// None where the numbers do not tell.
[[nodiscard]] std::optional<DiscPace> pace_over(const PieceDiscs& piece,
                                                const ParameterInterval& t);

/// The discs of a part, in outward rounded arithmetic. Parameters are in [0, length()], whole
/// numbers being the seams of a chain; a ball's are in [0, 1]. Of other shapes nothing is known:
/// their length is 0.
class SweptDiscs {
 public:
  explicit SweptDiscs(const Sphere& sphere);
  explicit SweptDiscs(const PieceChain& chain);
  explicit SweptDiscs(const OtherShape&) : full_(false) {}

  [[nodiscard]] double length() const { return sphere_ ? 1 : double(pieces_.size()); }
  [[nodiscard]] bool closed() const { return closed_; }
  /// The part is the union of its discs: neither hollow nor elliptic.
  [[nodiscard]] bool full() const { return full_; }
  /// One for each piece, or for the ball.
  [[nodiscard]] std::vector<ParameterInterval> stretches() const;
  /// The stored rings of its ends, if it has any.
  [[nodiscard]] const std::vector<Ring>& end_rings() const { return end_rings_; }

  /// Requires no seam inside t.
  [[nodiscard]] DiscHull over(const ParameterInterval& t) const;

  /// Whether the discs at any two parameters in t are disjoint because t has no seam and the spine
  /// turns by at most a right angle, given that the part is regular with this margin.
  [[nodiscard]] bool turns_little(const ParameterInterval& t, double margin) const;

  /// Appends what `advances` needs about t, seams allowed; false where the numbers do not tell.
  [[nodiscard]] bool append_way(const ParameterInterval& t, std::vector<DiscPace>& way) const;

 private:
  [[nodiscard]] std::size_t piece_of(const ParameterInterval& t) const;

  std::optional<Sphere> sphere_;
  std::vector<PieceDiscs> pieces_;
  std::vector<Ring> end_rings_;
  bool closed_ = false, full_ = true;
};

}  // namespace dupin::certification
