#include "verification/solid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "verification/admitted.h"
#include "verification/work.h"

namespace dupin::verification {
namespace {

// Far more than a second.
constexpr std::uint64_t kNotCounted = std::numeric_limits<std::uint64_t>::max();

EndDisc disc_at(const Piece& piece, End end) {
  const double t = end == End::end ? 1 : 0;
  const auto disc = piece.steered(t, t);
  return disc ? EndDisc{part(disc->normal, 0), part(disc->center, 0)}
              : EndDisc{everywhere(), everywhere()};
}

// With spheres (m; r) the rim at an end is m + s u for u.m' = -r' and r - wall <= s <= r: where r
// grows outward, it leans over the disc of the outer skin. It lies in the hull of both discs.
Rim rim_of(const Piece& piece, End end) {
  const WorkLimit not_counted(kNotCounted);
  const double t = end == End::end ? 1 : 0;
  const auto outer = piece.motion(t, t), inner = piece.inner(t, t);
  if (!outer || !inner) {
    return {everywhere(), Interval::whole(), std::numeric_limits<double>::infinity()};
  }
  const IntervalVec center = part(inner->center, 0);
  const Interval advance = numbers::dot(center - part(outer->center, 0), part(outer->normal, 0));
  return {center, inner->radius[0], end == End::end ? advance.upper : -advance.lower};
}

}  // namespace

Solid::Solid(const CertifiedPart& certified) {
  const AdmittedPart admitted(certified);
  const CertifiedPart& part = *admitted;
  if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
    ball_ = *sphere;
    return;
  }
  const auto& chain = std::get<Chain>(part.shape);
  closed_ = chain.closed;
  wall_ = chain.wall;
  has_kneecaps_ = chain.joints == Joints::spherical;
  is_full_ = chain.wall == 0 && !chain.pieces.empty() && !has_kneecaps_;
  for (const dupin::Piece& shape : chain.pieces) {
    if (has_kneecaps_ && !pieces_.empty()) {
      const PeVector& knee = std::get<CyclidePiece>(shape).first;
      knees_.push_back({knee.m, knee.r});
    }
    pieces_.emplace_back(shape, chain.wall);
    is_full_ = is_full_ && pieces_.back().tubes.size() < 2;
  }
  if (wall_ > 0 && !closed_ && !pieces_.empty()) {
    rims_ = {rim_of(pieces_.front(), End::start), rim_of(pieces_.back(), End::end)};
  }
}

const Piece* Solid::piece(const ParameterInterval& t) const {
  const double index = std::floor(t.from);
  return 0 <= t.from && t.from <= t.to && t.to <= length() && t.to <= index + 1 &&
                 index < double(pieces_.size())
             ? &pieces_[std::size_t(index)]
             : nullptr;
}

std::optional<Discs> Solid::discs(const ParameterInterval& t) const {
  if (ball_) {
    return Discs{{numbers::interval_vec(ball_->center)}, {}, ball_->radius, 0};
  }
  const Piece* found = piece(t);
  auto result = found != nullptr ? discs_of(*found, within_piece(t)) : std::nullopt;
  for (const End end : {End::start, End::end}) {
    const auto& rim = rims_.at(at(end));
    if (result && rim && rim->beyond > 0 && (end == End::start ? t.from == 0 : t.to == length())) {
      result->centers.push_back(rim->center);
      result->radius = max(result->radius, Interval(rim->radius.magnitude()));
    }
  }
  return result;
}

bool Solid::is_run(const ParameterInterval& t) const {
  return !has_kneecaps_ && 0 <= t.from && t.to <= length() && t.from == std::floor(t.from) &&
         t.to == std::floor(t.to) && t.to - t.from > 1;
}

// A limit would see them spent by whoever asks first, which may be a claim that is not made.
const Solid::Looks& Solid::looks() const {
  std::call_once(looks_->found, [this] {
    const WorkLimit not_counted(kNotCounted);
    for (double i = 0; i < length(); ++i) {
      std::vector<IntervalVec> boxes;
      for (const auto& [center, radius] : balls_around_piece(*this, i)) {
        boxes.push_back(box_around(center, radius));
      }
      looks_->boxes.push_back(hull_of(boxes));
    }
    for (const Piece& piece : pieces_) {
      looks_->ends.push_back({disc_at(piece, End::start), disc_at(piece, End::end)});
    }
  });
  return *looks_;
}

const std::vector<IntervalVec>& Solid::boxes() const { return looks().boxes; }

double Solid::size_of_piece(std::size_t i) const {
  const IntervalVec& box = boxes()[i];
  Interval squared = 0;
  for (const Interval& side : box) {
    squared = squared + square(Interval(side.upper) - side.lower);
  }
  const double size = sqrt(squared).upper;
  return size >= 0 ? size : std::numeric_limits<double>::infinity();
}

bool have_rims_apart(const std::optional<Rim>& first, const std::optional<Rim>& second,
                     double tolerance) {
  const double beyond = std::max(first ? first->beyond : 0, second ? second->beyond : 0);
  return beyond <= tolerance || (first && second &&
                                 (numbers::norm(first->center - second->center) +
                                  Interval((first->radius - second->radius).magnitude()))
                                         .upper <= tolerance);
}

Step step_between(const EndDisc& before, const EndDisc& after) {
  constexpr double kMoreThanHalfPi = 1.6;  // an angle is at most so many times its chord
  return {(kMoreThanHalfPi * numbers::norm(after.normal - before.normal)).upper,
          numbers::norm(after.center - before.center).upper};
}

Step Solid::step_at(std::size_t i) const {
  const auto& ends = looks().ends;
  return step_between(ends[(i == 0 ? ends.size() : i) - 1][1], ends[i][0]);
}

EndDisc Solid::outward(End end) const {
  const auto& ends = looks().ends;
  if (ends.empty()) {
    return {everywhere(), everywhere()};
  }
  return end == End::end ? ends.back()[1]
                         : EndDisc{Interval(-1) * ends.front()[0].normal, ends.front()[0].center};
}

std::vector<PlacedBall> balls_around_piece(const Solid& solid, double i) {
  constexpr double kQuarters = 4;
  std::vector<PlacedBall> balls;
  for (double k = 0; k < kQuarters; ++k) {
    const auto discs = solid.discs({i + k / kQuarters, i + (k + 1) / kQuarters});
    if (!discs) {
      return {{everywhere(), 0}};
    }
    for (const IntervalVec& center : discs->centers) {
      balls.push_back({center, discs->radius.magnitude()});
    }
  }
  return balls;
}

IntervalVec hull_of(const IntervalVec& a, const IntervalVec& b) {
  return {hull(a[0], b[0]), hull(a[1], b[1]), hull(a[2], b[2])};
}

IntervalVec hull_of(const std::vector<IntervalVec>& boxes) {
  IntervalVec all = boxes.empty() ? everywhere() : boxes.front();
  for (const IntervalVec& box : boxes) {
    all = hull_of(all, box);
  }
  return all;
}

IntervalVec box_around(const IntervalVec& center, double radius) {
  const Interval reach(-radius, radius);
  return {center[0] + reach, center[1] + reach, center[2] + reach};
}

std::vector<Sphere> knees_at(const Solid& solid, const ParameterInterval& t) {
  std::vector<Sphere> result;
  const std::vector<Sphere>& knees = solid.knees();
  for (double i = std::max(1., std::ceil(t.from)); i <= std::min(t.to, double(knees.size())); ++i) {
    result.push_back(knees[std::size_t(i) - 1]);
  }
  return result;
}

ParameterInterval within_piece(const ParameterInterval& t) {
  const double index = std::floor(t.from);
  return {t.from - index, t.to - index};
}

std::vector<ParameterInterval> cut(const ParameterInterval& t) {
  std::vector<ParameterInterval> result;
  for (double from = t.from; from < t.to; from = std::floor(from) + 1) {
    result.push_back({from, std::min(t.to, std::floor(from) + 1)});
  }
  return result;
}

}  // namespace dupin::verification
