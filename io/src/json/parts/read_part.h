#pragma once

#include "dupin/blends/part_shape.h"
#include "json/json_document.h"

namespace dupin::json {

/// The shape that the value of a key says. Each is defined in the file of the key's name; see
/// part_reader.h.
template <KeyName key>
[[nodiscard]] PartShape read_part(const JsonNode& node);

}  // namespace dupin::json
