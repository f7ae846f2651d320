#include "json/nominal_size.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <utility>

#include "dupin/kernel/decimal.h"
#include "pcf/wall_schedule.h"

namespace dupin::json {
namespace {

const pcf::NominalPipe* nominal_pipe(std::string_view size) {
  const bool is_metric = size.starts_with("DN");
  if (!is_metric && !size.starts_with("NPS")) {
    return nullptr;
  }
  size.remove_prefix(is_metric ? 2 : 3);
  size.remove_prefix(std::min(size.find_first_not_of(' '), size.size()));
  double number = 0;
  const char* const end = size.data() + size.size();
  const auto [rest, failure] = std::from_chars(size.data(), end, number);
  if (failure != std::errc() || rest != end) {
    return nullptr;
  }
  for (const pcf::NominalPipe& pipe : pcf::nominal_pipes()) {
    if (number == (is_metric ? pipe.nominal : pipe.inches)) {
      return &pipe;
    }
  }
  return nullptr;
}

std::string all_sizes() {
  std::string names;
  for (const pcf::NominalPipe& pipe : pcf::nominal_pipes()) {
    names.append(names.empty() ? "DN" : ", DN").append(decimal(pipe.nominal));
  }
  names.append(", or NPS ");
  std::string_view separator;
  for (const pcf::NominalPipe& pipe : pcf::nominal_pipes()) {
    names.append(separator).append(decimal(pipe.inches));
    separator = ", ";
  }
  return names;
}

std::string schedule_name(const JsonNode& node) {
  return node.value().is_number() ? decimal(node.number()) : node.text();
}

void give_wall(Json& part, const JsonNode& node, const JsonNode& schedule,
               const pcf::NominalPipe& pipe, Unit unit) {
  if (node.has("wall")) {
    schedule.fail("give either a schedule or a wall");
  }
  const std::string name = schedule_name(schedule);
  const auto wall = pcf::wall_of(pipe, name);
  if (!wall) {
    const std::string made = pcf::schedule_names(pipe);
    schedule.fail("DN" + decimal(pipe.nominal) + " is not made in schedule '" + name +
                  "' of ASME B36.10M, but " + (made.empty() ? "in none that is listed" : made));
  }
  part["wall"] = *wall / millimetres(unit);
}

}  // namespace

std::optional<double> outside_diameter(std::string_view size, Unit unit) {
  const pcf::NominalPipe* const pipe = nominal_pipe(size);
  return pipe == nullptr ? std::nullopt : std::optional(pipe->outside / millimetres(unit));
}

void give_section(Json& part, const JsonNode& node, Unit unit) {
  node.require_object();
  for (const std::string key : {"pipe", "elbow"}) {
    if (!node.has(key) || !(node.at(key).has("size") || node.at(key).has("schedule"))) {
      continue;
    }
    const JsonNode shape = node.at(key), size = shape.at("size");
    const std::string name = size.text();
    const pcf::NominalPipe* const pipe = nominal_pipe(name);
    if (pipe == nullptr) {
      size.fail("'" + name + "' is no size of ASME B36.10M: " + all_sizes());
    }
    if (shape.has("radius")) {
      size.fail("give either a size or a radius");
    }
    Json own = shape.value();
    own.erase("size");
    own.erase("schedule");
    own["radius"] = pipe->outside / 2 / millimetres(unit);
    if (shape.has("schedule")) {
      give_wall(part, node, shape.at("schedule"), *pipe, unit);
    }
    part[key] = std::move(own);
  }
}

}  // namespace dupin::json
