#pragma once

#include <cstdint>
#include <string_view>

namespace dupin {

enum class SetOperation : std::uint8_t {
  unite,
  intersect,
  subtract,  ///< the first operand without all others
};

[[nodiscard]] std::string_view name(SetOperation operation);

}  // namespace dupin
