#include <algorithm>

#include "dupin/io/report_json.h"
#include "dupin/kernel/parallel.h"
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
          {"smallest_angle", part.smallest_angle},
          {"least_wall", number_or_null(part.least_wall)}};
}

Json piping_json(const PcfReport& piping) {
  const auto joint_json = [](const PipingJoint& joint) -> Json {
    return {{"components", joint.components},
            {"lines", joint.lines},
            {"state", name(joint.state)},
            {"distance", joint.distance},
            {"step", joint.step},
            {"kink", joint.kink},
            {"part", joint.part.empty() ? Json(nullptr) : Json(joint.part)}};
  };
  return {{"components", piping.network.components},
          {"kinds", piping.file.kinds},
          {"skipped", piping.file.skipped},
          {"open_ends", piping.network.open_ends},
          {"snap", piping.snap},
          {"bridge", piping.bridge},
          {"largest_move", piping.network.largest_move},
          {"joints", json_list(piping.network.joints, joint_json)},
          {"bores", notes_json(piping.file.notes)},
          {"not_understood", notes_json(piping.file.unknown)},
          {"notes", notes_json(piping.network.notes)}};
}

Json graph_json(const PipeNetwork& graph) {
  return {{"nodes", graph.nodes},           {"edges", graph.edges},
          {"components", graph.components}, {"cycles", graph.cycles},
          {"blends", graph.blends},         {"junctions", graph.junctions},
          {"balls", graph.balls},           {"notes", notes_json(graph.notes)}};
}

Json exchange_json(const ExchangeReport& exchange) {
  const auto solid_json = [](const ExchangedSolid& solid) -> Json {
    return {{"name", solid.name},   {"volume", solid.volume}, {"area", solid.area},
            {"faces", solid.faces}, {"shells", solid.shells}, {"euler_number", solid.euler_number}};
  };
  return {{"file", exchange.file},
          {"format", exchange.format},
          {"solids", json_list(exchange.solids, solid_json)},
          {"faces", exchange.faces},
          {"exact_surfaces", exchange.exact_surfaces},
          {"lofted_surfaces", exchange.lofted_surfaces},
          {"error_bound", exchange.error_bound},
          {"edge_tolerance", exchange.edge_tolerance},
          {"volume", exchange.volume},
          {"expected_volume", number_or_null(exchange.expected_volume)},
          {"volume_bound", exchange.volume_bound}};
}

void put_source(Json& all, const BuildReport& report) {
  if (report.piping) {
    all["piping"] = piping_json(*report.piping);
  }
  if (report.graph) {
    all["graph"] = graph_json(*report.graph);
  }
}

}  // namespace

Json notes_json(const std::vector<SourceNote>& all) {
  return json_list(all, [](const SourceNote& note) -> Json {
    return {{"line", note.line > 0 ? Json(note.line) : Json(nullptr)},
            {"text", note.text},
            {"refused", note.is_refusal}};
  });
}

}  // namespace json

std::string to_json(const Assembly& assembly) {
  const UsualArithmetic usual;
  const auto part_json = [](const Part& part) -> json::Json {
    return {{"name", part.name}, {"kind", kind(part.shape)}};
  };
  return json::text({{"file", assembly.source},
                     {"kind", "assembly"},
                     {"unit", symbol(assembly.unit)},
                     {"tolerance", assembly.tolerance},
                     {"parts", json::json_list(assembly.parts, part_json)}});
}

namespace {

json::Json moved_sphere(std::size_t sphere, const PeVector& value) {
  return {{"sphere", sphere}, {"value", {value.m.x(), value.m.y(), value.m.z(), value.r}}};
}

}  // namespace

std::string to_json(const EditReport& report) {
  const UsualArithmetic usual;
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
  const UsualArithmetic usual;
  json::Json all = {{"unit", symbol(report.gaps.unit)},
                    {"runs", report.runs},
                    {"pieces", report.pieces},
                    {"grid", report.grid},
                    {"parts", json::json_list(report.parts, json::part_json)},
                    {"output", report.exchange ? json::exchange_json(*report.exchange)
                                               : json::json_value(report.output)},
                    {"gaps", json::json_value(report.gaps)}};
  if (report.insulation) {
    all["region"] = name(report.region);
    all["volumes"] = {{"insulation", *report.insulation}};
  }
  if (report.volumes) {
    all["region"] = name(report.region);
    all["volumes"] = {{"outer", report.volumes->outer},
                      {"metal", report.volumes->metal},
                      {"fluid", report.volumes->fluid}};
  }
  json::put_source(all, report);
  return json::text(all);
}

std::string source_json(const BuildReport& report) {
  const UsualArithmetic usual;
  json::Json all = json::Json::object();
  json::put_source(all, report);
  return json::text(all);
}

std::size_t BuildReport::findings() const {
  return gaps.findings() + output.findings() + source_findings();
}

std::size_t BuildReport::source_findings() const {
  std::size_t result = 0;
  if (piping) {
    result += piping->findings();
  }
  if (graph) {
    result += std::size_t(std::ranges::count_if(graph->notes, &SourceNote::is_refusal));
  }
  return result;
}

}  // namespace dupin
