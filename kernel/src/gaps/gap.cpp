#include "dupin/kernel/gap.h"

#include <array>
#include <utility>

#include "exact/exact_numbers.h"
#include "exact/exact_vector.h"

namespace dupin {
namespace {

using exact::cross;
using exact::dot;
using exact::ExactVector;
using exact::rational;

ExactVector exact_vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

GapVerdict verdict_of(const GapReport& report, bool facing, bool same_normal) {
  if (!facing) {
    return GapVerdict::open;
  }
  if (const int side = sgn(report.axial_dot); side != 0) {
    return side > 0 ? GapVerdict::gap : GapVerdict::overlap;
  }
  if (report.radius_difference != 0 || report.across_difference != 0) {
    return GapVerdict::step;
  }
  if (report.turn_sine_squared != 0) {
    return GapVerdict::turn;
  }
  if (!same_normal) {
    return GapVerdict::kink;
  }
  return report.offset_squared != 0 ? GapVerdict::offset : GapVerdict::welded;
}

std::vector<Deviation> deviations_of(const GapReport& report, bool same_normal, bool elliptic) {
  std::vector<Deviation> all;
  const auto list = [&all](bool present, Deviation::Kind kind, const Enclosure& size) {
    if (present) {
      all.push_back({kind, size});
    }
  };
  list(report.axial_dot != 0, Deviation::Kind::axial, report.axial);
  list(report.radius_difference != 0, Deviation::Kind::radius, report.radius);
  list(elliptic && report.across_difference != 0, Deviation::Kind::across, report.across);
  list(report.turn_sine_squared != 0, Deviation::Kind::turn, report.turn);
  list(!same_normal, Deviation::Kind::kink, report.kink);
  list(report.offset_squared != 0, Deviation::Kind::offset, report.offset);
  const bool first = report.slope_difference != 0;
  list(first || report.across_slope_difference != 0, Deviation::Kind::slope,
       enclosure_of(first ? report.slope_difference : report.across_slope_difference));
  return all;
}

Enclosure signed_length(const mpq_class& scaled, const mpq_class& scale_squared) {
  const Enclosure length = root_of(scaled * scaled / scale_squared);
  return scaled < 0 ? -length : length;
}

// The rings' semi-axes and slopes, those of b in the order of the directions of a's that they are
// nearer to.
void compare_axes(const Ring& a, Ring b, GapReport& report) {
  if (a.ellipse && b.ellipse) {
    const ExactVector u = exact_vector(a.ellipse->axis), v = exact_vector(b.ellipse->axis),
                      turn = exact::cross(u, v);
    const mpq_class along = exact::rational(exact::dot(u, v)),
                    aside_squared = exact::rational(exact::dot(turn, turn));
    const bool exchanged = aside_squared > along * along;
    if (exchanged) {
      std::swap(b.radius, b.ellipse->across);
      std::swap(b.slope, b.ellipse->across_slope);
    }
    const mpq_class sine = exchanged ? along * along : aside_squared;
    const mpq_class cosine = exchanged ? aside_squared : along * along;
    report.turn_sine_squared = sine / exact::rational(exact::dot(u, u) * exact::dot(v, v));
    // tan(turn) = sqrt(sine / cosine)
    report.turn = angle_of(sine / cosine, 1);
  }
  report.radius_difference = mpq_class(b.radius) - mpq_class(a.radius);
  report.across_difference = mpq_class(across(b)) - mpq_class(across(a));
  report.slope_difference = mpq_class(a.slope) + mpq_class(b.slope);
  report.across_slope_difference = mpq_class(across_slope(a)) + mpq_class(across_slope(b));
  report.radius = enclosure_of(report.radius_difference);
  report.across = enclosure_of(report.across_difference);
}

}  // namespace

std::string_view name(GapVerdict verdict) {
  constexpr std::array<std::string_view, 8> kNames = {"welded", "gap",  "overlap", "step",
                                                      "turn",   "kink", "offset",  "open"};
  return kNames.at(static_cast<std::size_t>(verdict));
}

std::string_view name(Deviation::Kind kind) {
  constexpr std::array<std::string_view, 7> kNames = {"axial", "radius", "across", "turn",
                                                      "kink",  "offset", "slope"};
  return kNames.at(static_cast<std::size_t>(kind));
}

GapReport measure_gap(const Ring& a, const Ring& b) {
  validate(a);
  validate(b);
  const ExactVector n = exact_vector(a.normal), m = exact_vector(b.normal);
  const ExactVector d = exact_vector(b.center) - exact_vector(a.center);
  const ExactVector across = exact::cross(d, n), turn = exact::cross(n, m);
  const mpq_class along = exact::rational(exact::dot(n, m)),
                  turn_squared = exact::rational(exact::dot(turn, turn));
  const mpq_class both_squared = exact::rational(exact::dot(n, n) * exact::dot(m, m));
  const bool same_normal = a.normal == -b.normal;

  GapReport report;
  report.axial_dot = exact::rational(exact::dot(d, n));
  report.normal_squared = exact::rational(exact::dot(n, n));
  report.offset_squared = exact::rational(exact::dot(across, across)) / report.normal_squared;
  report.distance_squared = exact::rational(exact::dot(d, d));
  compare_axes(a, b, report);
  report.kink_sine_squared = turn_squared / both_squared;
  report.kink_cosine_squared = along * along / both_squared;
  report.axial = signed_length(report.axial_dot, report.normal_squared);
  report.offset = root_of(report.offset_squared);
  report.kink = angle_of(turn_squared, -along);
  report.verdict = verdict_of(report, along < 0, same_normal);
  report.deviations = deviations_of(report, same_normal, a.ellipse || b.ellipse);
  return report;
}

}  // namespace dupin
