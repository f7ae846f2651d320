// Soups of triangles on a small grid, most of them closed: repair ends in a solid or in one of the
// reasons that it promises. See tests/support/fuzz_target.h.

#include <stdexcept>
#include <utility>

#include "dupin/kernel/error.h"
#include "dupin/kernel/repair.h"
#include "support/fuzz_bytes.h"
#include "support/fuzz_target.h"

namespace dupin {
namespace {

using test::FuzzBytes;

TriMesh soup(FuzzBytes& bytes) {
  TriMesh mesh;
  const std::uint32_t points = 4 + bytes.below(12), grid = 2 + bytes.below(6);
  for (std::uint32_t i = 0; i < points; ++i) {
    const double x = bytes.below(grid), y = bytes.below(grid), z = bytes.below(grid);
    mesh.points.emplace_back(x, y, z);
  }
  while (!bytes.is_empty() && mesh.triangles.size() < 64) {
    const std::uint32_t kind = bytes.below(8);
    const auto corner = [&] { return bytes.below(points); };
    if (kind < 5) {  // closed, of either orientation, or flat
      const std::uint32_t a = corner(), b = corner(), c = corner(), d = corner();
      mesh.triangles.insert(mesh.triangles.end(), {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}});
    } else if (kind < 6 || mesh.triangles.empty()) {
      const std::uint32_t a = corner(), b = corner(), c = corner();
      mesh.triangles.push_back({a, b, c});
    } else {
      Triangle copy = mesh.triangles[bytes.below(256) % mesh.triangles.size()];
      if (kind == 7) {
        std::swap(copy[1], copy[2]);
      }
      mesh.triangles.push_back(copy);
    }
  }
  return mesh;
}

}  // namespace
}  // namespace dupin

std::vector<std::string> dupin::test::fuzz_seeds() { return {}; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace dupin;
  test::FuzzBytes bytes(data, size);
  const TriMesh mesh = soup(bytes);
  try {
    const Solid solid = repair(mesh).solid;
    if (solid.empty() ? solid.exact_volume() != 0 : solid.exact_volume() <= 0) {
      throw std::logic_error("a solid without volume");
    }
  } catch (const Error& error) {
    if (error.code() != Errc::invalid_argument && error.code() != Errc::not_closed &&
        error.code() != Errc::not_oriented) {
      throw;
    }
  }
  return 0;
}
