#pragma once

#include <string>
#include <string_view>

namespace dupin {

/// The two ends of a pipe, cone, elbow or blend; each is a port.
enum class PartEnd { start, end };

[[nodiscard]] std::string_view name(PartEnd end);

/// A port of another part, written "part.start" or "part.end".
struct PortReference {
  std::string part;
  PartEnd end = PartEnd::end;
  friend bool operator==(const PortReference&, const PortReference&) = default;
};

[[nodiscard]] std::string to_string(const PortReference& port);

}  // namespace dupin
