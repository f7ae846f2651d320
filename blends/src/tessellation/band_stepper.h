#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "ringed/second_derivatives.h"

namespace dupin::tessellation {

/// Steps of the frame per band that Band::shear counts on.
constexpr std::uint32_t kFrameSteps = 16;

/// Marches along [0, 1] in the largest bands whose triangles keep to a bound.
class BandStepper {
 public:
  /// `cells` bound the second derivatives on equal parts of [0, 1]; bands may end inside of one.
  /// `around` is the angle of a segment.
  BandStepper(std::vector<ringed::BandBounds> cells, double around)
      : cells_(std::move(cells)), around_(around) {}

  /// The ends of the bands, or the first `limit` + 1 of more. `twist` is the angle that a band's
  /// far ring is turned by against the frame.
  [[nodiscard]] std::vector<double> knots(double eight_errors_allowed, double twist,
                                          std::size_t limit) const;

  /// About how many bands there would be without a twist: what each cell asks for, added up, as
  /// cheap for any number of them.
  [[nodiscard]] double expected_bands(double eight_errors_allowed) const;

  [[nodiscard]] double error_bound(const std::vector<double>& knots, double twist) const;

  /// A bound of the mean of |T'|^2, T being the spine's unit tangent.
  [[nodiscard]] double squared_turning() const;

 private:
  struct Band;

  [[nodiscard]] double count() const { return static_cast<double>(cells_.size()); }
  [[nodiscard]] std::size_t cell_of(double t) const { return std::size_t(t * count()); }
  [[nodiscard]] Band start(double twist) const;
  [[nodiscard]] double next(double t, double allowed, double twist) const;

  std::vector<ringed::BandBounds> cells_;
  double around_ = 0;
};

/// Bounds of the second derivatives on so many equal parts of [0, 1]. May throw where so long ones
/// tell nothing.
using BoundsOfCells = std::function<std::vector<ringed::BandBounds>(std::uint32_t)>;

/// Of what bounds them from one parameter to another.
[[nodiscard]] BoundsOfCells cell_by_cell(std::function<ringed::BandBounds(double, double)> bounds);

/// For estimates, which need not be sharp: over few cells, if they tell anything.
[[nodiscard]] BandStepper coarse_march(const BoundsOfCells& bounds, double around);

/// Over as many cells as bands that keep to `eight_errors_allowed` need: with the finest there
/// would be about half a percent fewer.
[[nodiscard]] BandStepper fine_march(const BoundsOfCells& bounds, double around,
                                     double eight_errors_allowed);

/// What bands have to keep to, in eighths of an error: a bound that as many of them as fit suit,
/// and one that is too little for any twist of at most half a segment.
struct BandBudget {
  double enough = 0, too_little = 0;
};

/// segments_for() gives three quarters of the bound to the bands: 8 allowed >= 4 Muu du^2. Where
/// the segments are fewer, the bands are those that suit them. A twist of at most half a segment
/// leaves (1.5 du)^2 Muu < 4 Muu du^2, so that every march arrives.
[[nodiscard]] BandBudget band_budget(double allowed, double largest_radius, double around);

/// As few bands as the budget permits, then the smallest error for that number, so that the last
/// band is not a sliver.
[[nodiscard]] std::vector<double> even_knots(const BandStepper& march, BandBudget budget,
                                             double twist);

}  // namespace dupin::tessellation
