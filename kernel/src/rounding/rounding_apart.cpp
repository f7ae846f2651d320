#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "dupin/kernel/contacts.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "dupin/kernel/placement.h"
#include "dupin/kernel/rounding.h"
#include "exact/float_lattice.h"
#include "rounding/rounding_options.h"

namespace dupin {
namespace {

/// In absolute value, seen from the origin.
double largest_coordinate(const Solid& solid, const Vec3& origin) {
  double largest = 0;
  for (const Vec3& point : solid.nearest_points()) {
    largest = std::max(largest, (point - origin).cwiseAbs().maxCoeff());
  }
  return largest;
}

double diagonal(const Solid& solid) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : solid.nearest_points()) {
    box.extend(point);
  }
  return box.diagonal().norm();
}

/// separate() asks for more than 2^-32 of the largest coordinate.
double least_distance(double largest) { return std::ldexp(1.0, std::ilogb(largest) - 31); }

/// separate(), about the place that is given: nearer to it, less will do. The moves are exact.
Solid separated_about(const Vec3& place, const Solid& solid, double distance) {
  Placement there, back;
  there.translate(-place);
  back.translate(place);
  return placed(separate(placed(solid, there), distance).solid, back);
}

/// By as few spacings of the numbers that are written as it takes; none where none does.
std::optional<RoundedApart> separated_and_rounded(const Solid& solid, Coordinates coordinates,
                                                  RoundingOptions options) {
  constexpr double kMost = 64;
  rounding::validate(options);
  const Vec3 origin = rounding::chosen_origin(options, solid.nearest_points());
  if (options.origin.choice ==
      Origin::Choice::automatic) {  // what is taken away must not change it
    options.origin = {.choice = Origin::Choice::given, .place = origin};
  }
  const double own = largest_coordinate(solid, origin);
  const double largest = std::max(own, rounding::largest_of(options, origin));
  const exact::FloatLattice numbers(coordinates, options.output_grid);
  const double spacing = std::max(numbers.step(largest), least_distance(own));
  const bool is_near = spacing >= least_distance(largest_coordinate(solid, Vec3::Zero()));
  // What is larger than the solid leaves nothing of it, and takes long to say so.
  const double most = std::min(kMost * spacing, diagonal(solid));
  for (double length = spacing; length <= most; length *= 2) {
    try {
      const Solid apart =
          is_near ? separate(solid, length).solid : separated_about(origin, solid, length);
      if (apart.empty() && !options.whole) {  // of a piece nothing may be left
        return std::nullopt;
      }
      Rounded rounded = to_mesh(apart, coordinates, options);
      if (rounded.contacts().empty()) {
        return RoundedApart{std::move(rounded), length, solid.contacts()};
      }
    } catch (const Error& error) {
      if (error.code() != Errc::contact && error.code() != Errc::unroundable) {
        throw;
      }
    }
  }
  return std::nullopt;
}

/// rounded_apart(), which tries no remedies.
RoundedApart untried(const Solid& solid, Coordinates coordinates, const RoundingOptions& options) {
  if (!solid.contacts().empty()) {
    if (auto apart = separated_and_rounded(solid, coordinates, options)) {
      return *std::move(apart);
    }
  }
  Rounded rounded = parted(to_mesh(solid, coordinates, options), options);
  const RoundingReport& report = rounded.report();
  const double length = report.parted_by;
  std::vector<Contact> contacts = report.parted;
  return {std::move(rounded), length, std::move(contacts)};
}

}  // namespace

RoundedApart rounded_apart(const Solid& solid, Coordinates coordinates,
                           const RoundingOptions& options) {
  const UsualArithmetic usual;
  RoundingOptions own = options;
  own.tries_remedies = false;
  try {
    return untried(solid, coordinates, own);
  } catch (const Error& error) {
    if (error.code() != Errc::unroundable || !options.tries_remedies) {
      throw;
    }
    throw with_remedies_tried(
        error, {&solid, 1}, coordinates, own, [&](const RoundingOptions& tried) {
          return rounding::does_round(
              [&] { return untried(solid, coordinates, tried).rounded.contacts().empty(); });
        });
  }
}

}  // namespace dupin
