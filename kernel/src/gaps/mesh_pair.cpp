#include "gaps/mesh_pair.h"

#include <string>

#include "boxes/bounds.h"
#include "dupin/kernel/coordinates.h"
#include "dupin/kernel/error.h"
#include "exact/exact_numbers.h"
#include "mesh/coincident_points.h"
#include "predicates/triangle_overlap.h"

namespace dupin::gaps {
namespace {

void validate(const TriMesh& mesh, const std::string& which) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (!mesh.points[i].allFinite()) {
      throw Error(Errc::invalid_argument,
                  "point " + std::to_string(i) + " of the " + which + " mesh is not finite");
    }
    if (!is_in_range(mesh.points[i])) {
      throw Error(Errc::invalid_argument, "point " + std::to_string(i) + " of the " + which +
                                              " mesh has " + range_fault(mesh.points[i]));
    }
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t corner : mesh.triangles[i]) {
      if (corner >= mesh.points.size()) {
        throw Error(Errc::invalid_argument, "face " + std::to_string(i) + " of the " + which +
                                                " mesh names point " + std::to_string(corner) +
                                                ", but it has only " +
                                                std::to_string(mesh.points.size()));
      }
    }
  }
}

}  // namespace

MeshPair merged(const TriMesh& a, const TriMesh& b) {
  validate(a, "first");
  validate(b, "second");
  MeshPair pair;
  pair.points = a.points;
  pair.points.insert(pair.points.end(), b.points.begin(), b.points.end());
  pair.points_of_a = static_cast<std::uint32_t>(a.points.size());
  const std::vector<std::uint32_t> representatives = mesh::coincident_representatives(pair.points);
  const auto add = [&](const TriMesh& mesh, std::uint32_t shift) {
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
      Triangle t = mesh.triangles[i];
      for (std::uint32_t& corner : t) {
        corner = representatives[corner + shift];
      }
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
        ++pair.flat_faces;
        continue;
      }
      const bool flat =
          predicates::collinear(pair.points[t[0]], pair.points[t[1]], pair.points[t[2]]);
      pair.triangles.push_back(t);
      pair.source.push_back(i);
      pair.flat.push_back(flat ? 1 : 0);
      pair.flat_faces += flat ? 1 : 0;
    }
  };
  add(a, 0);
  pair.faces_of_a = static_cast<std::uint32_t>(pair.triangles.size());
  add(b, pair.points_of_a);
  return pair;
}

FaceBoxIndex::FaceBoxIndex(const MeshPair& pair)
    : pair_(pair),
      frame_(pair.points),
      bounds_(boxes::bounds_of(pair.points)),
      tree_(boxes_of_b()) {}

std::vector<boxes::Box> FaceBoxIndex::boxes_of_b() const {
  std::vector<boxes::Box> boxes;
  for (auto face = pair_.faces_of_a; face < pair_.triangles.size(); ++face) {
    const auto [a, b, c] = pair_.corners(face);
    boxes.push_back(pair_.flat[face] != 0 ? boxes::Box::nothing()
                                          : frame_.around(frame_.map(a, b, c)));
  }
  return boxes;
}

boxes::Box FaceBoxIndex::around(std::uint32_t face, double reach) const {
  const auto [a, b, c] = pair_.corners(face);
  // One ulp makes up for the rounding of the difference; the tree's own map is monotone. What lies
  // beyond all points need not be told apart.
  const Vec3 margin = Vec3::Constant(reach);
  const Vec3 low =
      (a.cwiseMin(b).cwiseMin(c) - margin).unaryExpr(&exact::next_below).cwiseMax(bounds_.min());
  const Vec3 high =
      (a.cwiseMax(b).cwiseMax(c) + margin).unaryExpr(&exact::next_above).cwiseMin(bounds_.max());
  return frame_.around(frame_.map(low, high, high));
}

}  // namespace dupin::gaps
