#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "json/json_document.h"

namespace dupin::json {

/// A part that an entry of a document stands for, as the document would say it alone, and the key
/// within the entry that says it: "tee/branch"; empty of a part that stands for itself.
struct Member {
  Json part;
  std::string key = {};
};

/// The parts of a tee or a valve (docs/assembly_format.md), each with a "component"; a part that is
/// neither is its own only member. Throws for keys and types that are wrong.
[[nodiscard]] std::vector<Member> members(Json part, const std::string& source,
                                          const std::string& pointer);

/// The keys that stand for several parts.
[[nodiscard]] std::span<const std::string_view> fitting_keys();

}  // namespace dupin::json
