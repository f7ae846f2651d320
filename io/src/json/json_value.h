#pragma once

#include <nlohmann/json.hpp>

#include "dupin/io/report_json.h"
#include "dupin/kernel/vec.h"

namespace dupin::json {

/// Keeps the order in which keys are added.
using Json = nlohmann::ordered_json;

[[nodiscard]] Json json_value(const Vec3& point);
[[nodiscard]] Json json_value(const Report& report);
[[nodiscard]] Json json_value(const OutputReport& report);
[[nodiscard]] Json json_value(const GapSummary& summary);
[[nodiscard]] Json json_value(const PlacementReport& placement);

/// Bytes that are no UTF-8 (file names may hold them) become U+FFFD.
[[nodiscard]] std::string text(const Json& json);
/// The same without line breaks.
[[nodiscard]] std::string line_text(const Json& json);

}  // namespace dupin::json
