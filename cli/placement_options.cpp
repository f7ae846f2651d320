#include "placement_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include <CLI/App.hpp>

#include "exit_code.h"
#include "length.h"

namespace dupin::cli {
namespace {

constexpr std::size_t kMostSteps = 100;  // exact numbers grow with each

/// A value of an option, and how to say that it makes no sense.
struct Typed {
  const PlacementArguments::Step& step;
  std::string_view form;

  [[noreturn]] void refuse() const {
    throw UsageError(step.option + " takes " + std::string(form) + ", not '" + step.text + "'");
  }

  [[nodiscard]] std::vector<std::string> fields() const {
    std::vector<std::string> fields(1);
    for (const char c : step.text) {
      if (c == ',') {
        fields.emplace_back();
      } else {
        fields.back() += c;
      }
    }
    return fields;
  }

  /// The number that the text begins with; the rest, a unit, stays.
  double take_number(std::string_view& text) const {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value)) {
      refuse();
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
  }

  [[nodiscard]] double number(std::string_view text) const {
    const double value = take_number(text);
    if (!text.empty()) {
      refuse();
    }
    return value;
  }

  /// A length that may be negative or 0.
  [[nodiscard]] double coordinate(const std::string& text, const std::string& unit) const {
    std::string_view rest = text;
    const double value = take_number(rest);
    if (value == 0) {
      return rest.empty() ? 0 : 0 * mesh_length("1" + std::string(rest), 0, unit);
    }
    return value < 0 ? -mesh_length(text.substr(1), 0, unit) : mesh_length(text, 0, unit);
  }

  [[nodiscard]] Vec3 point(const std::vector<std::string>& fields, std::size_t first,
                           const std::string& unit) const {
    return {coordinate(fields[first], unit), coordinate(fields[first + 1], unit),
            coordinate(fields[first + 2], unit)};
  }
};

void translate(const PlacementArguments::Step& step, const std::string& unit,
               Placement& placement) {
  const Typed typed{step, "three lengths X,Y,Z such as 10mm,0,-5"};
  const std::vector<std::string> fields = typed.fields();
  if (fields.size() != 3) {
    typed.refuse();
  }
  placement.translate(typed.point(fields, 0, unit));
}

void rotate(const PlacementArguments::Step& step, const std::string& unit, Placement& placement) {
  const Typed typed{step,
                    "an axis and degrees AX,AY,AZ,DEGREES, and a point X,Y,Z of the axis if it "
                    "is not the origin, such as 0,0,1,90"};
  const std::vector<std::string> fields = typed.fields();
  if (fields.size() != 4 && fields.size() != 7) {
    typed.refuse();
  }
  const Vec3 axis(typed.number(fields[0]), typed.number(fields[1]), typed.number(fields[2]));
  if (axis == Vec3::Zero()) {
    typed.refuse();
  }
  placement.rotate(axis, typed.number(fields[3]),
                   fields.size() == 7 ? typed.point(fields, 4, unit) : Vec3::Zero());
}

void scale(const PlacementArguments::Step& step, Placement& placement) {
  const Typed typed{step, "a positive factor such as 25.4"};
  const double factor = typed.number(step.text);
  if (!(factor > 0)) {
    typed.refuse();
  }
  placement.scale(factor);
}

}  // namespace

void PlacementArguments::collect(const CLI::App& command) {
  std::map<const CLI::Option*, std::size_t> taken;
  for (const CLI::Option* option : command.parse_order()) {
    if (std::find(options.begin(), options.end(), option) != options.end()) {
      steps.push_back({option->get_name(), option->results().at(taken[option]++)});
    }
  }
}

void add_placement_options(CLI::App& command, PlacementArguments& arguments) {
  const auto add = [&](const std::string& name, std::vector<std::string>& values,
                       const std::string& form, const std::string& help) {
    arguments.options.push_back(
        command.add_option(name, values, help)->type_name(form)->allow_extra_args(false));
  };
  add("--translate", arguments.translations, "X,Y,Z", "Move by these lengths");
  add("--rotate", arguments.rotations, "AX,AY,AZ,DEGREES[,X,Y,Z]",
      "Turn about the axis through the origin, or through the point");
  add("--scale", arguments.scales, "FACTOR",
      "Change the size, about the origin. All three any number of times,\nin the order given");
}

Placement placement(const PlacementArguments& arguments, const std::string& unit) {
  if (arguments.steps.size() > kMostSteps) {
    throw UsageError("there are more than " + std::to_string(kMostSteps) +
                     " of --translate, --rotate and --scale");
  }
  Placement placement;
  for (const PlacementArguments::Step& step : arguments.steps) {
    if (step.option == "--translate") {
      translate(step, unit, placement);
    } else if (step.option == "--rotate") {
      rotate(step, unit, placement);
    } else {
      scale(step, placement);
    }
  }
  return placement;
}

}  // namespace dupin::cli
