#pragma once

#include <initializer_list>
#include <string>

#include "network/piping_spans.h"

namespace dupin::network {

inline PipingComponent component(PipingShape shape, std::initializer_list<Vec3> ports,
                                 const std::optional<Vec3>& center = {}, double radius = 50) {
  PipingComponent result;
  result.shape = shape;
  result.center = center;
  for (const Vec3& port : ports) {
    result.ports.push_back({port, radius, 1});
  }
  return result;
}

/// The components named "c0", "c1", ...
inline PipingLine line_of(std::vector<PipingComponent> components) {
  for (std::size_t i = 0; i < components.size(); ++i) {
    components[i].name = "c" + std::to_string(i);
    components[i].line = i + 1;
  }
  return {"a.pcf", std::move(components)};
}

inline PipingSpans spans_of(const PipingLine& line) {
  LineNotes notes("a.pcf", false);
  return spans_of(line, {}, notes);
}

}  // namespace dupin::network
