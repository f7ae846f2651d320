#include "verification/solid.h"

#include <algorithm>
#include <cmath>

#include "verification/admitted.h"

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
