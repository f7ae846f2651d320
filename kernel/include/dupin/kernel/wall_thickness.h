#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin {

/// A way through the solid, from one side of a wall to the other.
struct WallPlace {
  std::uint32_t label = 0;  ///< of the side that it begins on; 0 in a mesh without labels
  Vec3 from, to;
  double thickness = 0;  ///< the distance
};

/// The thinnest wall behind each label, as far as it is found: ways that begin in the middle of
/// triangles, run inwards along their normals, and end at the next side if its normal is within
/// `most_angle`, in radians, of being the opposite one. Edges where the solid tapers off are so
/// left out. Of more than `most_ways` triangles, equally many for each label are tried. By label;
/// none where nothing was found. For looking, in doubles: nothing is proved. Expected
/// O(most_ways log n). Throws as `require_indices`, and Error{invalid_argument} for an angle that
/// is not finite.
[[nodiscard]] std::vector<WallPlace> thinnest_walls(const TriMesh& mesh,
                                                    std::size_t most_ways = 20'000,
                                                    double most_angle = 0.45);

}  // namespace dupin
