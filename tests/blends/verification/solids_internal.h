#pragma once

#include <utility>

#include <Eigen/Geometry>

#include "blends/tubes.h"
#include "dupin/blends/certificate.h"
#include "verification/solid.h"

// What the verifier's tests are about: parts of a few numbers, whose discs everybody knows.
namespace dupin::test {

inline CyclidePiece cyclide_piece(const PeArc& arc) {
  return {flipped(circle_at(arc, 0)), circle_at(arc, 1), arc.start(),
          arc.start_tangent(),        arc.end(),         arc.chord()};
}

template <class... Pieces>
CertifiedPart part(const Pieces&... pieces) {
  Chain chain;
  (chain.pieces.emplace_back(pieces), ...);
  CertifiedPart result;
  result.shape = std::move(chain);
  return result;
}

template <class... Pieces>
verification::Solid solid(const Pieces&... pieces) {
  return verification::Solid(part(pieces...));
}

inline CertifiedPart ball_part(const Vec3& center, double radius) {
  CertifiedPart result;
  result.shape = Sphere{center, radius};
  return result;
}

inline verification::Solid ball(const Vec3& center, double radius) {
  return verification::Solid(ball_part(center, radius));
}

inline bool holds(const numbers::Interval& a, double x, double slack = 0) {
  return a.lower - slack <= x && x <= a.upper + slack;
}

inline bool holds(const numbers::IntervalVec& a, const Vec3& x, double slack = 0) {
  return holds(a[0], x[0], slack) && holds(a[1], x[1], slack) && holds(a[2], x[2], slack);
}

}  // namespace dupin::test
