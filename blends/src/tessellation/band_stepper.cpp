#include "tessellation/band_stepper.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "dupin/kernel/error.h"

namespace dupin::tessellation {
namespace {

// A band turns by at most so many radians; what the bound of the frame's drift requires.
constexpr double kLargestTurn = 1;

constexpr std::uint32_t kFewestCells = 64, kCoarseCells = 128, kMostCells = 1024;

// Of the bands, what cells that are not the finest may add.
constexpr double kLoss = 1. / 200;

// Nothing if cells are too long to tell anything.
std::optional<BandStepper> march_over(std::uint32_t cells, const BoundsOfCells& bounds,
                                      double around) {
  try {
    return BandStepper(bounds(cells), around);
  } catch (const Error&) {
    return {};
  }
}

}  // namespace

// Where the surface lies between the corners of a triangle with legs dt along and du around.
//
// A linear interpolant on a right triangle with legs dt, du differs from the surface x(t, u) by at
// most (dt^2 Mtt + 2 dt du Mtu + du^2 Muu) / 8 [FMM86]. If the far corners are turned by s against
// the frame, the triangle is right-angled in w = u - (s / dt) t, where
//   X_tt = x_tt + 2 (s/dt) x_tu + (s/dt)^2 x_uu,  X_tw = x_tu + (s/dt) x_uu,  X_ww = x_uu,
// and the bound becomes the one with du + |s| for du:
//   dt^2 (Mtt + 2 |s|/dt Mtu + (s/dt)^2 Muu) + 2 dt du (Mtu + |s|/dt Muu) + du^2 Muu
//     = dt^2 Mtt + 2 dt (du + |s|) Mtu + (du + |s|)^2 Muu.
struct BandStepper::Band {
  SecondDerivativeBounds second;
  double turning = 0;  // sup |T'|
  double twist = 0;    // of the part per band, spread evenly
  double around = 0;   // du

  void include(const ringed::BandBounds& cell) {
    second.along = std::max(second.along, cell.second.along);
    second.mixed = std::max(second.mixed, cell.second.mixed);
    second.around = std::max(second.around, cell.second.around);
    turning = std::max(turning, cell.turning);
  }

  // The frame is carried in kFrameSteps minimal rotations T -> T' per band. A step that turns by at
  // most a <= 1 differs from the rotation-minimising frame by the area between the tangent's path
  // on the unit sphere and its chord; seen from the step's start, at distance d <= the path so far,
  // the path sweeps (1 - cos d) per radian of azimuth, and sin d |azimuth'| <= 1, so the area is at
  // most the integral of tan(d / 2) = -2 ln cos(a / 2) < 0.27 a^2.
  [[nodiscard]] double shear(double dt) const {
    const double turn = turning * dt;
    return twist + 0.27 * turn * turn / kFrameSteps;
  }

  [[nodiscard]] double eight_errors(double dt) const {
    const double du = around + shear(dt);
    return dt * dt * second.along + 2 * dt * du * second.mixed + du * du * second.around;
  }

  // The largest dt allowed, but for the shear, which fine bands have little of.
  [[nodiscard]] double longest(double eight_errors_allowed) const {
    const double left = eight_errors_allowed - around * around * second.around;
    const double mixed = around * second.mixed;
    return std::min(left / (mixed + std::sqrt(mixed * mixed + second.along * left)),
                    kLargestTurn / turning);
  }

  [[nodiscard]] bool allows(double dt, double eight_errors_allowed) const {
    return turning * dt <= kLargestTurn && eight_errors(dt) <= eight_errors_allowed;
  }
};

BandStepper::Band BandStepper::start(double twist) const { return {{}, 0, twist, around_}; }

std::vector<double> BandStepper::knots(double eight_errors_allowed, double twist,
                                       std::size_t limit) const {
  std::vector<double> result{0};
  while (result.back() < 1 && result.size() <= limit) {
    result.push_back(next(result.back(), eight_errors_allowed, twist));
  }
  return result;
}

double BandStepper::expected_bands(double eight_errors_allowed) const {
  double sum = 0;
  for (const auto& cell : cells_) {
    Band band = start(0);
    band.include(cell);
    sum += 1 / (count() * band.longest(eight_errors_allowed));
  }
  return std::max(sum, 1.0);
}

double BandStepper::error_bound(const std::vector<double>& knots, double twist) const {
  double largest = 0;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    Band band = start(twist);
    const auto last = std::min(cells_.size(), std::size_t(std::ceil(knots[i + 1] * count())));
    for (auto cell = cell_of(knots[i]); cell < last; ++cell) {
      band.include(cells_[cell]);
    }
    largest = std::max(largest, band.eight_errors(knots[i + 1] - knots[i]));
  }
  return largest / 8;
}

double BandStepper::squared_turning() const {
  double mean = 0;
  for (const auto& cell : cells_) {
    mean += cell.turning * cell.turning / count();
  }
  return mean;
}

double BandStepper::next(double t, double allowed, double twist) const {
  Band band = start(twist);
  double reached = t;
  for (auto cell = cell_of(t); cell < cells_.size(); ++cell) {
    band.include(cells_[cell]);
    const double cell_end = double(cell + 1) / count();
    if (band.allows(cell_end - t, allowed)) {
      reached = cell_end;
      continue;
    }
    double no = cell_end;
    for (double middle = (reached + no) / 2; reached < middle && middle < no;
         middle = (reached + no) / 2) {
      (band.allows(middle - t, allowed) ? reached : no) = middle;
    }
    break;
  }
  return reached;
}

BoundsOfCells cell_by_cell(std::function<ringed::BandBounds(double, double)> bounds) {
  return [bounds = std::move(bounds)](std::uint32_t count) {
    std::vector<ringed::BandBounds> cells;
    cells.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      cells.push_back(bounds(double(i) / count, double(i + 1) / count));
    }
    return cells;
  };
}

BandStepper coarse_march(const BoundsOfCells& bounds, double around) {
  auto coarse = march_over(kCoarseCells, bounds, around);
  return coarse ? std::move(*coarse) : BandStepper(bounds(kMostCells), around);
}

// Interval bounds on a cell exceed the suprema by what is in proportion to its length, and so do
// the bands: what half as many cells add, so many do, again.
BandStepper fine_march(const BoundsOfCells& bounds, double around, double eight_errors_allowed) {
  auto half = march_over(kFewestCells / 2, bounds, around);
  auto few = half ? march_over(kFewestCells, bounds, around) : std::nullopt;
  if (!few) {
    return {bounds(kMostCells), around};
  }
  const double bands = few->expected_bands(eight_errors_allowed);
  const double added = half->expected_bands(eight_errors_allowed) - bands;
  const double wanted = kFewestCells * added / (kLoss * bands);
  if (wanted <= kFewestCells) {
    return std::move(*few);
  }
  const bool is_less = wanted < kMostCells;  // and a number
  return {bounds(is_less ? std::bit_ceil(std::uint32_t(std::ceil(wanted))) : kMostCells), around};
}

BandBudget band_budget(double allowed, double largest_radius, double around) {
  const double bend = largest_radius * around * around;
  return {std::max(8 * allowed, 4 * bend), 2.25 * bend};
}

std::vector<double> even_knots(const BandStepper& march, BandBudget budget, double twist) {
  constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
  auto knots = march.knots(budget.enough, twist, kNoLimit);
  for (int i = 0; i < 12; ++i) {
    const double middle = (budget.enough + budget.too_little) / 2;
    auto candidate = march.knots(middle, twist, knots.size());
    if (candidate.size() == knots.size() && candidate.back() == 1) {
      knots = std::move(candidate);
      budget.enough = middle;
    } else {
      budget.too_little = middle;
    }
  }
  return knots;
}

}  // namespace dupin::tessellation
