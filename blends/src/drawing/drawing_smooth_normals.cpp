#include <algorithm>
#include <cmath>
#include <memory>

#include "assembly/bore.h"
#include "drawing/named_patches.h"
#include "dupin/blends/drawing.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "dupin/kernel/patch.h"
#include "shading/vertex_normals.h"

namespace dupin {
namespace {

constexpr double kMostErrors = 4;

// Of everything that triangles of the region may belong to.
shading::PatchTable patches_of(const Assembly& assembly, const Built& built,
                               const std::set<std::string>& names) {
  shading::PatchTable result;
  const SmoothRegion region = assembly::smooth_region_seen(assembly, built, names);
  drawing::add_patches(region.whole, assembly.patches, result);
  drawing::add_patches(region.inside, assembly.patches, result);
  return result;
}

}  // namespace

std::function<CornerNormals(const TriMesh&, double)> smooth_normals(
    const Assembly& assembly, const Built& built, const std::set<std::string>& names) {
  const UsualArithmetic usual;
  const double error = mesh_error(built);
  // Of bores and insulation, no part's report tells.
  const double largest = kMostErrors * std::max(error, assembly.tolerance);
  const auto table =
      std::make_shared<const shading::PatchTable>(patches_of(assembly, built, names));
  return [=](const TriMesh& mesh, double moved) {
    const UsualArithmetic usual_within;
    validate(mesh);
    if (!(moved >= 0 && std::isfinite(moved))) {
      throw Error(Errc::invalid_argument,
                  "how far points were moved must be finite and not negative, not " +
                      decimal(moved, kMessageDigits));
    }
    return shading::vertex_normals(*table, mesh,
                                   {2 * error + moved, largest + moved, kLeastNormalCosine});
  };
}

CornerNormals smooth_normals(const Assembly& assembly, const Built& built, const TriMesh& mesh,
                             double moved) {
  return smooth_normals(assembly, built, assembly::names_seen(built.solid))(mesh, moved);
}

}  // namespace dupin
