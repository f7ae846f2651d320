#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace dupin::text {

/// Metres in one of a unit that mesh files state (MeshHeader::unit); none of what is no such unit.
[[nodiscard]] constexpr std::optional<double> metres_in(std::string_view unit) {
  constexpr std::array<std::pair<std::string_view, double>, 6> kUnits = {
      {{"mm", 0.001}, {"cm", 0.01}, {"m", 1}, {"in", 0.0254}, {"ft", 0.3048}, {"um", 1e-6}}};
  for (const auto& [symbol, metres] : kUnits) {
    if (symbol == unit) {
      return metres;
    }
  }
  return std::nullopt;
}

}  // namespace dupin::text
