#pragma once

#include <cstdint>
#include <vector>

#include "dupin/kernel/mesh.h"

/// Seeded plants as naive converters write them: every component is a closed mesh made from end
/// points of its own, which miss its neighbours' by a little.
namespace dupin::test {

struct PlantOptions {
  std::uint32_t seed = 0;
  std::size_t components = 200;
  double least_coordinate = 1e5, largest_coordinate = 2e6;  ///< of where the plant stands, mm
  double least_misfit = 1e-5, largest_misfit = 0.5;         ///< of an end point, mm
  std::uint32_t segments = 24;                              ///< of a ring
};

/// Pipes, elbows, reducers, flanges, valves and tees of nominal bores 25 to 400 mm, along axes and
/// across, at least as many as asked for and at most one more.
[[nodiscard]] std::vector<TriMesh> plant(const PlantOptions& options);

}  // namespace dupin::test
