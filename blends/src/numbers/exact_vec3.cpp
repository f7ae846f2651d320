#include "numbers/exact_vec3.h"

#include <cmath>

#include "dupin/kernel/error.h"

namespace dupin::numbers {

mpq_class exact(double x) {
  if (!std::isfinite(x)) {
    throw Error(Errc::invalid_argument, "the numbers of a surface must be finite");
  }
  return x;
}

ExactVec3 exact(const Vec3& v) { return {exact(v.x()), exact(v.y()), exact(v.z())}; }

ExactVec3 operator+(const ExactVec3& a, const ExactVec3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

ExactVec3 operator-(const ExactVec3& a, const ExactVec3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

ExactVec3 operator*(const mpq_class& s, const ExactVec3& v) {
  return {s * v[0], s * v[1], s * v[2]};
}

ExactVec3 cross(const ExactVec3& a, const ExactVec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

mpq_class dot(const ExactVec3& a, const ExactVec3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace dupin::numbers
