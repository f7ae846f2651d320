#include "rounding/rounding_options.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "boxes/bounds.h"
#include "dupin/kernel/decimal.h"

namespace dupin::rounding {
namespace {

constexpr std::string_view kLargerTolerance = "a larger tolerance",
                           kRecentring = "recentring (origin auto)",
                           kRemedies = "; what may help: ", kAnd = ", ";

// Without one of the remedies, and without what leads to them where it is the only one.
std::string without(std::string message, std::string_view remedy) {
  std::size_t at = message.find(remedy), size = remedy.size();
  if (message.compare(at + size, kAnd.size(), kAnd) == 0) {
    size += kAnd.size();
  } else {
    const std::string_view lead = message.substr(0, at).ends_with(kRemedies) ? kRemedies : kAnd;
    at -= lead.size();
    size += lead.size();
  }
  return message.erase(at, size);
}

}  // namespace

void validate(const RoundingOptions& options) {
  int exponent = 0;
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance)) {
    throw Error(Errc::invalid_argument, "the rounding tolerance must be finite and not negative");
  }
  if (options.output_grid != 0 && !(options.output_grid > 0 && std::isfinite(options.output_grid) &&
                                    std::frexp(options.output_grid, &exponent) == 0.5)) {
    throw Error(Errc::invalid_argument,
                "the grid spacing must be 0 or a power of two, such as 0.0009765625 (2^-10)");
  }
  if (!options.origin.place.allFinite()) {
    throw Error(Errc::invalid_argument, "the origin must be finite");
  }
  if (options.whole &&
      !(options.whole->box.min().allFinite() && options.whole->box.max().allFinite() &&
        options.whole->largest >= 0 && std::isfinite(options.whole->largest))) {
    throw Error(Errc::invalid_argument,
                "the box about the whole and its largest coordinate must be finite");
  }
}

Vec3 chosen_origin(const RoundingOptions& options, std::span<const Vec3> points) {
  const Origin& origin = options.origin;
  if (origin.choice == Origin::Choice::keep || (points.empty() && !options.whole)) {
    return Vec3::Zero();
  }
  if (origin.choice == Origin::Choice::given) {
    return origin.place;
  }
  const Eigen::AlignedBox3d whole = options.whole ? options.whole->box : boxes::bounds_of(points);
  const double extent = (whole.max() / 2 - whole.min() / 2).maxCoeff();
  const double step = extent > 0 ? std::exp2(std::ilogb(extent) - 3) : 0;
  Vec3 place = whole.min() / 2 + whole.max() / 2;
  for (double& coordinate : place) {
    coordinate = step > 0 ? std::nearbyint(coordinate / step) * step : coordinate;
  }
  return place;
}

double largest_of(const RoundingOptions& options, const Vec3& origin) {
  if (!options.whole || options.whole->largest > 0) {
    return options.whole ? options.whole->largest : 0;
  }
  const Eigen::AlignedBox3d& box = options.whole->box;
  return std::max((box.min() - origin).cwiseAbs().maxCoeff(),
                  (box.max() - origin).cwiseAbs().maxCoeff());
}

RoundingOptions recentred(RoundingOptions options) {
  options.origin = {.choice = Origin::Choice::automatic, .place = Vec3::Zero()};
  if (options.whole) {
    options.whole->largest = 0;
  }
  return options;
}

Error unroundable_error(const Unroundable& what) {
  std::string message =
      what.is_nothing
          ? "rounding leaves nothing of the solid, which is smaller than the numbers of the target "
            "format can tell"
          : "no valid mesh with coordinates of the target format within the tolerance of " +
                decimal(what.tolerance, kMessageDigits) +
                (what.is_loss ? ", unless what is thinner than their distances is lost" : "");
  std::vector<std::string> remedies;
  if (what.is_on_output_grid) {
    remedies.emplace_back("a finer grid, or none");
  } else {
    if (what.is_far) {
      remedies.emplace_back(kRecentring);
    }
    if (what.coordinates == Coordinates::binary32 && what.do_doubles_tell) {
      remedies.emplace_back("a format that holds doubles (OFF, OBJ, PLY instead of STL)");
    }
  }
  if (!what.is_nothing) {
    remedies.emplace_back(kLargerTolerance);
  }
  for (std::size_t i = 0; i < remedies.size(); ++i) {
    message += std::string(i == 0 ? kRemedies : kAnd) + remedies[i];
  }
  return Error(Errc::unroundable, message, {}, decimal(what.at));
}

bool does_round(const std::function<bool()>& attempt) {
  try {
    return attempt();
  } catch (const Error& error) {
    if (error.code() != Errc::unroundable) {
      throw;
    }
    return false;
  }
}

namespace {

/// Larger ones, each as it is said, and last `usual`.
std::vector<double> larger_tolerances(double tolerance, double usual) {
  constexpr double kGrowth = 4;
  constexpr int kTries = 3;
  std::vector<double> tries;
  for (int i = 0; i < kTries; ++i) {
    tolerance *= kGrowth;
    tries.push_back(rounded(tolerance, kMessageDigits));
  }
  if (usual > tries.back()) {
    tries.push_back(rounded(usual, kMessageDigits));
  }
  return tries;
}

}  // namespace

Error with_remedies_tried(const Error& error, const RoundingOptions& options, double usual,
                          const std::function<bool(const RoundingOptions&)>& would_do) {
  std::string message = error.message();
  if (message.ends_with(kLargerTolerance)) {
    const auto tries = larger_tolerances(options.tolerance > 0 ? options.tolerance : usual, usual);
    const auto found = std::ranges::find_if(tries, [&](double tolerance) {
      RoundingOptions tried = options;
      tried.tolerance = tolerance;
      return would_do(tried);
    });
    message = found == tries.end()
                  ? without(message, kLargerTolerance) + "; a tolerance of " +
                        decimal(tries.back(), kMessageDigits) + " would not do"
                  : message + " (" + decimal(*found, kMessageDigits) + " would do)";
  }
  if (message.find(kRecentring) != std::string::npos && !would_do(recentred(options))) {
    message = without(message, kRecentring);
  }
  return Error(error.code(), message, error.part(), error.where());
}

}  // namespace dupin::rounding
