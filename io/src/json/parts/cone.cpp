#include <array>
#include <optional>
#include <string>

#include "json/parts/part_reader.h"
#include "json/parts/part_values.h"

namespace dupin::json {
namespace {

// The sections of a cone that does not begin at a port.
struct ConeSections {
  Section start;
  double end_radius = 1;
  std::optional<double> end_across;
};

ConeSections cone_sections(const JsonNode& node) {
  if (!is_elliptic(node)) {
    const auto [start, end] = pair(node.at("radii"), "start, end");
    return {{start, std::nullopt}, end, std::nullopt};
  }
  const JsonNode both = node.at("semi_axes");
  if (both.require_array() != 2) {
    both.fail("must be the semi-axes at both ends [start, end]");
  }
  const std::string meaning = "along the axis, across it";
  const auto [radius, across] = pair(both.at(std::size_t(0)), meaning);
  const auto [end_radius, end_across] = pair(both.at(1), meaning);
  return {{radius, SectionAxes{vector(node.at("axis")), across}}, end_radius, end_across};
}

}  // namespace

template <>
struct PartReader<"cone"> {
  static PartShape read(const JsonNode& node) {
    static const std::array<KeySet, 5> sets{{{false, {"from", "to", "radii"}},
                                             {false, {"from", "direction", "length", "radii"}},
                                             {true, {"from", "length", "end_radius"}},
                                             {true, {"from", "length", "end_semi_axes"}},
                                             {true, {"from", "length", "end_semi_axes", "axis"}}}};
    const auto which = matching_key_set(node, sets);
    if (which == 2) {
      return ConeAlong{port(node.at("from")), node.at("length").number(),
                       node.at("end_radius").number()};
    }
    if (which > 2) {
      const auto [radius, across] = pair(node.at("end_semi_axes"), "along the axis, across it");
      return ConeAlong{port(node.at("from")), node.at("length").number(), radius, across,
                       which == 4 ? std::optional(vector(node.at("axis"))) : std::nullopt};
    }
    const auto [start, end_radius, end_across] = cone_sections(node);
    if (which == 0) {
      return ConeBetween{vector(node.at("from")),
                         vector(node.at("to")),
                         start.radius,
                         end_radius,
                         start.axes,
                         end_across};
    }
    return ConeAlong{origin(node, start), node.at("length").number(), end_radius, end_across};
  }
};
template PartShape read_part<"cone">(const JsonNode& node);

}  // namespace dupin::json
