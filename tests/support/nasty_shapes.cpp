#include "support/nasty_shapes.h"

#include <cmath>
#include <limits>

#include "support/shapes.h"

namespace dupin::test {
namespace {

constexpr double kUlp = 0x1p-52;

TriMesh cube() { return box(Vec3(0, 0, 0), Vec3(2, 2, 2)); }

/// About the cube's middle, by coordinates that are no rounder than sines are.
TriMesh turned(TriMesh mesh, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Vec3& p : mesh.points) {
    const double x = p.x() - 1, y = p.y() - 1;
    p = Vec3(1 + c * x - s * y, 1 + s * x + c * y, p.z());
  }
  return mesh;
}

TriMesh with_cavity() {
  return joined({box(Vec3(-1, -1, -1), Vec3(3, 3, 3)),
                 reversed(box(Vec3(-0.5, -0.5, -0.5), Vec3(2.5, 2.5, 2.5)))});
}

TriMesh without_face(TriMesh mesh) {
  mesh.triangles.pop_back();
  return mesh;
}

TriMesh with_point(TriMesh mesh, const Vec3& point) {
  mesh.points.front() = point;
  return mesh;
}

std::vector<NastyShape> solids() {
  const double ulp = 2 * kUlp;
  return {
      {"cube", cube(), {}},
      {"other diagonals", cut_otherwise(cube()), {}},
      {"nested", box(Vec3(0.5, 0.5, 0.5), Vec3(1.5, 1.5, 1.5)), {}},
      {"at a face", box(Vec3(2, 0, 0), Vec3(4, 2, 2)), {}},
      {"at part of a face", box(Vec3(2, 0.5, 0.5), Vec3(4, 1.5, 3)), {}},
      {"at an edge", box(Vec3(2, 2, 0), Vec3(4, 4, 2)), {}},
      {"at a corner", box(Vec3(2, 2, 2), Vec3(4, 4, 4)), {}},
      {"an ulp aside", moved(cube(), Vec3(ulp, 0, 0)), {}},
      {"an ulp larger", box(Vec3(-ulp, -ulp, -ulp), Vec3(2 + ulp, 2 + ulp, 2 + ulp)), {}},
      {"plate of an ulp", box(Vec3(-1, -1, 2), Vec3(3, 3, 2 + ulp)), {}},
      {"plate in the middle", box(Vec3(-1, -1, 1), Vec3(3, 3, 1 + kUlp)), {}},
      {"needle", box(Vec3(1, 1, -1e6), Vec3(1 + 1e-9, 1 + 1e-9, 1e6)), {}},
      {"huge", box(Vec3(-1e30, -1e30, -1e30), Vec3(1e30, 1e30, 1e30)), {}},
      {"huge with a side at the cube", box(Vec3(2, -1e30, -1e30), Vec3(1e30, 1e30, 1e30)), {}},
      {"tiny", box(Vec3(1, 1, 1), Vec3(1 + kUlp, 1 + kUlp, 1 + kUlp)), {}},
      {"tiny at a corner", box(Vec3(-1e-50, -1e-50, -1e-50), Vec3(1e-50, 1e-50, 1e-50)), {}},
      {"far", moved(cube(), Vec3(1e15, 0, 0)), {}},
      {"turned", turned(cube(), 0.7), {}},
      {"barely turned", turned(cube(), 1e-15), {}},
      {"tube", moved(tube(1.25, 0, 2, 48), Vec3(1, 1, 0)), {}},
      {"frame", frame(), {}},
      {"with a cavity", with_cavity(), {}},
      {"two apart", joined({cube(), box(Vec3(5, 0, 0), Vec3(6, 1, 1))}), {}},
      {"sliver tetrahedron",
       {{{0, 0, 1}, {3, 0, 1}, {0, 3, 1}, {1, 1, 1 + kUlp}},
        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}},
       {}},
  };
}

std::vector<NastyShape> no_solids() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {
      {"open", without_face(cube()), Errc::not_closed},
      {"crossing itself", joined({cube(), box(Vec3(1, 1, 1), Vec3(3, 3, 3))}),
       Errc::self_intersecting},
      {"twice", joined({cube(), cube()}), Errc::invalid_argument},
      {"inside out", reversed(cube()), Errc::not_oriented},
      {"pulled through its corner", with_point(cube(), Vec3(3, 3, 3)), Errc::not_oriented},
      {"pierced", with_point(cube(), Vec3(1, 1, 5)), Errc::self_intersecting},
      {"not a number", with_point(cube(), Vec3(nan, 0, 0)), Errc::invalid_argument},
      {"out of range", with_point(cube(), Vec3(1e-300, 0, 0)), Errc::invalid_argument},
  };
}

}  // namespace

std::vector<NastyShape> nasty_shapes() {
  std::vector<NastyShape> shapes = solids();
  const std::vector<NastyShape> others = no_solids();
  shapes.insert(shapes.end(), others.begin(), others.end());
  return shapes;
}

}  // namespace dupin::test
