#pragma once

#include <functional>
#include <span>

#include "dupin/kernel/error.h"
#include "dupin/kernel/rounding.h"

namespace dupin::rounding {

inline constexpr double kDefaultTolerance = 1024;  // steps

/// Throws invalid_argument unless the options make sense.
void validate(const RoundingOptions& options);

/// The place that becomes (0, 0, 0), of all these points if they are the whole: the origin for
/// none.
[[nodiscard]] Vec3 chosen_origin(const RoundingOptions& options, std::span<const Vec3> points);

/// The largest coordinate of the larger whole, in absolute value, from this origin; 0 if there is
/// none.
[[nodiscard]] double largest_of(const RoundingOptions& options, const Vec3& origin);

/// The same, about an origin in the middle of the whole.
[[nodiscard]] RoundingOptions recentred(RoundingOptions options);

/// What there is to say of a solid that no mesh stands for on the numbers of a format.
struct Unroundable {
  Vec3 at = Vec3::Zero();  ///< a place where it fails
  double tolerance = 0;
  Coordinates coordinates = Coordinates::binary64;
  bool is_far = false;             ///< the solid is smaller than its distance from the origin
  bool is_on_output_grid = false;  ///< the numbers are those of RoundingOptions::output_grid
  bool is_loss =
      false;  ///< cut, it would be valid, but lack what is further off than the tolerance
  bool is_nothing = false;      ///< what rounding leaves has no triangle, whatever the tolerance
  bool do_doubles_tell = true;  ///< the solid is larger than their distances in its place
};

/// With the options that may help. Ends by asking for a larger tolerance, unless none helps.
[[nodiscard]] Error unroundable_error(const Unroundable& what);

/// The same error. Where it asks for a larger tolerance, it says one that would do, or one that
/// would not; where it asks for recentring, that goes if it would not do. Found by asking of a few
/// options: larger tolerances than theirs, and last `usual`, which is the one where they have none;
/// and with the origin recentred.
[[nodiscard]] Error with_remedies_tried(
    const Error& error, const RoundingOptions& options, double usual,
    const std::function<bool(const RoundingOptions&)>& would_do);

/// What it returns; false where that is no mesh: for Error{unroundable}.
[[nodiscard]] bool does_round(const std::function<bool()>& attempt);

}  // namespace dupin::rounding
