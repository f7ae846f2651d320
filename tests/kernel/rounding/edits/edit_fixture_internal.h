#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "rounding/edits/edited_mesh.h"
#include "support/shapes.h"

namespace dupin::rounding {

/// A closed mesh to be edited.
struct Edit : testing::Test {
  explicit Edit(const TriMesh& start = test::tube(1, 0, 1, 8)) { take(start); }
  /// Another mesh instead.
  void take(const TriMesh& other) {
    shape = other;
    labels.assign(shape.triangles.size(), 0);
    representatives.resize(shape.points.size());
    std::iota(representatives.begin(), representatives.end(), 0);
  }
  EditedMesh mesh() { return {shape.points, shape.triangles, labels, representatives}; }
  static TriMesh result(const EditedMesh& mesh) {
    TriMesh alive{{mesh.points().begin(), mesh.points().end()}};
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      if (mesh.alive(f)) {
        alive.triangles.push_back(mesh.triangle(f));
      }
    }
    return alive;
  }
  TriMesh shape;
  std::vector<std::uint32_t> labels, representatives;
  EditRule rule{FaultRule::none, 10};
};

}  // namespace dupin::rounding
