#include "certification/swept_discs.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "surfaces/cyclide_discs.h"
#include "surfaces/pieces/surface_piece.h"

namespace dupin::certification {
namespace {

ParameterInterval part_of(const ParameterInterval& t, int part, int parts) {
  return {std::lerp(t.from, t.to, double(part) / parts),
          std::lerp(t.from, t.to, double(part + 1) / parts)};
}

// As discs of any normal that are as large as the larger of both.
void include(const Sphere& ball, std::vector<numbers::IntervalVec>::iterator at, DiscHull& hull) {
  hull.centers.insert(at, numbers::interval_vec(ball.center));
  hull.radius = max(hull.radius, numbers::Interval(ball.radius));
  hull.cosine = 0;
}

// Of fewer pieces each pair is looked at.
constexpr std::size_t kManyPieces = 16;

bool is_run(const ParameterInterval& t) { return t.to - t.from > 1; }

void extend(Eigen::AlignedBox3d& box, const numbers::IntervalVec& center, double radius) {
  const Vec3 around = Vec3::Constant(radius);
  box.extend(Vec3(Vec3(center[0].lower, center[1].lower, center[2].lower) - around));
  box.extend(Vec3(Vec3(center[0].upper, center[1].upper, center[2].upper) + around));
}

// Of the pieces's discs, in quarters; infinite where nothing is known.
Eigen::AlignedBox3d box_of(const surfaces::PieceDiscs& piece) {
  constexpr int kQuarters = 4;
  Eigen::AlignedBox3d box;
  for (int i = 0; i < kQuarters; ++i) {
    const DiscHull hull = piece.hull(part_of({0, 1}, i, kQuarters));
    for (const numbers::IntervalVec& c : hull.centers) {
      extend(box, c, hull.radius.upper);
    }
  }
  return box;
}

// None where the rim does not reach beyond the disc, as those across a spine never do, and
// everywhere where nothing is known.
std::optional<numbers::IntervalVec> rim_of(const Piece& piece, double wall, End end) {
  const auto* cyclide = std::get_if<CyclidePiece>(&piece);
  if (cyclide == nullptr) {
    return std::nullopt;
  }
  const numbers::Interval t = end == End::end ? 1 : 0;
  const surfaces::CyclideDiscs discs(*cyclide);
  const auto outer = discs.over(t), inner = discs.over(t, wall);
  if (!outer || !inner) {
    const numbers::Interval any = numbers::Interval::whole();
    return numbers::IntervalVec{any, any, any};
  }
  const numbers::Interval advance = numbers::dot(inner->center - outer->center, outer->normal);
  const bool is_beyond = (end == End::end ? advance.upper : -advance.lower) > 0;
  return is_beyond ? std::optional(inner->center) : std::nullopt;
}

}  // namespace

std::pair<ParameterInterval, ParameterInterval> halves(const ParameterInterval& t) {
  const double middle = is_run(t) ? t.from + std::floor((t.to - t.from) / 2) : 0;
  return is_run(t) ? std::pair(ParameterInterval{t.from, middle}, ParameterInterval{middle, t.to})
                   : surfaces::halves(t);
}

// Those asked for before: a search looks at a stretch of one part with many of the other.
class SweptDiscs::Hulls {
 public:
  template <typename Make>
  const DiscHull& over(const ParameterInterval& t, const Make& make) {
    constexpr std::size_t kMost = 16384;  // some megabytes
    const auto key = std::pair(t.from, t.to);
    if (const auto known = hulls_.find(key); known != hulls_.end()) {
      return known->second;
    }
    if (hulls_.size() == kMost) {
      hulls_.clear();
    }
    return hulls_.emplace(key, make()).first->second;
  }

 private:
  std::map<std::pair<double, double>, DiscHull> hulls_;
};

SweptDiscs::SweptDiscs(const Sphere& sphere, SearchWork* work)
    : work_(work), part_(std::make_shared<const Part>(Part{sphere, {}, {}, {}, {}})) {}

SweptDiscs::Part SweptDiscs::of_chain(const Chain& chain) {
  Part part;
  part.closed = chain.closed;
  part.has_kneecaps = chain.joints == Joints::spherical;
  part.full = chain.wall == 0 && !part.has_kneecaps && !chain.pieces.empty();
  for (const Piece& piece : chain.pieces) {
    if (part.has_kneecaps && !part.pieces.empty()) {
      const PeVector& knee = std::get<CyclidePiece>(piece).first;
      part.knees.push_back({knee.m, knee.r});
    }
    part.pieces.push_back(std::visit([](const auto& p) { return surfaces::discs(p); }, piece));
    part.full = part.full && part.pieces.back().full;
  }
  if (chain.wall > 0 && !part.closed && !part.pieces.empty()) {
    part.rims = {rim_of(chain.pieces.front(), chain.wall, End::start),
                 rim_of(chain.pieces.back(), chain.wall, End::end)};
  }
  if (part.pieces.size() >= kManyPieces && !part.has_kneecaps) {
    std::ranges::transform(part.pieces, std::back_inserter(part.boxes), box_of);
    for (const End end : {End::start, End::end}) {
      if (const auto& rim = part.rims.at(at(end))) {
        extend(end == End::end ? part.boxes.back() : part.boxes.front(), *rim,
               end_ring(chain, end).radius);
      }
    }
  }
  if (!part.closed && !part.pieces.empty()) {
    part.end_rings = {end_ring(chain, End::start), end_ring(chain, End::end)};
  }
  return part;
}

SweptDiscs::SweptDiscs(const Chain& chain, SearchWork* work)
    : work_(work),
      part_(std::make_shared<const Part>(of_chain(chain))),
      hulls_(work != nullptr ? std::make_shared<Hulls>() : nullptr) {
  spend(4 * part_->boxes.size());
}

SweptDiscs::SweptDiscs(std::size_t length,
                       const std::function<DiscHull(const ParameterInterval&)>& hull,
                       SearchWork* work)
    : work_(work) {
  Part part;
  part.full = false;
  for (std::size_t i = 0; i < length; ++i) {
    part.pieces.push_back({[hull, i](const ParameterInterval& t) {
                             return hull({t.from + double(i), t.to + double(i)});
                           },
                           [](const ParameterInterval&) { return std::optional<DiscPace>(); },
                           [](const ParameterInterval&, double) { return false; },
                           [](const ParameterInterval&) { return false; }, false});
  }
  part_ = std::make_shared<const Part>(std::move(part));
}

SweptDiscs SweptDiscs::with(SearchWork* work) const {
  SweptDiscs result = *this;
  result.work_ = work;
  result.hulls_ = work != nullptr ? std::make_shared<Hulls>() : nullptr;
  return result;
}

std::vector<ParameterInterval> SweptDiscs::stretches() const {
  std::vector<ParameterInterval> result;
  for (double t = 0; t < length(); ++t) {
    result.push_back({t, t + 1});
  }
  return result;
}

std::vector<ParameterInterval> SweptDiscs::roots() const {
  return part_->boxes.empty() ? stretches() : std::vector{ParameterInterval{0, length()}};
}

std::size_t SweptDiscs::piece_of(const ParameterInterval& t) const {
  return std::min(std::size_t(t.from), part_->pieces.size() - 1);
}

bool SweptDiscs::has_work_for(std::uint64_t units) const {
  return work_ == nullptr || work_->has(units);
}

std::uint64_t SweptDiscs::work_spent() const { return work_ != nullptr ? work_->spent() : 0; }

bool SweptDiscs::has_half_since(std::uint64_t spent) const {
  return work_ == nullptr || work_->has_half_since(spent);
}

void SweptDiscs::spend(std::uint64_t units) const {
  if (work_ != nullptr) {
    work_->spend(units);
  }
}

// The box's rounding is what kDiscSlack leaves to rounding. A direction of no meaning: it is
// divided.
DiscHull SweptDiscs::over_run(const ParameterInterval& t) const {
  Eigen::AlignedBox3d box;
  for (auto i = std::size_t(t.from); i < std::size_t(t.to); ++i) {
    box.extend(part_->boxes[i]);
  }
  if (!box.min().allFinite() || !box.max().allFinite()) {
    return {{{}}, {{}}, Vec3::UnitX(), 0, {0, std::numeric_limits<double>::infinity()}, 0};
  }
  DiscHull hull{{}, {numbers::interval_vec(Vec3::UnitX())}, Vec3::UnitX(), 0, 0, 0};
  for (int i = 0; i < 8; ++i) {
    hull.centers.push_back(numbers::interval_vec(box.corner(Eigen::AlignedBox3d::CornerType(i))));
  }
  return hull;
}

DiscHull SweptDiscs::over(const ParameterInterval& t) const {
  spend(1);
  return hulls_ ? hulls_->over(t, [&] { return hull_over(t); }) : hull_over(t);
}

DiscHull SweptDiscs::hull_over(const ParameterInterval& t) const {
  if (is_run(t)) {
    return over_run(t);
  }
  if (part_->sphere) {
    return {{numbers::interval_vec(part_->sphere->center)},
            {},
            Vec3::Zero(),
            0,
            part_->sphere->radius,
            0};
  }
  const std::size_t i = piece_of(t);
  DiscHull hull = part_->pieces[i].hull({t.from - double(i), t.to - double(i)});
  if (part_->rims[0] && t.from == 0) {
    hull.centers.insert(hull.centers.begin(), *part_->rims[0]);
  }
  if (part_->rims[1] && t.to == length()) {
    hull.centers.push_back(*part_->rims[1]);
  }
  if (i > 0 && i <= part_->knees.size() && t.from == double(i)) {
    include(part_->knees[i - 1], hull.centers.begin(), hull);
  }
  if (i < part_->knees.size() && t.to == double(i + 1)) {
    include(part_->knees[i], hull.centers.end(), hull);
  }
  return hull;
}

bool SweptDiscs::touches_knee(const ParameterInterval& t) const {
  return std::max(1., std::ceil(t.from)) <= std::min(t.to, double(part_->knees.size()));
}

SweptDiscs SweptDiscs::discs_only() const {
  Part part = *part_;
  part.knees.clear();
  SweptDiscs result = with(work_);
  result.part_ = std::make_shared<const Part>(std::move(part));
  return result;
}

bool SweptDiscs::turns_little(const ParameterInterval& t, double margin) const {
  const std::size_t i = piece_of(t);
  return t.to <= double(i + 1) &&
         part_->pieces[i].turns_little({t.from - double(i), t.to - double(i)}, margin);
}

bool SweptDiscs::stays_on_one_side(const ParameterInterval& t) const {
  const std::size_t i = piece_of(t);
  return !part_->pieces.empty() && t.to <= double(i + 1) &&
         part_->pieces[i].stays_on_one_side({t.from - double(i), t.to - double(i)});
}

bool SweptDiscs::append_way(const ParameterInterval& t, std::vector<DiscPace>& way) const {
  constexpr int kCells = 4;
  constexpr std::uint64_t kWorkOfPace = 8;  // of moving frames, more than a hull
  for (double from = t.from; from < t.to; from = std::floor(from) + 1) {
    const double to = std::min(t.to, std::floor(from) + 1);
    const std::size_t i = piece_of({from, to});
    for (int k = 0; k < kCells; ++k) {
      spend(kWorkOfPace);
      const auto pace =
          part_->pieces[i].pace(part_of({from - double(i), to - double(i)}, k, kCells));
      if (!pace) {
        return false;
      }
      way.push_back(*pace);
    }
  }
  return !part_->pieces.empty();
}

}  // namespace dupin::certification
