#include <algorithm>

#include "dupin/io/report_json.h"
#include "dupin/kernel/parallel.h"
#include "json/json_value.h"

namespace dupin {
namespace json {
namespace {

using json::json_value;  // not hidden by the ones below

Json json_value(const Enclosure& enclosure) {
  return {{"lower", enclosure.lower}, {"upper", enclosure.upper}};
}

Json json_value(const Deviation& deviation) {
  return {{"kind", name(deviation.kind)}, {"size", json_value(deviation.size)}};
}

/// The rationals as "numerator/denominator".
Json exact_json(const GapReport& report) {
  return {{"axial_dot", report.axial_dot.get_str()},
          {"normal_squared", report.normal_squared.get_str()},
          {"offset_squared", report.offset_squared.get_str()},
          {"distance_squared", report.distance_squared.get_str()},
          {"radius_difference", report.radius_difference.get_str()},
          {"across_difference", report.across_difference.get_str()},
          {"turn_sine_squared", report.turn_sine_squared.get_str()},
          {"slope_difference", report.slope_difference.get_str()},
          {"across_slope_difference", report.across_slope_difference.get_str()},
          {"kink_sine_squared", report.kink_sine_squared.get_str()},
          {"kink_cosine_squared", report.kink_cosine_squared.get_str()}};
}

Json json_value(const GapPair& pair, const std::vector<Port>& ports) {
  const GapReport& report = pair.report;
  Json result{{"from", ports.at(pair.first).name},
              {"to", pair.second ? Json(ports.at(*pair.second).name) : Json(nullptr)},
              {"verdict", name(report.verdict)}};
  if (pair.second) {
    result["axial"] = json_value(report.axial);
    result["offset"] = json_value(report.offset);
    result["radius"] = json_value(report.radius);
    result["across"] = json_value(report.across);
    result["turn"] = json_value(report.turn);
    result["kink"] = json_value(report.kink);
    result["deviations"] = json_list(
        report.deviations, [](const Deviation& deviation) { return json_value(deviation); });
    result["exact"] = exact_json(report);
  }
  return result;
}

Json json_value(const BoundaryLoop& loop) {
  return {{"points", loop.points},
          {"closed", loop.closed},
          {"length", json_value(loop.length)},
          {"place", json_value(loop.place)}};
}

Json json_value(const GapRegion& region) {
  return {{"faces_a", region.faces_a},
          {"faces_b", region.faces_b},
          {"pairs", region.pairs},
          {"least", json_value(region.least)},
          {"greatest", json_value(region.greatest)},
          {"least_squared", region.least_squared.get_str()},
          {"greatest_squared", region.greatest_squared.get_str()},
          {"place", json_value(region.place)}};
}

template <class Value>
Json list(const std::vector<Value>& values) {
  return json_list(values, [](const Value& value) { return json_value(value); });
}

// Not one piece, which counts as a finding.
bool are_apart(const MeshGapSummary& summary) {
  return !summary.file_b.empty() && summary.report.components > 1;
}

Json mesh_gap_json(const MeshGapSummary& summary) {
  const MeshGapReport& report = summary.report;
  return {{"file_a", summary.file_a},
          {"file_b", summary.file_b},
          {"connect", summary.connect},
          {"findings", summary.findings()},
          {"boundary_a", list(report.boundary_a)},
          {"boundary_b", list(report.boundary_b)},
          {"facing", list(report.facing)},
          {"welded_faces", report.welded_faces},
          {"flat_faces", report.flat_faces},
          {"touching", report.touching},
          {"apart", are_apart(summary)},
          {"components", report.components}};
}

}  // namespace

Json json_value(const GapSummary& summary) {
  Json result{{"file", summary.file},
              {"unit", symbol(summary.unit)},
              {"connect", summary.connect},
              {"findings", summary.findings()},
              {"pairs", json_list(summary.pairs, [&](const GapPair& pair) {
                 return json_value(pair, summary.ports);
               })}};
  if (summary.source) {
    result["source"] = {{"bores", notes_json(summary.source->bores)},
                        {"not_understood", notes_json(summary.source->unknown)},
                        {"notes", notes_json(summary.source->notes)}};
  }
  return result;
}

}  // namespace json

std::size_t GapSummary::findings() const {
  const auto left_out =
      source ? std::ranges::count_if(source->notes, &SourceNote::is_refusal) : std::ptrdiff_t{0};
  return static_cast<std::size_t>(
      left_out + std::count_if(pairs.begin(), pairs.end(), [](const GapPair& pair) {
        return pair.report.verdict != GapVerdict::welded && pair.report.verdict != GapVerdict::open;
      }));
}

std::size_t MeshGapSummary::findings() const {
  const bool apart = !file_b.empty() && report.components > 1;
  return report.boundary_a.size() + report.boundary_b.size() + report.facing.size() +
         (apart ? 1 : 0);
}

std::string to_json(const GapSummary& summary) {
  const UsualArithmetic usual;
  return json::text(json::json_value(summary));
}

std::string to_json(const MeshGapSummary& summary) {
  const UsualArithmetic usual;
  return json::text(json::mesh_gap_json(summary));
}

}  // namespace dupin
