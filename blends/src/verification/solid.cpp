#include "verification/solid.h"

#include <algorithm>
#include <cmath>

#include "verification/admitted.h"

namespace dupin::verification {
namespace {

Interval largest_radius(const std::vector<Tube>& tubes, double from, double to) {
  Interval result = tubes.front().radius_range(from, to);
  for (const Tube& tube : tubes) {
    result = max(result, tube.radius_range(from, to));
  }
  return result;
}

// Centres by the mean value theorem from the middle, normals by how far they turn from there.
std::optional<Discs> discs_of(const Piece& piece, const ParameterInterval& t) {
  if (!piece.tubes.empty()) {
    Discs result = piece.tubes.front().discs(t.from, t.to);
    result.radius = largest_radius(piece.tubes, t.from, t.to);
    return result;
  }
  const double middle = (t.from + t.to) / 2;
  const auto here = piece.motion(middle, middle), all = piece.motion(t.from, t.to);
  if (!here || !all) {
    return std::nullopt;
  }
  const Interval half =
      std::max((Interval(t.to) - middle).upper, (Interval(middle) - t.from).upper);
  const IntervalVec center = part(here->center, 0), step = half * part(all->center, 1);
  return Discs{{center - step, center + step},
               {part(here->normal, 0)},
               all->radius[0],
               (half * numbers::norm(part(all->normal, 1))).upper};
}

void read(const RingedSurface& surface, double, Piece& result) {
  result.tubes = {Tube(surface)};
  result.steered = result.motion = motion(result.tubes.front());
}

void read(const EllipticTube& tube, double, Piece& result) {
  result.tubes = {Tube({tube.start, tube.end, tube.spine, tube.first}),
                  Tube({tube.start, tube.end, tube.spine, tube.second})};
  result.steered = [about = motion(result.tubes.front()), axes = result.tubes](double from,
                                                                               double to) {
    auto disc = about(from, to);
    if (disc) {
      disc->radius[0] = largest_radius(axes, from, to);
    }
    return disc;
  };
}

void read(const CyclidePiece& piece, double wall, Piece& result) {
  result.steered = result.motion = motion(piece, 0);
  result.inner = wall > 0 ? motion(piece, wall) : Motion();
  result.shares_frame = true;
}

void read(const RationalRingedTube& tube, double, Piece& result) {
  result.motion = motion(tube.surface);
  result.steered = steered_motion(tube.surface);
}

}  // namespace

Piece::Piece(const dupin::Piece& certified, double wall) : shape(certified) {
  std::visit(
      [&](const auto& piece) {
        start = piece.start;
        end = piece.end;
        read(piece, wall, *this);
      },
      shape);
}

Solid::Solid(const CertifiedPart& certified) {
  const AdmittedPart admitted(certified);
  const CertifiedPart& part = *admitted;
  if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
    ball_ = *sphere;
    return;
  }
  const auto& chain = std::get<Chain>(part.shape);
  if (chain.joints == Joints::spherical) {
    is_full_ = false;
    return;
  }
  closed_ = chain.closed;
  is_full_ = chain.wall == 0 && !chain.pieces.empty();
  for (const dupin::Piece& shape : chain.pieces) {
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
