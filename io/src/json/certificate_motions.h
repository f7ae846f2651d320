#pragma once

#include "dupin/blends/canal_fillet.h"
#include "json/json_document.h"

namespace dupin::json {

/// How the balls of a loop roll, in a certificate: an object with the key of its kind and, below
/// it, its exact numbers. The quadrics are the pipes'.
[[nodiscard]] Json motion_value(const CanalFillet& loop);

/// Throws Error{parse_failed} for anything else. Without quadrics.
[[nodiscard]] CanalFillet certificate_motion(const JsonNode& node);

}  // namespace dupin::json
