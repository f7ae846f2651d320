#include "dupin/io/bill_report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/parallel.h"
#include "json/json_value.h"
#include "pcf/nominal_pipe.h"

namespace dupin {
namespace json {
namespace {

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json moments_json(const std::optional<SolidMoments>& solid, const BillReport& report) {
  if (!solid) {
    return nullptr;
  }
  const Eigen::Matrix3d tensor = inertia(*solid);
  return {{"volume", solid->volume},
          {"mass", optional_json(mass(report, solid->volume))},
          {"center", json_value(solid->centroid)},
          {"inertia",
           {{tensor(0, 0), tensor(0, 1), tensor(0, 2)},
            {tensor(1, 0), tensor(1, 1), tensor(1, 2)},
            {tensor(2, 0), tensor(2, 1), tensor(2, 2)}}}};
}

Json fluid_json(const std::optional<SolidMoments>& fluid) {
  return fluid ? Json{{"volume", fluid->volume}, {"center", json_value(fluid->centroid)}}
               : Json(nullptr);
}

Json row_json(const BillRow& row, const BillReport& report) {
  const BillOrigin from = origin(report, row);
  return {{"name", row.name},
          {"kind", row.kind},
          {"component", from.component.empty() ? Json(nullptr) : Json(from.component)},
          {"component_kind", from.kind.empty() ? Json(nullptr) : Json(from.kind)},
          {"line", from.line > 0 ? Json(from.line) : Json(nullptr)},
          {"size", size_text(row.sizes, report.bill.unit)},
          {"diameters", row.sizes},
          {"wall", row.wall},
          {"length", optional_json(row.length)},
          {"bend_radius", optional_json(row.bend_radius)},
          {"bend_angle", optional_json(row.bend_angle)},
          {"area", optional_json(row.area)},
          {"outer_volume", row.outer ? Json(row.outer->volume) : Json(nullptr)},
          {"metal", moments_json(row.metal, report)},
          {"fluid", fluid_json(row.fluid)},
          {"remarks", row.remarks}};
}

Json take_off_json(const std::vector<TakeOff>& all) {
  Json result = Json::array();
  for (const TakeOff& entry : all) {
    result.push_back(
        {{"component_kind", entry.component.empty() ? Json(nullptr) : Json(entry.component)},
         {"kind", entry.kind},
         {"size", entry.size},
         {"wall", entry.wall},
         {"bend_radius", optional_json(entry.bend_radius)},
         {"bend_degrees", optional_json(entry.bend_angle)},
         {"count", entry.count},
         {"length", entry.length}});
  }
  return result;
}

}  // namespace
}  // namespace json

namespace {

// So that elbows of one radius, each rounded its own way, count together.
std::optional<double> shortened(const std::optional<double>& value, double scale) {
  return value ? std::optional(rounded(scale * *value, kPlaceDigits)) : std::nullopt;
}

std::string size_of_end(const EndSize& size, Unit unit) {
  if (size[0] != size[1]) {
    return decimal(size[0], kPlaceDigits).append(" x ").append(decimal(size[1], kPlaceDigits));
  }
  const pcf::NominalPipe* pipe = pcf::of_outside(size[0] * millimetres(unit));
  return pipe != nullptr ? std::string("DN").append(decimal(pipe->nominal))
                         : std::string("OD ").append(decimal(size[0], kPlaceDigits));
}

}  // namespace

BillOrigin origin(const BillReport& report, const BillRow& row) {
  return row.index < report.origins.size() ? report.origins[row.index] : BillOrigin();
}

std::optional<double> mass(const BillReport& report, double volume) {
  const UsualArithmetic usual;
  const double metres = millimetres(report.bill.unit) / 1000;
  return report.density ? std::optional(*report.density * volume * metres * metres * metres)
                        : std::nullopt;
}

std::string size_text(const std::vector<EndSize>& sizes, Unit unit) {
  const UsualArithmetic usual;
  std::vector<std::string> ends;
  ends.reserve(sizes.size());
  for (const EndSize& size : sizes) {
    ends.push_back(size_of_end(size, unit));
  }
  if (std::ranges::adjacent_find(ends, std::not_equal_to()) == ends.end() && !ends.empty()) {
    return ends.front();
  }
  std::string result;
  for (const std::string& end : ends) {
    result.append(result.empty() ? "" : " / ").append(end);
  }
  return result;
}

std::vector<TakeOff> take_off(const BillReport& report) {
  const UsualArithmetic usual;
  const auto key = [&](const BillRow& row) {
    return std::tuple(origin(report, row).kind, row.kind, size_text(row.sizes, report.bill.unit),
                      row.wall, shortened(row.bend_radius, 1),
                      shortened(row.bend_angle, 180 / std::numbers::pi));
  };
  std::map<decltype(key(BillRow())), TakeOff> all;
  for (const BillRow& row : report.bill.rows) {
    const auto which = key(row);
    TakeOff& entry = all[which];
    std::tie(entry.component, entry.kind, entry.size, entry.wall, entry.bend_radius,
             entry.bend_angle) = which;
    ++entry.count;
    entry.length += row.length.value_or(0);
  }
  std::vector<TakeOff> result;
  result.reserve(all.size());
  for (auto& [which, entry] : all) {
    result.push_back(std::move(entry));
  }
  return result;
}

BillTotals totals(const BillOfMaterials& bill) {
  const UsualArithmetic usual;
  BillTotals sum;
  for (const BillRow& row : bill.rows) {
    sum.area += row.area.value_or(0);
    sum.without_area += row.area ? 0 : 1;
    sum.without_volume += row.metal ? 0 : 1;
    sum.outer = sum.outer + row.outer.value_or(SolidMoments());
    sum.metal = sum.metal + row.metal.value_or(SolidMoments());
    sum.fluid = sum.fluid + row.fluid.value_or(SolidMoments());
  }
  return sum;
}

std::string to_json(const BillReport& report) {
  const UsualArithmetic usual;
  using json::Json;
  Json rows = Json::array();
  for (const BillRow& row : report.bill.rows) {
    rows.push_back(json::row_json(row, report));
  }
  const BillTotals sum = totals(report.bill);
  Json all{{"file", report.bill.source},
           {"unit", symbol(report.bill.unit)},
           {"density", json::optional_json(report.density)},
           {"parts", rows},
           {"take_off", json::take_off_json(take_off(report))},
           {"sum",
            {{"area", sum.area},
             {"outer_volume", sum.outer.volume},
             {"metal", json::moments_json(sum.metal, report)},
             {"fluid", json::fluid_json(sum.fluid)},
             {"without_area", sum.without_area},
             {"without_volume", sum.without_volume}}}};
  if (report.mesh) {
    const auto& [outer, metal, fluid] = report.mesh->volumes;
    all["mesh"] = {{"tolerance", report.mesh->tolerance},
                   {"volumes", {{"outer", outer}, {"metal", metal}, {"fluid", fluid}}}};
  }
  all.update(Json::parse(source_json(report.source)));
  return json::text(all);
}

}  // namespace dupin
