#include "arrangement/crowding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "arrangement/face_crossings.h"
#include "arrangement/triangle_intersection.h"
#include "mesh/coincident_points.h"
#include "support/blocks.h"
#include "support/hash.h"
#include "support/sequences.h"

namespace dupin::arrangement {
namespace {

// A pair of triangles in so many is looked at: of few all.
std::size_t sampled(std::size_t candidates) {
  constexpr std::size_t kMost = 16, kEnough = 4096;
  return std::clamp(candidates / kEnough, std::size_t{1}, kMost);
}

// By its corners, whatever their order, the order of triangles and that of operands. Those that are
// no doubles count nothing: how well they are known may depend on it.
std::uint64_t hash_of(const ArrangementInput& input, std::uint32_t triangle) {
  std::uint64_t hash = 0;
  for (const PointId corner : input.triangles[triangle]) {
    hash += input.points.is_double(corner) ? mesh::hash_of(input.points.coordinates(corner)) : 0;
  }
  return hash;
}

// What those of the candidates have in common that are looked at.
std::vector<TriangleIntersection> sampled_intersections(const ArrangementInput& input,
                                                        std::span<const TrianglePair> candidates,
                                                        std::size_t one_in) {
  return support::collect_in_order<TriangleIntersection>(
      candidates.size(), [&](std::size_t i, std::vector<TriangleIntersection>& found) {
        const auto& [first, second] = candidates[i];
        if (support::mixed(0, hash_of(input, first) + hash_of(input, second)) % one_in == 0) {
          const UpwardRounding rounding;
          intersect(input, first, second, found);
        }
      });
}

// Of the pairs of operands that meet, the share that a sample knows to meet, by how often it has
// seen a known one do so. That follows Poisson's law, about: of those that are seen l times on
// average, a share of 1 - e^-l is seen at all, l / (1 - e^-l) times, which is 1 + l/2 + l^2/12
// where it matters.
double known_share(double times_seen) {
  constexpr double kOften = 4;  // hardly any is not seen
  return times_seen < kOften ? (std::sqrt(12 * times_seen - 3) - 3) / times_seen : 1;
}

/// Of each operand those that it meets, ascending.
using Neighbours = std::vector<std::vector<std::uint32_t>>;

Neighbours sorted(Neighbours met) {
  for (std::vector<std::uint32_t>& operands : met) {
    support::sort_unique(operands);
  }
  return met;
}

Neighbours touching_boxes(const ArrangementInput& input) {
  Neighbours result(input.operands.size());
  for (const auto& [a, b] : input.operand_pairs) {
    if (a != b) {
      result[a].push_back(b);
      result[b].push_back(a);
    }
  }
  return sorted(std::move(result));
}

// Intersections come pair by pair of operands.
Neighbours met_by_each(const ArrangementInput& input,
                       std::span<const TriangleIntersection> intersections) {
  Neighbours met(input.operands.size());
  std::uint32_t a = 0, b = 0;
  const auto belongs = [&input](std::uint32_t t, std::uint32_t operand) {
    return t >= input.first_triangle[operand] && t < input.first_triangle[operand + 1];
  };
  for (const TriangleIntersection& e : intersections) {
    if (a != b && belongs(e.first, a) && belongs(e.second, b)) {
      continue;
    }
    a = input.operand_of(e.first);
    b = input.operand_of(e.second);
    if (a != b) {
      met[a].push_back(b);
      met[b].push_back(a);
    }
  }
  return sorted(std::move(met));
}

// Calls visit(common) for each pair that meets, with how many others both meet, until it returns
// true; false if it never does. The shorter list of the two is gone through.
template <class Visit>
bool any_of_pairs(const Neighbours& met, const Visit& visit) {
  std::vector<std::uint8_t> is_met(met.size(), 0);
  for (std::uint32_t a = 0; a < met.size(); ++a) {
    for (const std::uint32_t b : met[a]) {
      is_met[b] = 1;
    }
    for (const std::uint32_t b : met[a]) {
      if (std::pair(met[b].size(), b) < std::pair(met[a].size(), a) &&
          visit(std::ranges::count_if(met[b], [&](std::uint32_t c) { return is_met[c] != 0; }))) {
        return true;
      }
    }
    for (const std::uint32_t b : met[a]) {
      is_met[b] = 0;
    }
  }
  return false;
}

// By where they are: no order of operands bears on it, unless they have the same box.
std::array<double, 6> place_of(const ArrangementInput& input, std::uint32_t operand) {
  const ArrangementInput::Bounds& box = input.bounds[operand];
  return {box.min().x(), box.min().y(), box.min().z(), box.max().x(), box.max().y(), box.max().z()};
}

}  // namespace

bool crowded(const ArrangementInput& input, std::span<const TrianglePair> candidates,
             std::size_t many) {
  if (input.operands.size() < many + 2) {
    return false;
  }
  const auto most = static_cast<std::ptrdiff_t>(many);
  // What has no more in common by boxes has no more by surfaces, on average neither.
  return any_of_pairs(touching_boxes(input), [&](auto common) { return common >= most; }) &&
         operands_in_common(input, candidates) >= static_cast<double>(many);
}

bool are_faces_crowded(const ArrangementInput& input, std::span<const TrianglePair> candidates) {
  constexpr std::size_t kLeast = 6;
  // That many have coaxial pipes of which it holds, by a quarter of the time; with half as many it
  // takes a tenth longer.
  constexpr double kCrossings = 5;
  const std::size_t count = input.operands.size();
  return count >= kLeast && count < kManyInCommon + 2 &&
         input.operand_pairs.size() >= count * (count - 2) / 2 &&  // each meets all but one, say
         crossings_per_face(input, candidates) >= kCrossings &&
         operands_in_common(input, candidates) >= static_cast<double>(count - 3);
}

double operands_in_common(const ArrangementInput& input, std::span<const TrianglePair> candidates) {
  const std::size_t one_in = sampled(candidates.size());
  const std::vector<TriangleIntersection> intersections =
      sampled_intersections(input, candidates, one_in);
  if (intersections.size() * one_in < input.triangles.size()) {
    return 0;
  }
  std::ptrdiff_t pairs = 0, in_common = 0;
  any_of_pairs(met_by_each(input, intersections), [&](auto common) {
    ++pairs;
    in_common += common;
    return false;
  });
  if (pairs == 0) {
    return 0;
  }
  const auto known = static_cast<double>(pairs);
  const double share =
      one_in == 1 ? 1 : known_share(static_cast<double>(intersections.size()) / known);
  return static_cast<double>(in_common) / (known * share * share);
}

std::vector<OperandSample> samples_around(const ArrangementInput& input, std::size_t most) {
  const Neighbours near = touching_boxes(input);
  std::vector<std::uint32_t> all = support::numbers_below(near.size());
  std::ranges::sort(all, {}, [&](std::uint32_t operand) {
    return std::pair(near[operand].size(), place_of(input, operand));
  });
  std::vector<OperandSample> samples;
  for (const std::size_t quarter : {1, 3}) {
    const std::uint32_t middle = all[all.size() * quarter / 4];
    std::vector<std::uint32_t> around = near[middle];
    if (around.size() < most) {
      return {};
    }
    std::ranges::sort(around, {}, [&](std::uint32_t o) { return place_of(input, o); });
    OperandSample sample{{middle}, static_cast<double>(around.size()) / static_cast<double>(most)};
    for (std::size_t i = 0; i < most; ++i) {
      sample.operands.push_back(around[around.size() * i / most]);
    }
    samples.push_back(std::move(sample));
  }
  return samples;
}

}  // namespace dupin::arrangement
