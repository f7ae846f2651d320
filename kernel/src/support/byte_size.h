#pragma once

#include <string>

namespace dupin::support {

/// "860 kB", "1.3 GB": two digits, rounded up, as what it says has to do; at least 1 kB.
[[nodiscard]] std::string byte_size(double bytes);

}  // namespace dupin::support
