#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "certification/search_work.h"
#include "dupin/blends/certificate.h"
#include "numbers/interval.h"
#include "surfaces/pieces/piece_discs.h"

// This folder: the prover of certificates. A part is the union of its discs D(t), t in [0, length];
// the claims are made of that: regular (neighbouring discs are disjoint), embedded (all are),
// clearances (those of two parts are). Searches halve rectangles of parameters until a plane
// separates the discs' hulls, or a lemma of docs/certificate_format.md does, and record the halving
// as leaves. Nothing here need be believed: verification/ checks the leaves with code of its own,
// so a search may be clever.

namespace dupin::certification {

using surfaces::DiscHull;
using surfaces::DiscPace;
using surfaces::size;
using surfaces::support;
using surfaces::support_point;

/// A run of whole pieces, between two of them; a shorter stretch in its middle.
[[nodiscard]] std::pair<ParameterInterval, ParameterInterval> halves(const ParameterInterval& t);

/// The discs of a part, in outward rounded arithmetic. Parameters are in [0, length()], whole
/// numbers being the seams of a chain; a ball's are in [0, 1]. Of a chain with kneecaps the discs
/// next to a joint come with its ball, which holds what lies between them.
class SweptDiscs {
 public:
  /// What is asked of the discs is spent of `work`, if given; it outlives this.
  explicit SweptDiscs(const Sphere& sphere, SearchWork* work = nullptr);
  explicit SweptDiscs(const Chain& chain, SearchWork* work = nullptr);
  /// Any hulls of stretches of [0, length]: what is in them is no part, and nothing is known of it
  /// besides.
  SweptDiscs(std::size_t length, const std::function<DiscHull(const ParameterInterval&)>& hull,
             SearchWork* work = nullptr);

  [[nodiscard]] double length() const { return part_->sphere ? 1 : double(part_->pieces.size()); }
  [[nodiscard]] bool closed() const { return part_->closed; }
  [[nodiscard]] bool has_kneecaps() const { return part_->has_kneecaps; }
  /// Whether it touches a joint with a kneecap.
  [[nodiscard]] bool touches_knee(const ParameterInterval& t) const;
  /// The same discs, for a search that spends of this work.
  [[nodiscard]] SweptDiscs with(SearchWork* work) const;
  /// The same discs, without the joints' balls.
  [[nodiscard]] SweptDiscs discs_only() const;
  /// The part is the union of its discs: neither hollow nor elliptic, and without kneecaps.
  [[nodiscard]] bool full() const { return part_->full; }
  /// One for each piece, or for the ball.
  [[nodiscard]] std::vector<ParameterInterval> stretches() const;
  /// There are so many pieces that runs of them are looked at, too.
  [[nodiscard]] bool has_runs() const { return !part_->boxes.empty(); }
  /// What searches begin with: the same, or all of many pieces at once.
  [[nodiscard]] std::vector<ParameterInterval> roots() const;
  /// The searches have to end.
  [[nodiscard]] bool is_out_of_work() const { return work_ != nullptr && work_->is_used_up(); }
  [[nodiscard]] bool has_work_for(std::uint64_t units) const;
  [[nodiscard]] std::uint64_t work_spent() const;
  /// Whether more is left than half of what was when so much was spent.
  [[nodiscard]] bool has_half_since(std::uint64_t spent) const;
  /// For what they do besides looking at discs.
  void spend(std::uint64_t units) const;
  /// The stored rings of its ends, if it has any.
  [[nodiscard]] const std::vector<Ring>& end_rings() const { return part_->end_rings; }

  /// Requires no seam inside t, or whole pieces: of these the discs are in a box.
  [[nodiscard]] DiscHull over(const ParameterInterval& t) const;

  /// Whether the discs at any two parameters in t are disjoint because t has no seam and the spine
  /// turns by at most a right angle or is an arc, given that the part is regular with this margin.
  [[nodiscard]] bool turns_little(const ParameterInterval& t, double margin) const;

  /// Whether all discs in t are on one side of the planes of its first and of its last one, because
  /// t has no seam and the spine is a line, or an arc of less than half a turn.
  [[nodiscard]] bool stays_on_one_side(const ParameterInterval& t) const;

  /// Appends what `advances` needs about t, seams allowed; false where the numbers do not tell.
  [[nodiscard]] bool append_way(const ParameterInterval& t, std::vector<DiscPace>& way) const;

 private:
  class Hulls;
  [[nodiscard]] std::size_t piece_of(const ParameterInterval& t) const;
  [[nodiscard]] DiscHull hull_over(const ParameterInterval& t) const;
  [[nodiscard]] DiscHull over_run(const ParameterInterval& t) const;

  /// What is the same for all searches, which may be several at once.
  struct Part {
    std::optional<Sphere> sphere;
    std::vector<surfaces::PieceDiscs> pieces;
    std::vector<Eigen::AlignedBox3d> boxes;  ///< of the pieces, where there are many
    std::vector<Ring> end_rings;
    std::vector<Sphere> knees;
    /// By end, of a hollow chain the centre of the inner circle, as the rim may lean over the disc.
    std::array<std::optional<numbers::IntervalVec>, 2> rims;
    bool closed = false, full = true, has_kneecaps = false;
  };
  [[nodiscard]] static Part of_chain(const Chain& chain);

  SearchWork* work_;
  std::shared_ptr<const Part> part_;
  std::shared_ptr<Hulls> hulls_;  ///< of a search, which is in one thread; none without work
};

}  // namespace dupin::certification
