#pragma once

#include <cstddef>
#include <vector>

#include "dupin/io/report_json.h"
#include "dupin/kernel/parallel.h"
#include "dupin/kernel/vec.h"
#include "text/json_type.h"

namespace dupin::json {

/// Keeps the order in which keys are added.
using text::Json;

[[nodiscard]] Json json_value(const Vec3& point);
[[nodiscard]] Json json_value(const Report& report);
[[nodiscard]] Json json_value(const OutputReport& report);
[[nodiscard]] Json json_value(const GapSummary& summary);
[[nodiscard]] Json json_value(const PlacementReport& placement);
[[nodiscard]] Json notes_json(const std::vector<SourceNote>& all);

/// What `make` says of each, made by all threads: reports on large documents have ten thousands.
template <class Value, class Make>
[[nodiscard]] Json json_list(const std::vector<Value>& values, const Make& make) {
  Json::array_t result(values.size());
  for_each_in_parallel(values.size(), [&](std::size_t i) {
    const UsualArithmetic usual;  // a worker's is not the caller's
    result[i] = make(values[i]);
  });
  return result;
}

/// Bytes that are no UTF-8 (file names may hold them) become U+FFFD.
[[nodiscard]] std::string text(const Json& json);
/// The same without line breaks.
[[nodiscard]] std::string line_text(const Json& json);

}  // namespace dupin::json
