#pragma once

#include <cstdint>
#include <vector>

#include "healing/polygon_soup.h"
#include "mesh/exact_mesh.h"

namespace dupin::healing {

/// What is known of the faces of the mesh.
struct KnownFaces {
  std::vector<std::uint8_t> is_of_cavity;  ///< per face
  bool were_closed = false;                ///< as they were: their orientations tell something
};

/// Looks for what faces of `given` bound that is neither in the solid nor a cavity of it. What can
/// only be of bodies (lost_cells.h) is added to `settled`, the closed surface that the solid is
/// made of: true, then it has to be made again. Throws Error{not_oriented} where there is something
/// else, or also this if it may not be added; sheets of no volume may be dropped, unless they close
/// something off.
///
/// It looks at points in each face that is not on the boundary: O(log n) for each, and the faces
/// that a ray meets.
[[nodiscard]] bool add_or_refuse_lost(const PolygonSoup& given, PolygonSoup& settled,
                                      const mesh::ExactMesh& solid, const KnownFaces& known,
                                      bool may_add);

}  // namespace dupin::healing
