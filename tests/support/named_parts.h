#pragma once

#include <string>

#include "dupin/blends/assembly.h"

namespace dupin::test {

inline Part pipe(const std::string& name, const Vec3& from, const Vec3& to, double radius) {
  return {name, PipeBetween{from, to, radius}};
}

inline Part fillet(const std::string& name, const std::string& a, const std::string& b,
                   double radius) {
  return {name, FilletBetween{{a, b}, radius}};
}

}  // namespace dupin::test
