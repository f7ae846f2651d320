#include "mesh/coincident_points.h"

#include <algorithm>
#include <bit>
#include <map>

#include "mesh/exact_mesh.h"
#include "support/hash.h"
#include "support/none.h"
#include "support/sequences.h"

namespace dupin::mesh {
namespace {

bool coincide(const ExactPoint& a, const ExactPoint& b) {
  return a[0] * b[3] == b[0] * a[3] && a[1] * b[3] == b[1] * a[3] && a[2] * b[3] == b[2] * a[3];
}

}  // namespace

std::uint64_t hash_of(const Vec3& point) {
  std::uint64_t hash = 0;
  for (const double coordinate : {point.x(), point.y(), point.z()}) {
    // Adding 0.0 turns -0.0 into 0.0.
    hash = support::mixed(hash, std::bit_cast<std::uint64_t>(coordinate + 0.0));
  }
  return hash;
}

std::vector<std::uint32_t> coincident_representatives(std::span<const Vec3> points) {
  const std::size_t slots = std::bit_ceil(2 * points.size() + 1);
  std::vector<std::uint32_t> table(slots, support::kNone);
  std::vector<std::uint32_t> first(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::size_t slot = hash_of(points[i]) & (slots - 1);
    while (table[slot] != support::kNone && points[table[slot]] != points[i]) {
      slot = (slot + 1) & (slots - 1);
    }
    if (table[slot] == support::kNone) {
      table[slot] = i;
    }
    first[i] = table[slot];
  }
  return first;
}

std::vector<std::uint32_t> coincident_representatives(const ExactMesh& mesh) {
  // Coincident points have the same nearest doubles. No implicit point is a double.
  std::vector<std::uint32_t> representatives = coincident_representatives(mesh.points);
  const std::uint32_t doubles = mesh.double_count();
  std::map<std::uint32_t, std::vector<std::uint32_t>> alike;  // of the same nearest doubles
  for (std::uint32_t i = doubles; i < representatives.size(); ++i) {
    const std::uint32_t first = representatives[i];
    if (first == i) {
      continue;
    }
    std::vector<std::uint32_t>& known = alike[first];
    if (known.empty() && first >= doubles) {
      known.push_back(first);
    }
    const auto same = std::find_if(known.begin(), known.end(), [&](std::uint32_t other) {
      return coincide(mesh.implicit[i - doubles], mesh.implicit[other - doubles]);
    });
    representatives[i] = same != known.end() ? *same : i;
    if (same == known.end()) {
      known.push_back(i);
    }
  }
  return representatives;
}

std::vector<std::uint8_t> shared_places(std::span<const std::uint32_t> representatives) {
  std::vector<std::uint8_t> is_shared(representatives.size(), 0);
  for (std::uint32_t point = 0; point < representatives.size(); ++point) {
    if (representatives[point] != point) {
      is_shared[point] = is_shared[representatives[point]] = 1;
    }
  }
  return is_shared;
}

std::vector<std::uint32_t> representatives_at_contacts(const ExactMesh& mesh) {
  if (!mesh.contacts.empty()) {
    return coincident_representatives(mesh);
  }
  return support::numbers_below(mesh.points.size());
}

}  // namespace dupin::mesh
