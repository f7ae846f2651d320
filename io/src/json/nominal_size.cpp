#include "json/nominal_size.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <utility>

#include "dupin/blends/assembly.h"
#include "dupin/kernel/decimal.h"
#include "json/flange_size.h"
#include "pcf/wall_schedule.h"

namespace dupin::json {
namespace {

std::optional<double> number_of(std::string_view text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, failure] =
      std::from_chars(text.data(), end, number, std::chars_format::fixed);  // no DN1e2
  return failure == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

// "0.5", "1/2", "1.5", "1 1/2" and "1-1/2".
std::optional<double> inches_of(std::string_view text) {
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) {
    return number_of(text);
  }
  const auto gap = text.find_last_of(" -", slash);
  const bool is_mixed = gap != std::string_view::npos;
  const std::size_t begin = is_mixed ? gap + 1 : 0;
  const auto whole = is_mixed ? number_of(text.substr(0, gap)) : std::optional(0.0);
  const auto above = number_of(text.substr(begin, slash - begin));
  const auto below = number_of(text.substr(slash + 1));
  return whole && above && below ? std::optional(*whole + *above / *below) : std::nullopt;
}

const pcf::NominalPipe* nominal_pipe(std::string_view size) {
  const bool is_metric = size.starts_with("DN");
  if (!is_metric && !size.starts_with("NPS")) {
    return nullptr;
  }
  size.remove_prefix(is_metric ? 2 : 3);
  size.remove_prefix(std::min(size.find_first_not_of(' '), size.size()));
  const std::optional<double> number = is_metric ? number_of(size) : inches_of(size);
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

namespace {

const pcf::NominalPipe& pipe_of(const JsonNode& size) {
  const std::string name = size.text();
  const pcf::NominalPipe* const pipe = nominal_pipe(name);
  if (pipe == nullptr) {
    size.fail("'" + name + "' is no size of ASME B36.10M: " + all_sizes());
  }
  return *pipe;
}

void refuse_beside(const JsonNode& shape, std::string_view key, std::string_view other) {
  if (shape.has(other)) {
    shape.at(key).fail("give either a " + std::string(key) + " or a " + std::string(other));
  }
}

// In the range of radii, about which nobody who wrote a diameter wants to read.
double outside_of(const JsonNode& diameter) {
  constexpr double kLeast = 2e-12, kLargest = 2e12;
  const double outside = diameter.number();
  if (!(outside >= kLeast && outside <= kLargest)) {
    diameter.fail("must be a positive number between 2e-12 and 2e12, not " +
                  (outside > kLargest ? decimal_at_most(outside)
                   : outside > 0      ? decimal_at_least(outside)
                                      : decimal(outside, kMessageDigits)));
  }
  return outside;
}

// Whatever the document, or an entry around, says of where walls are: the diameter is the outer
// one.
void keep_outside(Json& thick, const JsonNode& node, const std::string& key) {
  const std::string inwards(name(WallSide::inwards));
  if (node.has("wall_side") && node.at("wall_side").value() != Json(inwards)) {
    node.at("wall_side")
        .fail("the " + key + " says the outside diameter, so that the wall is \"" + inwards +
              "\"; leave this out, or give a radius");
  }
  thick["wall_side"] = inwards;
}

// The wall goes to what is thick: the part, or a branch of a tee.
void give_radius(Json& own, const JsonNode& shape, Json& thick, const JsonNode& node, Unit unit) {
  if (shape.has("size") || shape.has("schedule")) {
    const pcf::NominalPipe& pipe = pipe_of(shape.at("size"));
    refuse_beside(shape, "size", "radius");
    refuse_beside(shape, "size", "outside_diameter");
    own["radius"] = pipe.outside / 2 / millimetres(unit);
    if (shape.has("schedule")) {
      give_wall(thick, node, shape.at("schedule"), pipe, unit);
    }
  } else if (shape.has("outside_diameter") || shape.has("inside_diameter")) {
    const double outside = outside_of(shape.at("outside_diameter"));
    refuse_beside(shape, "outside_diameter", "radius");
    own["radius"] = outside / 2;
    if (shape.has("inside_diameter")) {
      const JsonNode inside = shape.at("inside_diameter");
      if (node.has("wall")) {
        inside.fail("give either an inside_diameter or a wall");
      }
      if (!(inside.number() > 0 && inside.number() < outside)) {
        inside.fail("must be positive and less than the outside_diameter");
      }
      thick["wall"] = (outside - inside.number()) / 2;
    }
  }
  for (const char* key : {"size", "outside_diameter"}) {
    if (own.contains(key)) {
      keep_outside(thick, node, key);
    }
  }
  for (const char* key : {"size", "schedule", "outside_diameter", "inside_diameter"}) {
    own.erase(key);
  }
}

void give_flange(Json& own, const JsonNode& shape, Unit unit) {
  if (!shape.has("size") && !shape.has("class")) {
    return;
  }
  const pcf::NominalPipe& pipe = pipe_of(shape.at("size"));
  const JsonNode pressure = shape.at("class");
  const std::string name =
      pressure.value().is_number() ? decimal(pressure.number()) : pressure.text();
  const auto flange = flange_of(pipe.inches, name);
  if (!flange) {
    pressure.fail("there is no flange of NPS " + decimal(pipe.inches) + " in class " + name +
                  " here, but of NPS 1/2 to 24 in classes 150 and 300 of ASME B16.5");
  }
  refuse_beside(shape, "size", "radius");
  refuse_beside(shape, "size", "thickness");
  own.erase("size");
  own.erase("class");
  own["radius"] = flange->outside / 2 / millimetres(unit);
  own["thickness"] = flange->thickness / millimetres(unit);
}

}  // namespace

void give_section(Json& part, const JsonNode& node, Unit unit) {
  node.require_object();
  for (const std::string key : {"pipe", "elbow", "head", "tee", "valve"}) {
    if (node.has(key) && node.at(key).value().is_object()) {
      Json own = node.at(key).value();
      give_radius(own, node.at(key), part, node, unit);
      if (key == "tee" && own.contains("branch") && own["branch"].is_object()) {
        const JsonNode branch = node.at(key).at("branch");
        give_radius(own["branch"], branch, own["branch"], branch, unit);
      }
      part[key] = std::move(own);
    }
  }
  if (node.has("flange") && node.at("flange").value().is_object()) {
    Json own = node.at("flange").value();
    give_flange(own, node.at("flange"), unit);
    part["flange"] = std::move(own);
  }
}

}  // namespace dupin::json
