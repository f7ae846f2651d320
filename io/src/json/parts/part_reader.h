#pragma once

#include "json/parts/read_part.h"

namespace dupin::json {

/// How a key is read. The file of the key's name specialises it and then instantiates read_part:
///
///     template <>
///     struct PartReader<"sphere"> {
///       static PartShape read(const JsonNode& node);
///     };
///     template PartShape read_part<"sphere">(const JsonNode& node);
template <KeyName key>
struct PartReader;

template <KeyName key>
PartShape read_part(const JsonNode& node) {
  return PartReader<key>::read(node);
}

}  // namespace dupin::json
