#include "dupin/io/patches_json.h"

#include "dupin/kernel/interior_point.h"
#include "dupin/kernel/parallel.h"
#include "dupin/kernel/patch.h"
#include "json/json_value.h"

namespace dupin {
namespace {

using json::Json;
using json::json_value;

Json patch_json(const Patch& patch) {
  const double length = patch.vector_area.norm();
  return {{"name", patch.name},
          {"triangles", patch.triangles},
          {"area", patch.area},
          {"centroid", json_value(patch.centroid)},
          {"vector_area", json_value(patch.vector_area)},
          {"normal", length > 0 ? json_value(patch.vector_area / length) : Json(nullptr)}};
}

Json component_json(const std::optional<InteriorPoint>& point) {
  return {{"inside", point ? json_value(point->place) : Json(nullptr)},
          {"clearance", point ? Json(point->clearance) : Json(nullptr)}};
}

}  // namespace

std::string patches_json(const Rounded& solid, const std::string& file, const MeshHeader& header) {
  const UsualArithmetic usual;
  double area = 0;
  Json patches = Json::array(), components = Json::array();
  for (const Patch& patch : patches_of(solid.mesh())) {
    area += patch.area;
    patches.push_back(patch_json(patch));
  }
  for (const auto& point : interior_points(solid)) {
    components.push_back(component_json(point));
  }
  return json::text({{"file", file},
                     {"unit", header.unit.empty() ? Json(nullptr) : Json(header.unit)},
                     {"origin", json_value(solid.report().origin)},
                     {"area", area},
                     {"patches", patches},
                     {"components", components}});
}

}  // namespace dupin
