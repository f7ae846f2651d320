#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "dupin/kernel/vec.h"
#include "json/json_document.h"

namespace dupin::json {

/// The elements of an array, each as `read` takes it.
template <class Value, class Read>
[[nodiscard]] std::vector<Value> list(const JsonNode& node, const Read& read) {
  std::vector<Value> result;
  const std::size_t size = node.require_array();
  for (std::size_t i = 0; i < size; ++i) {
    result.push_back(read(node.at(i)));
  }
  return result;
}

[[nodiscard]] inline std::vector<double> numbers(const JsonNode& node) {
  return list<double>(node, [](const JsonNode& element) { return element.number(); });
}

/// Throws where there are more or fewer.
template <std::size_t count>
[[nodiscard]] std::array<double, count> numbers(const JsonNode& node) {
  const std::vector<double> values = numbers(node);
  if (values.size() != count) {
    node.fail("must hold " + std::to_string(count) + " numbers");
  }
  std::array<double, count> result = {};
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

[[nodiscard]] inline Vec3 vec3(const JsonNode& node) {
  const auto [x, y, z] = numbers<3>(node);
  return {x, y, z};
}

}  // namespace dupin::json
