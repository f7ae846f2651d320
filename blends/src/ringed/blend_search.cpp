#include "ringed/blend_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/golden_section.h"

namespace dupin::ringed {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kGridSize = 25;
// Sections leave 0.62 of what they divide. Inner ones are finer: outer ones see their error, and a
// flat valley shows only the square root of it. A remedy is said in four digits.
constexpr BlendSearch::Sections kToTheEnd{60, 36}, kForRemedies{30, 18};

double local_margin(const RingedSurface& surface, double t) {
  return 1 - curvature(evaluate(surface.spine, t)) * evaluate(surface.radius, t).value;
}

std::optional<double> logarithm(const std::optional<double>& speed, double scale) {
  return speed ? std::optional(std::log(*speed / scale)) : std::nullopt;
}

}  // namespace

BlendSearch::BlendSearch(BlendFamily family, double scale, std::optional<double> k,
                         std::optional<double> l, const SpeedRange& range)
    : family_(std::move(family)),
      scale_(scale),
      range_(range),
      k_(logarithm(k, scale)),
      l_(logarithm(l, scale)) {
  const numbers::Quadrature coarse = numbers::gauss_panels(1);
  for (const double at_k : grid_axis(k_)) {
    for (const double at_l : grid_axis(l_)) {
      const Trial result = trial({at_k, at_l}, coarse);
      if (admissible(result)) {
        grid_.push_back({{at_k, at_l}, result});
      }
    }
  }
}

double BlendSearch::spacing() const {
  return std::log(range_.longest / range_.shortest) / (kGridSize - 1);
}

std::vector<double> BlendSearch::grid_axis(const std::optional<double>& given) const {
  if (given) {
    return {*given};
  }
  std::vector<double> axis(kGridSize);
  for (int i = 0; i < kGridSize; ++i) {
    axis[i] = std::log(range_.shortest) + i * spacing();
  }
  return axis;
}

Trial BlendSearch::trial(const Speeds& at, const numbers::Quadrature& rule) const {
  Trial result{scale_ * std::exp(at.k), scale_ * std::exp(at.l)};
  const RingedSurface surface = family_(result.k, result.l);
  if (!(smallest_radius(surface.radius) > 0)) {
    result.margin = -kInfinity;  // the cone at an end is too steep for this speed
    return result;
  }
  std::vector<double> margins{local_margin(surface, 0)}, places{0};
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const SpinePoint point = evaluate(surface.spine, rule.nodes[i]);
    const double speed = point.first.norm(), kappa = curvature(point);
    result.energy += rule.weights[i] * kappa * kappa * speed;
    result.length += rule.weights[i] * speed;
    margins.push_back(1 - kappa * evaluate(surface.radius, rule.nodes[i]).value);
    places.push_back(rule.nodes[i]);
  }
  margins.push_back(local_margin(surface, 1));
  places.push_back(1);
  result.margin = std::min(margins.front(), margins.back());
  for (std::size_t i = 1; i + 1 < margins.size(); ++i) {
    if (margins[i] <= margins[i - 1] && margins[i] <= margins[i + 1]) {
      // 32 sections leave 1e-7 of the bracket, of which the margin feels the square.
      const auto valley = numbers::golden_section(
          [&](double t) { return local_margin(surface, t); }, places[i - 1], places[i + 1], 32);
      result.margin = std::min(result.margin, valley.value);
    }
  }
  return result;
}

bool BlendSearch::admissible(const Trial& trial) const {
  return trial.length <= range_.longest_spine * scale_ && std::isfinite(trial.energy) &&
         std::isfinite(trial.margin);
}

BlendSearch::Cost BlendSearch::cost(const Speeds& at, const CostFunction& wanted) const {
  double outside = 0;  // of the box
  for (const auto& [given, speed] : {std::pair(k_, at.k), std::pair(l_, at.l)}) {
    if (!given) {
      outside =
          std::max({outside, std::log(range_.shortest) - speed, speed - std::log(range_.longest)});
    }
  }
  if (outside > 0) {
    return {kInfinity, outside};
  }
  const Trial result = trial(at, fine_);
  return admissible(result) ? wanted(result) : Cost{kInfinity, 0};
}

// Inside along (1, 1) or the only free speed, outside along (1, -1).
BlendSearch::Speeds BlendSearch::refined(const Speeds& start, const CostFunction& wanted,
                                         const Sections& sections) const {
  const auto inner = [&](const Speeds& at) {
    return numbers::golden_section(
        [&](double s) {
          return cost({at.k + (k_ ? 0 : s), at.l + (l_ ? 0 : s)}, wanted);
        },
        -1.5 * spacing(), 1.5 * spacing(), sections.inner);
  };
  Speeds at = start;
  if (!k_ && !l_) {
    const auto outer = numbers::golden_section(
        [&](double s) {
          return inner({start.k + s, start.l - s}).value;
        },
        -1.5 * spacing(), 1.5 * spacing(), sections.outer);
    at = {start.k + outer.at, start.l - outer.at};
  }
  const double s = inner(at).at;
  return {at.k + (k_ ? 0 : s), at.l + (l_ ? 0 : s)};
}

std::optional<Trial> BlendSearch::best(const CostFunction& wanted, const Sections& sections) const {
  const auto start = std::min_element(
      grid_.begin(), grid_.end(),
      [&](const auto& a, const auto& b) { return wanted(a.second) < wanted(b.second); });
  if (start == grid_.end()) {
    return std::nullopt;
  }
  Speeds at = start->first;
  if (!k_ || !l_) {
    at = refined(at, wanted, sections);
  }
  Trial result = trial(at, fine_);
  return admissible(result) ? std::optional(result) : std::nullopt;
}

std::optional<Trial> BlendSearch::least_energy(double margin) const {
  const auto found = best(
      [margin](const Trial& trial) {
        return Cost{std::max(0.0, margin - trial.margin), trial.energy};
      },
      kToTheEnd);
  return found && found->margin >= margin ? found : std::nullopt;
}

std::optional<Trial> BlendSearch::nearest(double margin, double k, double l) const {
  const auto found = best(
      [=](const Trial& trial) {
        return Cost{std::max(0.0, margin - trial.margin),
                    std::hypot(std::log(trial.k / k), std::log(trial.l / l))};
      },
      kForRemedies);
  return found && found->margin >= margin ? found : std::nullopt;
}

std::optional<Trial> BlendSearch::largest_margin() const {
  return best([](const Trial& trial) { return Cost{-trial.margin, 0}; }, kToTheEnd);
}

}  // namespace dupin::ringed
