#include "support/text.h"

#include <array>
#include <charconv>

namespace dupin::support {

std::string text(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return {digits.data(), end.ptr};
}

std::string text(const Vec3& point) {
  return "(" + text(point.x()) + ", " + text(point.y()) + ", " + text(point.z()) + ")";
}

}  // namespace dupin::support
