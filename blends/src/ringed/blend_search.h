#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "dupin/blends/ringed_surface.h"
#include "numbers/quadrature.h"

namespace dupin::ringed {

/// The blends between two fixed ends, by their end speeds.
using BlendFamily = std::function<RingedSurface(double k, double l)>;

/// What a pair of end speeds leads to, in doubles (certificates come afterwards).
struct Trial {
  double k = 0, l = 0;
  double energy = 0;  ///< integral of kappa^2 ds
  double length = 0;
  double margin = 0;  ///< min(1 - kappa R)
};

/// What is searched, in units of the scale.
struct SpeedRange {
  double shortest = 0, longest = 0, longest_spine = 0;
};

/// Box and length keep the search from loops, which would reach any margin.
inline constexpr SpeedRange kNearSpeeds{0.05, 5, 3};
/// With the loops, for a remedy where there is none among the near ones.
inline constexpr SpeedRange kAllSpeeds{0.05, 64, std::numeric_limits<double>::infinity()};

/// The search for end speeds: a log grid over a range of the `scale`, then nested golden
/// sections about its best point. (A simplex search stalls here: the margin has an edge wherever
/// two places on the spine are equally tight.)
class BlendSearch {
 public:
  /// How finely golden sections look about the grid's best point.
  struct Sections {
    int inner = 0, outer = 0;
  };

  BlendSearch(BlendFamily family, double scale, std::optional<double> k, std::optional<double> l,
              const SpeedRange& range = kNearSpeeds);

  /// Least energy with at least this margin; none if there is none.
  [[nodiscard]] std::optional<Trial> least_energy(double margin) const;
  /// With at least this margin, that of least hypot(ln(k / wanted k), ln(l / wanted l)), nearly.
  [[nodiscard]] std::optional<Trial> nearest(double margin, double k, double l) const;
  /// Largest margin; none if nothing is within the length allowed.
  [[nodiscard]] std::optional<Trial> largest_margin() const;

 private:
  // Ordered: what is missing to be allowed, then what is to be small.
  using Cost = std::pair<double, double>;
  using CostFunction = std::function<Cost(const Trial&)>;

  // A point of the search: logarithms of k and l in units of the scale.
  struct Speeds {
    double k = 0, l = 0;
  };

  [[nodiscard]] double spacing() const;
  [[nodiscard]] std::vector<double> grid_axis(const std::optional<double>& given) const;
  [[nodiscard]] Trial trial(const Speeds& at, const numbers::Quadrature& rule) const;
  [[nodiscard]] bool admissible(const Trial& trial) const;
  [[nodiscard]] Cost cost(const Speeds& at, const CostFunction& wanted) const;
  [[nodiscard]] Speeds refined(const Speeds& start, const CostFunction& wanted,
                               const Sections& sections) const;
  [[nodiscard]] std::optional<Trial> best(const CostFunction& wanted,
                                          const Sections& sections) const;

  BlendFamily family_;
  double scale_;
  SpeedRange range_;
  std::optional<double> k_, l_;  // logarithms, if given
  numbers::Quadrature fine_ = numbers::gauss_panels(4);
  std::vector<std::pair<Speeds, Trial>> grid_;  // the admissible points
};

}  // namespace dupin::ringed
