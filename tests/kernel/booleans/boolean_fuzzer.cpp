// Two solids on small grids, each the union of a few: what is in both, in one and in either adds up
// exactly. See tests/support/fuzz_target.h.

#include <algorithm>
#include <array>
#include <stdexcept>

#include <Eigen/Geometry>

#include "dupin/kernel/boolean.h"
#include "support/fuzz_bytes.h"
#include "support/fuzz_target.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using test::FuzzBytes;

// Steps of 1 make planes, edges and corners coincide; multiples of 0.1 nearly so.
Vec3 place(FuzzBytes& bytes, double step) {
  const double x = bytes.below(6), y = bytes.below(6), z = bytes.below(6);
  return step * Vec3(x, y, z);
}

Solid tetrahedron(FuzzBytes& bytes, double step) {
  TriMesh mesh;
  for (int i = 0; i < 4; ++i) {
    mesh.points.push_back(place(bytes, step));
  }
  const std::vector<Vec3>& p = mesh.points;
  const double volume = (p[1] - p[0]).cross(p[2] - p[0]).dot(p[3] - p[0]);
  if (std::abs(volume) < step * step * step / 2) {
    return {};
  }
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return Solid::from(volume > 0 ? mesh : test::reversed(mesh));
}

Solid block(FuzzBytes& bytes, double step) {
  const Vec3 low = place(bytes, step), size = place(bytes, step) + step * Vec3::Ones();
  return Solid::from(test::box(low, low + size));
}

Solid any_solid(FuzzBytes& bytes) {
  const double step = std::array{1., 1., .1, 0x1p-40}[bytes.below(4)];
  std::vector<Solid> all;
  for (std::uint32_t n = 1 + bytes.below(3); n > 0; --n) {
    all.push_back(bytes.below(2) == 0 ? tetrahedron(bytes, step) : block(bytes, step));
  }
  return unite(all);
}

void require(bool holds, const char* law) {
  if (!holds) {
    throw std::logic_error(law);
  }
}

}  // namespace
}  // namespace dupin

std::vector<std::string> dupin::test::fuzz_seeds() { return {}; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dupin;
  test::FuzzBytes bytes(data, size);
  const std::array<Solid, 2> both{any_solid(bytes), any_solid(bytes)};
  const mpq_class a = both[0].exact_volume(), b = both[1].exact_volume();
  const mpq_class common = intersect(both).exact_volume();
  require(unite(both).exact_volume() + common == a + b, "|A + B| + |A & B| = |A| + |B|");
  require(subtract(both[0], {&both[1], 1}).exact_volume() + common == a, "|A - B| + |A & B| = |A|");
  require(common >= 0 && common <= std::min(a, b), "0 <= |A & B| <= |A|, |B|");
  return 0;
}
