#include <algorithm>

#include "dupin/io/report_json.h"
#include "json/json_value.h"

namespace dupin {
namespace json {
namespace {

Json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json part_json(const PartReport& part) {
  return {{"name", part.name},
          {"kind", part.kind},
          {"construction", part.construction.empty() ? Json(nullptr) : Json(part.construction)},
          {"rejected", part.rejected},
          {"warnings", part.warnings},
          {"margin_lower", number_or_null(part.margin_lower)},
          {"margin_upper", number_or_null(part.margin_upper)},
          {"start_tangency", number_or_null(part.start_tangency)},
          {"end_tangency", number_or_null(part.end_tangency)},
          {"error_bound", part.error_bound},
          {"segments", part.segments},
          {"bands", part.bands},
          {"triangles", part.triangles},
          {"smallest_angle", part.smallest_angle}};
}

Json graph_json(const PipeNetwork& graph) {
  Json notes = Json::array();
  for (const GraphNote& note : graph.notes) {
    notes.push_back({{"line", note.line > 0 ? Json(note.line) : Json(nullptr)},
                     {"text", note.text},
                     {"refused", note.is_refusal}});
  }
  return {{"nodes", graph.nodes},   {"edges", graph.edges},   {"components", graph.components},
          {"cycles", graph.cycles}, {"blends", graph.blends}, {"junctions", graph.junctions},
          {"balls", graph.balls},   {"notes", notes}};
}

}  // namespace
}  // namespace json

std::string to_json(const Assembly& assembly) {
  json::Json parts = json::Json::array();
  for (const Part& part : assembly.parts) {
    parts.push_back({{"name", part.name}, {"kind", kind(part.shape)}});
  }
  return json::text({{"file", assembly.source},
                     {"kind", "assembly"},
                     {"unit", symbol(assembly.unit)},
                     {"tolerance", assembly.tolerance},
                     {"parts", parts}});
}

namespace {

json::Json moved_sphere(std::size_t sphere, const PeVector& value) {
  return {{"sphere", sphere}, {"value", {value.m.x(), value.m.y(), value.m.z(), value.r}}};
}

}  // namespace

std::string to_json(const EditReport& report) {
  json::Json spheres = json::Json::array(), turned = json::Json::array();
  for (const auto& [sphere, value] : report.spheres) {
    spheres.push_back(moved_sphere(sphere, value));
  }
  for (const auto& [piece, bias_sphere, remedy] : report.turned) {
    turned.push_back(
        {{"piece", piece},
         {"bias_sphere", bias_sphere},
         {"remedy", remedy ? moved_sphere(remedy->first, remedy->second) : json::Json(nullptr)}});
  }
  return json::text({{"file", report.file},
                     {"part", report.part},
                     {"pieces", report.pieces},
                     {"changed", report.changed},
                     {"spheres", spheres},
                     {"turned", turned}});
}

std::string to_json(const BuildReport& report) {
  json::Json parts = json::Json::array();
  for (const PartReport& part : report.parts) {
    parts.push_back(json::part_json(part));
  }
  json::Json all = {{"unit", symbol(report.gaps.unit)},
                    {"runs", report.runs},
                    {"pieces", report.pieces},
                    {"grid", report.grid},
                    {"parts", parts},
                    {"output", json::json_value(report.output)},
                    {"gaps", json::json_value(report.gaps)}};
  if (report.volumes) {
    all["region"] = name(report.region);
    all["volumes"] = {{"outer", report.volumes->outer},
                      {"metal", report.volumes->metal},
                      {"fluid", report.volumes->fluid}};
  }
  if (report.graph) {
    all["graph"] = json::graph_json(*report.graph);
  }
  return json::text(all);
}

std::size_t BuildReport::findings() const {
  std::size_t result = gaps.findings() + output.findings();
  if (graph) {
    result += std::size_t(std::ranges::count_if(graph->notes, &GraphNote::is_refusal));
  }
  return result;
}

}  // namespace dupin
