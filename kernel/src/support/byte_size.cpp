#include "support/byte_size.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dupin/kernel/decimal.h"

namespace dupin::support {

std::string byte_size(double bytes) {
  constexpr std::array<std::pair<double, const char*>, 4> kUnits{
      {{1e12, " TB"}, {1e9, " GB"}, {1e6, " MB"}, {1e3, " kB"}}};
  const double size = std::max(bytes, 1e3);
  const double digit = std::pow(10, std::floor(std::log10(size)) - 1);
  const double rounded = std::ceil(size / digit) * digit;
  const auto* const unit =
      std::ranges::find_if(kUnits, [&](const auto& each) { return rounded >= each.first; });
  return decimal(rounded / unit->first, 3) + unit->second;
}

}  // namespace dupin::support
