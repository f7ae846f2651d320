#pragma once

#include <string>

#include "dupin/blends/end.h"

namespace dupin {

/// A port of another part, which is one of its ends, written "part.start" or "part.end".
struct PortReference {
  std::string part;
  End end = End::end;
  friend bool operator==(const PortReference&, const PortReference&) = default;
};

[[nodiscard]] std::string to_string(const PortReference& port);

}  // namespace dupin
