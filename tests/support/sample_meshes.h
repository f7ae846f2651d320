#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>

#include "dupin/kernel/mesh.h"

namespace dupin::test {

/// A tetrahedron with edge sqrt(2), volume 1/6, outward.
inline TriMesh tetrahedron() {
  return {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
          {},
          {}};
}

/// The tetrahedron with its first two faces labelled "inlet" and the others "the blend".
inline TriMesh labelled_tetrahedron() {
  TriMesh mesh = tetrahedron();
  mesh.labels = {0, 0, 1, 1};
  mesh.names = {"inlet", "the blend"};
  return mesh;
}

/// Triangles between distinct random points of every magnitude a float can hold; each point is
/// used, in order of its index.
inline TriMesh scattered_mesh(std::uint64_t seed, std::uint32_t triangles, bool binary32) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-120, 120);
  TriMesh mesh;
  const auto coordinate = [&] {
    const double value = std::ldexp(mantissa(random), exponent(random));
    return binary32 ? static_cast<double>(static_cast<float>(value)) : value;
  };
  for (std::uint32_t i = 0; i < triangles; ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      const double x = coordinate();
      const double y = coordinate();
      const double z = coordinate();
      mesh.points.emplace_back(x, y, z);
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// Equal indices, labels and names, and points equal bit for bit.
inline bool identical(const TriMesh& a, const TriMesh& b) {
  const auto same_bits = [](const Vec3& p, const Vec3& q) {
    return std::memcmp(p.data(), q.data(), 3 * sizeof(double)) == 0;
  };
  return a.triangles == b.triangles && a.labels == b.labels && a.names == b.names &&
         std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), same_bits);
}

}  // namespace dupin::test
