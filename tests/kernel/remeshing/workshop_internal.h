#pragma once

#include "dupin/kernel/mesh.h"
#include "remeshing/edit_check.h"

/// What steps of remeshing work on, made of a mesh.
namespace dupin::remeshing::test {

struct Bench {
  Bench(TriMesh given, const SizeLimits& limits)
      : mesh(std::move(given)),
        features(find_features(mesh, std::vector<std::uint8_t>(mesh.points.size(), 0),
                               {0.7, 2 * limits.distance})),
        reference(mesh.points, mesh.triangles, features.regions),
        field(mesh, features, limits),
        working(mesh, features),
        shop{working, features, reference, field, limits, 0.42} {
    for (std::uint32_t v = 0; v < working.point_count(); ++v) {
      working.point(v).wish = working.point(v).size = limits.largest;
    }
  }

  TriMesh mesh;
  Features features;
  ReferenceSurface reference;
  SizeField field;
  WorkingMesh working;
  Workshop shop;
};

inline double smallest_sine_of(const WorkingMesh& mesh) {
  double least = 1;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    least = mesh.alive(f) ? std::min(least, smallest_sine(mesh, f)) : least;
  }
  return least;
}

}  // namespace dupin::remeshing::test
