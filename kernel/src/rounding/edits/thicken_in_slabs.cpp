#include "rounding/edits/thicken_in_slabs.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "boxes/bounds.h"
#include "rounding/edits/edit_strategy.h"
#include "rounding/edits/mesh_part.h"
#include "support/blocks.h"
#include "support/none.h"
#include "support/sequences.h"

namespace dupin::rounding {
namespace {

/// So many triangles are worth a slab of their own; at most so many slabs, since what is at their
/// borders is left to one thread.
constexpr std::size_t kTriangles = 1 << 14, kMostSlabs = 8;

/// Points by the slab that they are in: strictly between two of the planes, which are across `axis`
/// and have as many points between them.
class Division {
 public:
  Division(const BrokenMesh& mesh, std::size_t count) {
    boxes::bounds_of(mesh.doubles).sizes().maxCoeff(&axis_);
    std::vector<double> heights;
    heights.reserve(mesh.doubles.size());
    for (const Vec3& point : mesh.doubles) {
      heights.push_back(point[axis_]);
    }
    for (std::size_t i = 1; i < count; ++i) {
      const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(i * heights.size() / count);
      std::nth_element(heights.begin(), middle, heights.end());
      planes_.push_back(*middle);
    }
    std::erase_if(planes_, [&, last = -std::numeric_limits<double>::infinity()](double at) mutable {
      return !(std::exchange(last, at) < at);
    });
  }

  [[nodiscard]] std::size_t size() const { return planes_.size() + 1; }
  /// Of a point; none on a plane.
  [[nodiscard]] std::uint32_t slab_of(const Vec3& point) const {
    const auto above = std::ranges::lower_bound(planes_, point[axis_]);
    const bool is_on = above != planes_.end() && *above == point[axis_];
    return is_on ? support::kNone : static_cast<std::uint32_t>(above - planes_.begin());
  }
  /// Whether a triangle has some part in the slab or its borders.
  [[nodiscard]] bool reaches(const BrokenMesh& mesh, const Triangle& t, std::size_t slab) const {
    const double a = mesh.doubles[t[0]][axis_], b = mesh.doubles[t[1]][axis_],
                 c = mesh.doubles[t[2]][axis_];
    return (slab == 0 || std::max({a, b, c}) >= planes_[slab - 1]) &&
           (slab == planes_.size() || std::min({a, b, c}) <= planes_[slab]);
  }

 private:
  Eigen::Index axis_ = 0;
  std::vector<double> planes_;
};

/// The triangles that reach into a slab, of which those within are edited.
class Slab {
 public:
  Slab(const BrokenMesh& whole, const Division& division, std::span<const std::uint32_t> slab_of,
       std::uint32_t number)
      : part_(whole, faces_that_reach(whole, division, number),
              [&](std::uint32_t point) { return slab_of[point] == number; }),
        mesh_(unedited(part_.view())) {}

  void thicken(double reach) {
    rounding::thicken(mesh_, reach, support::numbers_below(part_.faces().size()));
  }
  void put_into(EditedMesh& whole) const { whole.take_over(mesh_, part_.faces(), part_.points()); }

 private:
  static std::vector<std::uint32_t> faces_that_reach(const BrokenMesh& whole,
                                                     const Division& division,
                                                     std::uint32_t number) {
    return support::indices_where(whole.triangles.size(), [&](std::uint32_t face) {
      return division.reaches(whole, whole.triangles[face], number);
    });
  }

  MeshPart part_;
  EditedMesh mesh_;  // refers to it
};

/// The faces at points around which some face is in no slab.
std::vector<std::uint32_t> faces_at_borders(const EditedMesh& mesh, const BrokenMesh& original,
                                            std::span<const std::uint32_t> slab_of) {
  std::vector<std::uint8_t> is_at_border(slab_of.size(), 0);
  for (const Triangle& t : original.triangles) {
    const std::uint32_t slab = slab_of[t[0]];
    if (slab == support::kNone || slab_of[t[1]] != slab || slab_of[t[2]] != slab) {
      for (const std::uint32_t corner : t) {
        is_at_border[corner] = 1;
      }
    }
  }
  return support::indices_where(mesh.face_count(), [&](std::uint32_t face) {
    const auto& [a, b, c] = mesh.triangle(face);
    return mesh.alive(face) && (is_at_border[a] | is_at_border[b] | is_at_border[c]) != 0;
  });
}

}  // namespace

bool is_full_of_needles(const mesh::MeshView& rounded) {
  constexpr std::size_t kSampled = 16, kMany = 16;
  constexpr double kPart = 1.0 / 32;
  const auto points = rounded.points;
  std::size_t needles = 0;
  for (std::size_t f = 0; f < rounded.triangles.size(); f += kSampled) {
    const auto& [a, b, c] = rounded.triangles[f];
    needles += points[a] == points[b] || points[b] == points[c] || points[c] == points[a] ? 1 : 0;
  }
  const auto all = static_cast<double>(rounded.triangles.size());
  return needles >= kMany && static_cast<double>(needles * kSampled) >= kPart * all;
}

std::vector<std::uint32_t> thicken_in_slabs(EditedMesh& mesh, const BrokenMesh& original,
                                            double reach) {
  const std::size_t count = std::min(original.triangles.size() / kTriangles, kMostSlabs);
  if (count < 2) {
    return support::numbers_below(original.triangles.size());
  }
  const Division division(original, count);
  std::vector<std::uint32_t> slab_of;
  slab_of.reserve(original.doubles.size());
  for (const Vec3& point : original.doubles) {
    slab_of.push_back(division.slab_of(point));
  }
  std::vector<std::optional<Slab>> slabs(division.size());
  support::for_each_in_parallel(slabs.size(), [&](std::size_t i) {
    slabs[i].emplace(original, division, slab_of, static_cast<std::uint32_t>(i)).thicken(reach);
  });
  for (const std::optional<Slab>& slab : slabs) {
    slab->put_into(mesh);
  }
  return faces_at_borders(mesh, original, slab_of);
}

}  // namespace dupin::rounding
