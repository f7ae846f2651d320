#include "dupin/io/nurbs_json.h"

#include "json/json_forms.h"

namespace dupin {
namespace {

using json::Json;

Json surface_form(const NurbsSurface& surface) {
  return {{"degree", {surface.degree_along, surface.degree_around}},
          {"knots", {surface.knots_along, surface.knots_around}},
          {"net", surface.net}};
}

}  // namespace

std::string nurbs_json(const std::vector<NamedNurbs>& parts, Unit unit) {
  Json forms = Json::array();
  for (const auto& [part, kind, form] : parts) {
    Json surfaces = Json::array();
    for (const NurbsSurface& surface : form.surfaces) {
      surfaces.push_back(surface_form(surface));
    }
    forms.push_back({{"part", part},
                     {"kind", kind},
                     {"error_bound", form.error_bound},
                     {"surfaces", surfaces}});
  }
  return json::text({{"unit", symbol(unit)}, {"parts", forms}});
}

std::string nurbs_report_json(const std::vector<NamedNurbs>& parts, const std::string& file) {
  Json forms = Json::array();
  for (const auto& [part, kind, form] : parts) {
    forms.push_back({{"part", part},
                     {"kind", kind},
                     {"error_bound", form.error_bound},
                     {"surfaces", form.surfaces.size()}});
  }
  return json::text({{"file", file}, {"parts", forms}});
}

}  // namespace dupin
