#pragma once

#include <optional>

#include "dupin/blends/blend_parts.h"
#include "json/json_document.h"

namespace dupin::json {

/// What a part is told to keep away from, by its keys "avoid" and "clearance"; none without them.
/// Meshes are read from files beside the document. Throws as the reader of meshes does.
[[nodiscard]] std::optional<Avoidance> avoidance(const JsonNode& node);

}  // namespace dupin::json
