// Set operations on meshes: a plate with a round hole and a slot, with its exact volume.

#include <cmath>
#include <iostream>
#include <numbers>

#include "dupin/io/mesh_file.h"
#include "dupin/kernel/boolean_expression.h"
#include "dupin/kernel/placement.h"
#include "dupin/kernel/solid.h"

namespace {

// A prism over a polygon that is convex, from z = low to z = high.
dupin::Solid prism(const std::vector<dupin::Vec2>& polygon, double low, double high) {
  dupin::TriMesh mesh;
  const auto count = static_cast<std::uint32_t>(polygon.size());
  for (const double z : {low, high}) {
    for (const dupin::Vec2& corner : polygon) {
      mesh.points.emplace_back(corner.x(), corner.y(), z);
    }
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.triangles.push_back({i, next, next + count});
    mesh.triangles.push_back({i, next + count, i + count});
    if (i > 0 && next > 0) {
      mesh.triangles.push_back({0, next, i});
      mesh.triangles.push_back({count, i + count, next + count});
    }
  }
  return dupin::Solid::from(mesh);  // throws, with the faces, if it is none
}

std::vector<dupin::Vec2> circle(const dupin::Vec2& center, double radius, int corners) {
  std::vector<dupin::Vec2> polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    polygon.push_back(center + radius * dupin::Vec2(std::cos(angle), std::sin(angle)));
  }
  return polygon;
}

}  // namespace

int main() {
  const dupin::Solid plate = prism({{0, 0}, {60, 0}, {60, 40}, {0, 40}}, 0, 5);
  const dupin::Solid drill = prism(circle({20, 20}, 8, 48), -1, 6);
  const dupin::Solid slot = prism({{40, 10}, {45, 10}, {45, 30}, {40, 30}}, -1, 6);
  dupin::Placement turned;
  turned.rotate({0, 0, 1}, 90, {42.5, 20, 0});

  const dupin::Solid result =
      dupin::evaluate(dupin::Expression::parse("plate - (drill + slot)"),
                      {{"plate", plate}, {"drill", drill}, {"slot", dupin::placed(slot, turned)}});
  std::cout << "genus " << result.genus() << ", components " << result.components() << '\n';

  // Exact arithmetic: the parts sum up to the whole without any rounding.
  const dupin::Solid removed = dupin::intersect(
      std::array{plate, dupin::unite(std::array{drill, dupin::placed(slot, turned)})});
  std::cout << "removed and left are the plate: "
            << (result.exact_volume() + removed.exact_volume() == plate.exact_volume() ? "exactly"
                                                                                       : "no")
            << '\n';
  const dupin::Rounded rounded = dupin::to_mesh(result);
  dupin::write_verified("drilled.off", rounded, dupin::format_of("drilled.off"));
  std::cout << "volume " << result.volume() << '\n';
}
