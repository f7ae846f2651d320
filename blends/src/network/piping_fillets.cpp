#include "network/piping_fillets.h"

#include <algorithm>
#include <cmath>

#include "dupin/blends/build.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::network {
namespace {

// Of a branch's radius, the balls that are tried where none was asked for.
constexpr double kChosen[] = {0.25, 0.18, 0.12, 0.08, 0.05};
// Of a branch's radius, the tolerance at which a fillet is tried.
constexpr double kCoarse = 0.02;
// Of a pipe beside a fitting, what stays its own.
constexpr double kLeft = 0.1;

// A stretch with its leg.
struct Site {
  const Leg* leg = nullptr;
  std::vector<Stretch>* stretches = nullptr;
  std::size_t position = 0;
  [[nodiscard]] Stretch& stretch() const { return (*stretches)[position]; }
  [[nodiscard]] double radius() const { return std::max(stretch().radii[0], stretch().radii[1]); }
};

std::vector<std::optional<Site>> sites_of(const PipingSpans& spans,
                                          const std::vector<PlannedChain>& chains) {
  std::vector<std::optional<Site>> result(spans.spans.size());
  for (const PlannedChain& planned : chains) {
    for (std::size_t k = 0; k < planned.chain->legs.size(); ++k) {
      auto& stretches = planned.plan->stretches[k];
      for (std::size_t i = 0; i < stretches.size(); ++i) {
        if (stretches[i].span) {
          result[*stretches[i].span] = Site{&planned.chain->legs[k], &stretches, i};
        }
      }
    }
  }
  return result;
}

// The level on a's axis that is nearest to b's axis; none if they are parallel.
std::optional<double> crossing(const Leg& a, const Leg& b) {
  const double cosine = a.direction.dot(b.direction), sine_squared = 1 - cosine * cosine;
  if (!(sine_squared > 1e-3)) {
    return std::nullopt;
  }
  const Vec3 offset = b.origin - a.origin;
  return (offset.dot(a.direction) - cosine * offset.dot(b.direction)) / sine_squared;
}

// Gives the stretch the levels from `low` to `high` as far as its neighbours have them.
void widen(const Site& site, double low, double high) {
  Stretch& own = site.stretch();
  const auto may_give = [&](const Stretch& other) {
    return !other.is_solid && other.radii[0] == other.radii[1] && other.radii[0] == own.radii[0] &&
           own.radii[0] == own.radii[1];
  };
  if (site.position > 0 && low < own.levels[0]) {
    Stretch& before = (*site.stretches)[site.position - 1];
    if (may_give(before)) {
      before.levels[1] = own.levels[0] = std::max(low, before.levels[0] + kLeft * before.length());
    }
  }
  if (site.position + 1 < site.stretches->size() && high > own.levels[1]) {
    Stretch& after = (*site.stretches)[site.position + 1];
    if (may_give(after)) {
      after.levels[0] = own.levels[1] = std::min(high, after.levels[1] - kLeft * after.length());
    }
  }
}

// The room that a ball's way may take on `site`, about where `other` crosses it.
void make_room(const Site& site, const Site& other, double ball) {
  const auto center = crossing(*site.leg, *other.leg);
  if (!center) {
    return;
  }
  const double cosine = std::abs(site.leg->direction.dot(other.leg->direction)),
               sine = std::sqrt(1 - cosine * cosine);
  const double half =
      (other.radius() + 2 * ball) / sine + (site.radius() + ball) * cosine / sine + ball;
  widen(site, *center - half, *center + half);
}

Part part_of(const PipingLine& line, const Site& site) {
  Part part{site.stretch().name, shape_of(*site.leg, site.stretch())};
  part.wall = line.components[site.stretch().component].wall;
  return part;
}

// Why there is none; empty if the fitting with it alone, in a coarse mesh, is a solid with its
// walls.
std::string fault(const PipingLine& line, const PipingOptions& options, const Site& run,
                  const Site& branch, const Part& fillet) {
  Assembly assembly;
  assembly.tolerance = std::max(options.tolerance, kCoarse * branch.radius());
  assembly.wall = options.wall;
  assembly.parts = {part_of(line, run), part_of(line, branch), fillet};
  try {
    (void)build(assembly);
    return {};
  } catch (const Error& error) {
    return error.message();
  }
}

}  // namespace

std::vector<std::pair<Part, std::size_t>> fillets(const PipingLine& line,
                                                  const PipingOptions& options,
                                                  const PipingSpans& spans,
                                                  const std::vector<PlannedChain>& chains,
                                                  LineNotes& notes) {
  std::vector<std::pair<Part, std::size_t>> result;
  if (!options.fillet) {
    return result;
  }
  const auto sites = sites_of(spans, chains);
  for (const FittingBranch& fitting : spans.branches) {
    tell(options.progress, "fillet",
         double(&fitting - spans.branches.data()) / double(spans.branches.size()));
    const auto &run = sites[fitting.run], &branch = sites[fitting.branch];
    const PipingComponent& component = line.components[spans.spans[fitting.branch].component];
    if (!run || !branch) {
      continue;
    }
    const std::string name = branch->stretch().name + "-fillet";
    const bool is_chosen = *options.fillet == 0;
    if (const auto refused = options.refused.find(name); refused != options.refused.end()) {
      is_chosen ? notes.add(component, "has no fillet: " + refused->second)
                : notes.refuse(component, name + ": " + refused->second, Errc::infeasible_blend);
      continue;
    }
    std::string why;
    const std::size_t tries = is_chosen ? std::size(kChosen) : 1;
    bool fits = false;
    for (std::size_t i = 0; i < tries && !fits; ++i) {
      const double ball = is_chosen ? kChosen[i] * branch->radius() : *options.fillet;
      make_room(*run, *branch, ball);
      make_room(*branch, *run, ball);
      Part part{name, FilletBetween{{run->stretch().name, branch->stretch().name}, ball}};
      why = fault(line, options, *run, *branch, part);
      fits = why.empty();
      if (fits) {
        notes.add(component, name + " has a ball of radius " + decimal(ball, kMessageDigits));
        result.emplace_back(std::move(part), spans.spans[fitting.branch].component);
      }
    }
    if (!fits && is_chosen) {
      notes.add(component, "has no fillet: " + why);
    } else if (!fits) {
      why.insert(0, name + " does not fit: ");
      notes.refuse(component, why, Errc::infeasible_blend);
    }
  }
  return result;
}

}  // namespace dupin::network
