#pragma once

#include <string_view>

namespace dupin::cross_check {

enum class SetOperation {
  unite,
  intersect,
  subtract,  ///< the first operand without all others
};

[[nodiscard]] constexpr std::string_view name(SetOperation operation) {
  switch (operation) {
    case SetOperation::unite:
      return "unite";
    case SetOperation::intersect:
      return "intersect";
    case SetOperation::subtract:
      return "subtract";
  }
  return "unknown";
}

}  // namespace dupin::cross_check
