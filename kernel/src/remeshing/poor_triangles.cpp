#include "remeshing/poor_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <Eigen/Geometry>

#include "remeshing/edit_check.h"

namespace dupin::remeshing {
namespace {

constexpr std::size_t kTold = 10;

double angle_at(const WorkingMesh& mesh, const Face& face, int corner) {
  const Vec3& at = mesh.place(face.corners[corner]);
  const Vec3 u = mesh.place(face.corners[(corner + 1) % 3]) - at,
             v = mesh.place(face.corners[(corner + 2) % 3]) - at;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace

PoorTriangles::PoorTriangles(const WorkingMesh& mesh, const Features& features, double angle,
                             double narrow)
    : mesh_(mesh), features_(features), angle_(angle), narrow_(narrow) {}

/// Whether the region that the face is in has an angle below the bound at a corner.
bool PoorTriangles::has_narrow_corner(std::uint32_t face, int corner) const {
  const std::uint32_t v = mesh_.face(face).corners[corner];
  double sum = angle_at(mesh_, mesh_.face(face), corner);
  // Around the point, one way and the other, to the next sharp edges.
  for (const bool forward : {true, false}) {
    std::uint32_t f = face;
    for (std::size_t steps = 0; steps < mesh_.around(v).size(); ++steps) {
      const Face& here = mesh_.face(f);
      const int i = here.corner(v), edge = forward ? (i + 2) % 3 : i;
      if (here.spans[edge].is_sharp()) {
        break;
      }
      const std::uint32_t other = here.corners[forward ? (i + 2) % 3 : (i + 1) % 3];
      f = (forward ? mesh_.side(v, other) : mesh_.side(other, v))->face;
      if (f == face) {
        return false;
      }
      sum += angle_at(mesh_, mesh_.face(f), mesh_.face(f).corner(v));
    }
  }
  return sum < angle_;
}

/// Whether all corners are on sharp edges that are so near each other that smaller triangles are
/// not allowed.
bool PoorTriangles::is_in_strait(std::uint32_t face) const {
  const Face& here = mesh_.face(face);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vec3 &a = mesh_.place(here.corners[i]), &b = mesh_.place(here.corners[(i + 1) % 3]),
               &c = mesh_.place(here.corners[(i + 2) % 3]);
    least = std::min(least, (b - a).cross(c - a).norm() / (b - a).norm());
  }
  return least < narrow_ && std::ranges::all_of(here.corners, [&](std::uint32_t v) {
           return mesh_.point(v).freedom != Freedom::region;
         });
}

bool PoorTriangles::is_confined(std::uint32_t face) const {
  return has_narrow_corner(face, 0) || has_narrow_corner(face, 1) || has_narrow_corner(face, 2) ||
         is_in_strait(face);
}

RemeshReport PoorTriangles::report() const {
  RemeshReport remeshed;
  remeshed.angle_bound = angle_;
  double least_sine = 1;
  remeshed.shortest_edge = std::numeric_limits<double>::infinity();
  for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
    if (!mesh_.alive(f)) {
      continue;
    }
    const Face& face = mesh_.face(f);
    for (int i = 0; i < 3; ++i) {
      const double length = mesh_.length(face.corners[i], face.corners[(i + 1) % 3]);
      remeshed.shortest_edge = std::min(remeshed.shortest_edge, length);
      remeshed.longest_edge = std::max(remeshed.longest_edge, length);
    }
    const double sine = smallest_sine(mesh_, f);
    least_sine = std::min(least_sine, sine);
    if (sine < std::sin(angle_)) {
      const auto [a, b, c] = mesh_.places(face.corners);
      const bool confined = is_confined(f);
      ++remeshed.poor_triangles;
      remeshed.confined_triangles += confined ? 1 : 0;
      remeshed.worst.push_back({(a + b + c) / 3, std::asin(sine), confined});
    }
  }
  remeshed.smallest_angle = std::asin(std::min(1.0, least_sine));
  std::ranges::stable_sort(remeshed.worst, {}, [](const PoorTriangle& poor) {
    return std::tuple(poor.is_confined, poor.angle);
  });
  remeshed.worst.resize(std::min(kTold, remeshed.worst.size()));
  return remeshed;
}

}  // namespace dupin::remeshing
