#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/blends/part_shape.h"
#include "json/json_document.h"

namespace dupin::json {

using Keys = std::vector<std::string_view>;

/// "a, b, c".
[[nodiscard]] std::string listed(const Keys& keys);

/// Fails unless the node is an object with no other keys. `told`: which are said to be known, some
/// of which may not go with the others that are there.
void allow_only(const JsonNode& node, const Keys& keys);
void allow_only(const JsonNode& node, const Keys& keys, const Keys& told);

/// The keys, and those that may stand for "radius": nominal sizes and diameters.
[[nodiscard]] Keys with_sizes(const Keys& keys);

[[nodiscard]] Vec3 vector(const JsonNode& node);
[[nodiscard]] PortReference port(const JsonNode& node);

/// A whole number of 32 bits; none for anything else.
[[nodiscard]] std::optional<std::uint32_t> whole_number(const JsonNode& node);

/// Two numbers, which `meaning` says the names of.
[[nodiscard]] std::array<double, 2> pair(const JsonNode& node, const std::string& meaning);

/// A cross section: "radius", or "semi_axes" and "axis".
struct Section {
  double radius = 1;
  std::optional<SectionAxes> axes;
};

/// Whether a part gives semi-axes where others have a radius.
[[nodiscard]] bool is_elliptic(const JsonNode& node);

[[nodiscard]] Section section(const JsonNode& node);

/// Where a part begins: a port, or a point with a direction and a section.
[[nodiscard]] PartStart origin(const JsonNode& node);
[[nodiscard]] PartStart origin(const JsonNode& node, const Section& section);

/// One of the sets of keys that make a part, for parts from a port or from a point. "radius" and
/// "radii" stand for "semi_axes" and "axis" too.
struct KeySet {
  bool from_port = false;
  Keys keys;
};

/// The position of the set that has exactly the node's keys. `others` are known, too, beside
/// others.
[[nodiscard]] std::size_t matching_key_set(const JsonNode& node, std::span<const KeySet> sets,
                                           const Keys& others = {});

/// "G1" or "G2".
[[nodiscard]] Continuity continuity(const JsonNode& node);
[[nodiscard]] const char* name(Continuity continuity);

/// The number, or none for "auto".
[[nodiscard]] std::optional<double> number_or_auto(const JsonNode& node);

}  // namespace dupin::json
