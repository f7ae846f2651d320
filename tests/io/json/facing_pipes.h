#pragma once

#include <string>
#include <variant>

#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/kernel/error.h"

namespace dupin::test {

/// Two pipes that face each other, and what joins them.
inline std::string facing_pipes_and(const std::string& part) {
  return R"({"units": "mm", "tolerance": 0.1, "parts": [
    {"name": "a", "pipe": {"from": [-30, 0, 0], "to": [-20, 0, 0], "radius": 1}},
    {"name": "b", "pipe": {"from": [20, 0, 0], "to": [30, 0, 0], "radius": 1}},
    {"name": "c", )" +
         part + "}]}";
}

/// Of what joins them.
inline const Chain& chain(const ResolvedAssembly& resolved) {
  return std::get<Chain>(resolved.parts[2].shape);
}

/// What is said of a document that is refused, and "none" of one that is not.
inline std::string refusal(const std::string& text, const std::string& source = {}) {
  try {
    (void)resolve(parse_assembly(text, source));
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

}  // namespace dupin::test
