#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "dupin/kernel/contacts.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "dupin/kernel/rounding.h"

namespace dupin {
namespace {

// By as few spacings of the numbers as it takes; none where none does.
std::optional<RoundedApart> separated_and_rounded(const Solid& solid, Coordinates coordinates,
                                                  const RoundingOptions& options) {
  constexpr double kMost = 64;
  double largest = 0;
  for (const Vec3& point : solid.nearest_points()) {
    largest = std::max(largest, point.cwiseAbs().maxCoeff());
  }
  // separate() asks for more than 2^-32 of the largest coordinate.
  const int digits = coordinates == Coordinates::binary32 ? 23 : 31;
  const double spacing = std::ldexp(1.0, std::ilogb(largest) - digits);
  for (double length = spacing; length <= kMost * spacing; length *= 2) {
    try {
      Settled settled = separate(solid, length);
      Rounded rounded = to_mesh(settled.solid, coordinates, options);
      if (rounded.contacts().empty()) {
        return RoundedApart{std::move(rounded), length, std::move(settled.contacts)};
      }
    } catch (const Error& error) {
      if (error.code() != Errc::contact && error.code() != Errc::unroundable) {
        throw;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

RoundedApart rounded_apart(const Solid& solid, Coordinates coordinates,
                           const RoundingOptions& options) {
  const UsualArithmetic usual;
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

}  // namespace dupin
