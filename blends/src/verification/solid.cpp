#include "verification/solid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "verification/admitted.h"
#include "verification/work.h"

namespace dupin::verification {

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
  return found != nullptr ? discs_of(*found, within_piece(t)) : std::nullopt;
}

bool Solid::is_run(const ParameterInterval& t) const {
  return !has_kneecaps_ && 0 <= t.from && t.to <= length() && t.from == std::floor(t.from) &&
         t.to == std::floor(t.to) && t.to - t.from > 1;
}

// A limit would see them spent by whoever asks first, which may be a claim that is not made.
const std::vector<IntervalVec>& Solid::boxes() const {
  std::call_once(boxes_->found, [this] {
    const WorkLimit not_counted(std::numeric_limits<std::uint64_t>::max());
    for (double i = 0; i < length(); ++i) {
      boxes_->of_pieces.push_back(box_of_piece(*this, i));
    }
  });
  return boxes_->of_pieces;
}

IntervalVec box_of_piece(const Solid& solid, double i) {
  constexpr double kQuarters = 4;
  std::optional<IntervalVec> box;
  for (double k = 0; k < kQuarters; ++k) {
    const auto discs = solid.discs({i + k / kQuarters, i + (k + 1) / kQuarters});
    if (!discs) {
      return {Interval::whole(), Interval::whole(), Interval::whole()};
    }
    const double radius = discs->radius.magnitude();
    for (const IntervalVec& center : discs->centers) {
      IntervalVec here = center;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        here.at(axis) = here.at(axis) + Interval(-radius, radius);
        here.at(axis) = box ? hull(box->at(axis), here.at(axis)) : here.at(axis);
      }
      box = here;
    }
  }
  return *box;
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
