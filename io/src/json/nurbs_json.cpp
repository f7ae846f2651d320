#include "dupin/io/nurbs_json.h"

#include "dupin/kernel/parallel.h"
#include "json/json_value.h"

namespace dupin {
namespace {

using json::Json;

Json surface_json(const NurbsSurface& surface) {
  return {{"degree", {surface.degree_along, surface.degree_around}},
          {"knots", {surface.knots_along, surface.knots_around}},
          {"net", surface.net}};
}

}  // namespace

std::string nurbs_json(const std::vector<NamedNurbs>& parts, Unit unit) {
  const UsualArithmetic usual;
  Json values = Json::array();
  for (const auto& [part, kind, form] : parts) {
    Json surfaces = Json::array();
    for (const NurbsSurface& surface : form.surfaces) {
      surfaces.push_back(surface_json(surface));
    }
    values.push_back({{"part", part},
                      {"kind", kind},
                      {"error_bound", form.error_bound},
                      {"surfaces", surfaces}});
    for (const NurbsCurve& curve : form.trims) {
      values.back()["trims"].push_back(
          {{"degree", curve.degree}, {"knots", curve.knots}, {"net", curve.net}});
    }
  }
  return json::text({{"unit", symbol(unit)}, {"parts", values}});
}

std::string nurbs_report_json(const std::vector<NamedNurbs>& parts, const std::string& file) {
  const UsualArithmetic usual;
  Json values = Json::array();
  for (const auto& [part, kind, form] : parts) {
    values.push_back({{"part", part},
                      {"kind", kind},
                      {"error_bound", form.error_bound},
                      {"surfaces", form.surfaces.size()}});
  }
  return json::text({{"file", file}, {"parts", values}});
}

}  // namespace dupin
