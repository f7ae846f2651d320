#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/progress.h"
#include "meshing/curve_points.h"
#include "meshing/features.h"
#include "meshing/given_solid.h"

namespace dupin::meshing {

/// One region of a solid, by itself.
struct Region {
  TriMesh mesh;
  Features features;                  ///< its own curves, and one region, 0
  std::vector<std::uint32_t> curves;  ///< those of the solid, in their order
  std::vector<std::uint32_t> sides;   ///< of each that are of the region, 1 or 2
};

[[nodiscard]] std::vector<Region> regions_of(const GivenSolid& given);

/// A mesh of a region.
struct RegionMesh {
  std::vector<Vec3> points;  ///< the first are those of its curves
  std::vector<Triangle> triangles;
  double deviation = 0;  ///< proved, but for rounding
};

/// What is asked for beside the options.
struct RegionWish {
  double share = 0.8;  ///< of the distance
  std::string fault;   ///< why there is no mesh
};

/// A mesh with an edge between neighbours of the chains, within the distance both ways; none if
/// that cannot be proved, even with less and less asked for. Throws as `refine_surface`.
[[nodiscard]] std::optional<RegionMesh> mesh_region(const Region& region, const CurvePoints& balls,
                                                    const GivenSolid& given, RegionWish& wish,
                                                    const Progress& progress);

}  // namespace dupin::meshing
