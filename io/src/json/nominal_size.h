#pragma once

#include <optional>
#include <string_view>

#include "dupin/blends/unit.h"
#include "json/json_document.h"

namespace dupin::json {

/// The outside diameter of "DN100" or "NPS 4" by ASME B36.10M, in `unit`; none for other texts.
[[nodiscard]] std::optional<double> outside_diameter(std::string_view size, Unit unit);

/// Replaces "size" and "schedule" of a part's pipe or elbow by the "radius" that they mean and the
/// part's "wall", in `unit`. `node` is the part's, for faults: sizes and schedules that are not
/// made (the message says which are), and keys that say the same twice.
void give_section(Json& part, const JsonNode& node, Unit unit);

}  // namespace dupin::json
