#include <algorithm>

#include "assembly/bore.h"
#include "drawing/named_patches.h"
#include "dupin/blends/drawing.h"
#include "shading/vertex_normals.h"

namespace dupin {
namespace {

constexpr double kMostErrors = 4;

// Of everything that triangles of the region may belong to.
shading::PatchTable patches_of(const Assembly& assembly, const Built& built) {
  shading::PatchTable result;
  if (built.region == Region::insulation) {
    const ResolvedAssembly whole = assembly::filled(resolve(assembly));
    drawing::add_patches(whole, assembly.patches, result);
    drawing::add_patches(
        assembly::insulated(assembly, whole, assembly::insulation_of(assembly)).resolved,
        assembly.patches, result);
    return result;
  }
  const SmoothRegion region = smooth_region(assembly, built);
  drawing::add_patches(region.whole, assembly.patches, result);
  drawing::add_patches(region.bore, assembly.patches, result);
  return result;
}

}  // namespace

CornerNormals smooth_normals(const Assembly& assembly, const Built& built, const TriMesh& mesh,
                             double moved) {
  double error = 0;
  for (const PartReport& part : built.parts) {
    error = std::max(error, part.error_bound);
  }
  // Of bores and insulation, no part's report tells.
  const double largest = kMostErrors * std::max(error, assembly.tolerance);
  return shading::vertex_normals(patches_of(assembly, built), mesh,
                                 {2 * error + moved, largest + moved, kLeastNormalCosine});
}

}  // namespace dupin
