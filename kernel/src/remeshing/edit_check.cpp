#include "remeshing/edit_check.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace dupin::remeshing {
namespace {

/// Of the normals of new faces with those before: less than 60 degrees.
constexpr double kLeastCosine = 0.5;
/// The share of the distance that points which are looked at may take.
constexpr double kShare = 0.8;

Vec3 area_vector(const std::array<Vec3, 3>& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

}  // namespace

double smallest_sine(const std::array<Vec3, 3>& t) {
  const double a = (t[1] - t[0]).squaredNorm(), b = (t[2] - t[1]).squaredNorm(),
               c = (t[0] - t[2]).squaredNorm();
  const double shortest = std::min({a, b, c});
  const double others = shortest == a ? b * c : shortest == b ? a * c : a * b;
  return others > 0 ? area_vector(t).norm() / std::sqrt(others) : 0;
}

double smallest_sine(const WorkingMesh& mesh, std::uint32_t face) {
  return smallest_sine(mesh.places(mesh.face(face).corners));
}

double smallest_sine_around(const WorkingMesh& mesh, std::uint32_t point) {
  double least = 1;
  for (const std::uint32_t f : mesh.around(point)) {
    least = std::min(least, smallest_sine(mesh, f));
  }
  return least;
}

Vec3 EditCheck::place(std::uint32_t v) const {
  if (v == kAdded) {
    return edit_.added->place;
  }
  if (edit_.moved && edit_.moved->first == v) {
    return edit_.moved->second;
  }
  return shop_.mesh.place(v);
}

std::array<Vec3, 3> EditCheck::places(const Face& face) const {
  return {place(face.corners[0]), place(face.corners[1]), place(face.corners[2])};
}

double EditCheck::smallest_sine() const {
  double least = 1;
  for (const Face& face : edit_.after) {
    least = std::min(least, remeshing::smallest_sine(places(face)));
  }
  return least;
}

double EditCheck::longest_edge_ratio() const {
  double longest = 0;
  const auto size = [&](std::uint32_t v) {
    return v == kAdded ? edit_.added->size : shop_.mesh.point(v).size;
  };
  for (const Face& face : edit_.after) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = face.corners[i], b = face.corners[(i + 1) % 3];
      longest = std::max(longest, 2 * (place(a) - place(b)).norm() / (size(a) + size(b)));
    }
  }
  return longest;
}

double EditCheck::longest_edge_ratio_before() const {
  double longest = 0;
  for (const std::uint32_t f : edit_.before) {
    const Triangle& t = shop_.mesh.face(f).corners;
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      longest = std::max(longest, shop_.mesh.length(a, b) / shop_.mesh.wanted_length(a, b));
    }
  }
  return longest;
}

bool EditCheck::keeps_sides() const {
  const auto normal_of = [&](std::uint32_t region) {
    Vec3 sum = Vec3::Zero();
    for (const std::uint32_t f : edit_.before) {
      if (shop_.mesh.face(f).region == region) {
        sum += area_vector(shop_.mesh.places(shop_.mesh.face(f).corners));
      }
    }
    return Vec3(sum.normalized());
  };
  std::uint32_t region = support::kNone;
  Vec3 normal = Vec3::Zero();
  return std::ranges::all_of(edit_.after, [&](const Face& face) {
    if (face.region != region) {
      region = face.region;
      normal = normal_of(region);
    }
    const Vec3 mine = area_vector(places(face));
    return mine.dot(normal) > kLeastCosine * mine.norm();
  });
}

bool EditCheck::stays_near() const {
  const double distance = kShare * shop_.limits.distance;
  return std::ranges::all_of(edit_.after, [&](const Face& face) {
    const std::array<Vec3, 3> t = places(face);
    if (!shop_.reference.is_within((t[0] + t[1] + t[2]) / 3, face.region, distance)) {
      return false;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (face.corners[i] < face.corners[(i + 1) % 3] &&
          !shop_.reference.is_within((t[i] + t[(i + 1) % 3]) / 2, face.region, distance)) {
        return false;
      }
    }
    return true;
  });
}

}  // namespace dupin::remeshing
