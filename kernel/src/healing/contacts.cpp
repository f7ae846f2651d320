#include "dupin/kernel/contacts.h"

#include <cmath>
#include <string>

#include <Eigen/Geometry>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"

namespace dupin {
namespace {

double largest_coordinate(const Solid& solid) {
  double largest = 0;
  for (const Vec3& point : solid.nearest_points()) {
    largest = std::max(largest, point.cwiseAbs().maxCoeff());
  }
  return largest;
}

// A square prism around an edge with a pyramid at each end, or an octahedron around a vertex; its
// corners are `size` away from the contact, but for rounding.
TriMesh around(const Contact& contact, double size) {
  Vec3 axis = contact.to - contact.from;
  axis = axis.isZero(0) ? Vec3::UnitZ() : axis.normalized();
  const Vec3 u = axis.unitOrthogonal(), w = axis.cross(u);
  TriMesh mesh;
  mesh.points = {contact.from - size * axis};
  const bool is_vertex = contact.from == contact.to;
  const std::vector<Vec3> stations =
      is_vertex ? std::vector{contact.from} : std::vector{contact.from, contact.to};
  for (const Vec3& station : stations) {
    for (const Vec3& side : {u, w, Vec3(-u), Vec3(-w)}) {
      mesh.points.push_back(station + size * side);
    }
  }
  mesh.points.push_back(contact.to + size * axis);
  const auto tip = static_cast<std::uint32_t>(mesh.points.size() - 1), last = tip - 4;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t a = 1 + i, b = 1 + (i + 1) % 4;
    mesh.triangles.push_back({0, b, a});
    if (!is_vertex) {
      mesh.triangles.push_back({a, b, b + 4});
      mesh.triangles.push_back({a, b + 4, a + 4});
    }
    mesh.triangles.push_back({tip, last + i, last + (i + 1) % 4});
  }
  mesh.labels.assign(mesh.triangles.size(), 0);
  mesh.names = {"contact"};
  return mesh;
}

using Operation = Solid (*)(const Solid& solid, std::span<const Solid> tools,
                            const BooleanOptions& options);

Solid unite_with(const Solid& solid, std::span<const Solid> tools, const BooleanOptions& options) {
  std::vector<Solid> all = {solid};
  all.insert(all.end(), tools.begin(), tools.end());
  return unite(all, options);
}

Settled settle(const Solid& solid, double size, const Progress& progress, Operation operation) {
  if (!(size > 0 && std::isfinite(size))) {
    throw Error(Errc::invalid_argument,
                "contacts are settled within a length that is positive and finite, not " +
                    decimal(size, kMessageDigits));
  }
  if (solid.contacts().empty()) {
    return {solid, {}};
  }
  // Far above the error of the tools' corners, a few units in the last place of a coordinate.
  const double smallest = 0x1p-32 * largest_coordinate(solid);
  if (size <= smallest) {
    throw Error(Errc::contact, "contacts cannot be settled within " +
                                   decimal(size, kMessageDigits) +
                                   "; with coordinates this large, the length must be above " +
                                   decimal_at_most(smallest));
  }
  // New contacts arise only where tools happen to end on something: then smaller ones do not.
  constexpr int kAttempts = 4;
  constexpr double kShrink = 0.75, kMargin = 1 - 0x1p-12;
  double within = size * kMargin;
  for (int attempt = 0; attempt < kAttempts; ++attempt, within *= kShrink) {
    std::vector<Solid> tools;
    for (const Contact& contact : solid.contacts()) {
      tools.push_back(Solid::from(around(contact, within)));
    }
    Solid settled = operation(solid, tools, {.progress = progress});
    if (settled.contacts().empty()) {
      return {std::move(settled), solid.contacts()};
    }
  }
  throw Error(Errc::contact, "the contacts cannot be settled within " +
                                 decimal(size, kMessageDigits) + ", the first at " +
                                 decimal(solid.contacts().front().from) +
                                 "; another length may do");
}

}  // namespace

Settled separate(const Solid& solid, double distance, const Progress& progress) {
  const UsualArithmetic usual;
  return settle(solid, distance, progress, subtract);
}

Settled bridge(const Solid& solid, double radius, const Progress& progress) {
  const UsualArithmetic usual;
  return settle(solid, radius, progress, unite_with);
}

}  // namespace dupin
