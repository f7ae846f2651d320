#pragma once

#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "dupin/blends/certificate.h"
#include "verification/solid.h"

// What the verifier's tests are about: parts of a few numbers, whose discs everybody knows.
namespace dupin::test {

inline RingedSurface cone(const Vec3& from, const Vec3& to, double start, double end) {
  const Vec3 along = (to - from).normalized();
  const double slope = (end - start) / (to - from).norm();
  return {flipped(Ring{from, along, start, slope}),
          {to, along, end, slope},
          LineSpine{from, to},
          LinearRadius{start, end}};
}

inline RingedSurface cylinder(const Vec3& from, const Vec3& to, double radius) {
  const Vec3 along = (to - from).normalized();
  return {{from, -along, radius}, {to, along, radius}, LineSpine{from, to}, ConstantRadius{radius}};
}

/// About the z axis from (bend, 0, 0) towards y.
inline RingedSurface elbow(double bend, double angle, double radius) {
  const auto at = [=](double a) { return Vec3(bend * std::cos(a), bend * std::sin(a), 0); };
  const auto along = [](double a) { return Vec3(-std::sin(a), std::cos(a), 0); };
  return {{at(0), -along(0), radius},
          {at(angle), along(angle), radius},
          ArcSpine{Vec3(0, 0, 0), Vec3::UnitZ(), at(0), angle},
          ConstantRadius{radius}};
}

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
