#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "arrangement/arrange.h"
#include "arrangement/broad_phase.h"
#include "arrangement/constraints.h"
#include "arrangement/faces/subdivision.h"
#include "arrangement/pair_intersections.h"
#include "arrangement/triangle_intersection.h"
#include "dupin/kernel/solid.h"
#include "exact/exact_numbers.h"
#include "support/shapes.h"

namespace dupin::test {

[[nodiscard]] inline std::vector<Solid> solids_of(const std::vector<TriMesh>& meshes) {
  std::vector<Solid> solids;
  solids.reserve(meshes.size());
  for (const TriMesh& mesh : meshes) {
    solids.push_back(Solid::from(mesh));
  }
  return solids;
}

[[nodiscard]] inline std::vector<const mesh::ExactMesh*> operands_of(
    const std::vector<Solid>& solids) {
  std::vector<const mesh::ExactMesh*> operands;
  operands.reserve(solids.size());
  for (const Solid& solid : solids) {
    operands.push_back(&solid.exact());
  }
  return operands;
}

/// All stages.
[[nodiscard]] inline Solid arranged(const std::vector<Solid>& solids,
                                    const arrangement::BooleanRule& rule) {
  return Solid(
      std::make_shared<const mesh::ExactMesh>(arrangement::arrange(operands_of(solids), rule)));
}

/// Runs the first stages of an arrangement one by one, as arrange() does, so that a test can look
/// at what each hands to the next.
class Stages {
 public:
  explicit Stages(const std::vector<TriMesh>& meshes)
      : Stages(meshes, arrangement::union_rule(meshes.size())) {}
  Stages(const std::vector<TriMesh>& meshes, arrangement::BooleanRule r)
      : rule(std::move(r)),
        solids_(solids_of(meshes)),
        operands_(operands_of(solids_)),
        input(arrangement::load_operands(operands_, rule)) {}
  Stages(const Stages&) = delete;
  Stages& operator=(const Stages&) = delete;

  [[nodiscard]] std::vector<arrangement::TrianglePair> candidates() const {
    return arrangement::broad_phase(input, stage_);
  }
  [[nodiscard]] arrangement::Intersections found() const {
    return arrangement::find_intersections(input, candidates(), stage_);
  }
  /// The same, pair by pair, with points where edges inside of sheets cross.
  [[nodiscard]] std::vector<arrangement::TriangleIntersection> intersections() const {
    std::vector<arrangement::TriangleIntersection> result;
    for (const auto& [first, second] : candidates()) {
      arrangement::intersect(input, first, second, result);
    }
    return result;
  }
  [[nodiscard]] arrangement::Constraints incidences() {
    const arrangement::Intersections all = found();
    return arrangement::collect_constraints(input, all.found, all.crossed_sheets);
  }
  [[nodiscard]] arrangement::Subdivision subdivision(arrangement::Constraints constraints) {
    return arrangement::retriangulate(input, rule, std::move(constraints), stage_);
  }
  /// With triangles in place of all outlines.
  [[nodiscard]] arrangement::Subdivision triangulated(arrangement::Subdivision divided) const {
    arrangement::triangulate_outlines(
        input, [](std::uint32_t) { return true; }, divided);
    divided.outlines.clear();
    return divided;
  }

  [[nodiscard]] std::array<mpq_class, 3> place(arrangement::PointId id) const {
    const mesh::ExactPoint p = input.points.exact_value(id);
    const mpq_class w = exact::rational(p[3]);
    return {exact::rational(p[0]) / w, exact::rational(p[1]) / w, exact::rational(p[2]) / w};
  }
  /// Twice the area of the triangle, times its normal: (b - a) x (c - a).
  [[nodiscard]] std::array<mpq_class, 3> area_vector(const Triangle& corners) const {
    const auto a = place(corners[0]), b = place(corners[1]), c = place(corners[2]);
    std::array<mpq_class, 3> result;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      result[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
    }
    return result;
  }

  arrangement::BooleanRule rule;

 private:
  arrangement::UpwardRounding rounding_;
  Progress silent_;
  support::ProgressStage stage_{silent_, "test", 0, 1};
  std::vector<Solid> solids_;
  std::vector<const mesh::ExactMesh*> operands_;

 public:
  arrangement::ArrangementInput input;
};

/// Solids that meet in general and in special position, by name.
struct Meeting {
  const char* name;
  std::vector<TriMesh> solids;
};

/// Its name, to name a test after it.
[[nodiscard]] inline std::string meeting_name(const testing::TestParamInfo<Meeting>& info) {
  std::string name = info.param.name;
  std::erase(name, ',');
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

[[nodiscard]] inline TriMesh cube(double x, double y, double z, double size = 2) {
  return box({x, y, z}, {x + size, y + size, z + size});
}

/// Its edges meet planes in thirds and sevenths, which no doubles are.
[[nodiscard]] inline TriMesh slanted_tetrahedron() {
  TriMesh mesh = tetrahedron();
  const Eigen::Matrix3d shear{{7, 1, 1}, {1, 5, 2}, {2, 2, 9}};
  for (Vec3& p : mesh.points) {
    p = shear * p - Vec3(1, 1, 1);
  }
  return mesh;
}

[[nodiscard]] inline std::vector<Meeting> meetings() {
  return {
      {"corner in corner", {cube(0, 0, 0), cube(1, 1, 1)}},
      {"edge through face", {cube(0, 0, 0), cube(1, 1, -1, 4)}},
      {"a face in common", {cube(0, 0, 0), cube(2, 0, 0)}},
      {"part of a face in common", {cube(0, 0, 0), cube(2, 1, 1)}},
      {"an edge in common", {cube(0, 0, 0), cube(2, 2, 0)}},
      {"part of an edge in common", {cube(0, 0, 0), cube(2, 2, 1)}},
      {"a vertex in common", {cube(0, 0, 0), cube(2, 2, 2)}},
      {"the same", {cube(0, 0, 0), cube(0, 0, 0)}},
      {"flush inside", {cube(0, 0, 0, 4), cube(0, 1, 1)}},
      {"edges through edges", {cube(0, 0, 0), moved(frame(), {1, 1, 2})}},
      {"tubes across", {tube(1, -3, 3, 12), box({-3, -0.5, -0.25}, {3, 0.5, 0.25})}},
      {"equal tubes, displaced", {tube(1, 0, 2, 16), tube(1, 1, 3, 16)}},
      {"a tube on a face", {cube(-2, -2, -4, 4), tube(1, 0, 2, 8)}},
      {"three through one point", {cube(0, 0, 0), cube(1, 1, 1), cube(1, 0, 1)}},
      {"tetrahedra", {tetrahedron({0, 0, 0}, 3), tetrahedron({0.5, 0.25, -1}, 4)}},
  };
}

}  // namespace dupin::test
