#include "rounding/shell_orientation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "boxes/bounds.h"
#include "boxes/box_quantizer.h"
#include "boxes/box_tree.h"
#include "support/blocks.h"
#include "support/disjoint_sets.h"

namespace dupin::rounding {
namespace {

/// More moving triangles than one in so many are left to the volumes of the shells, which then cost
/// no more.
constexpr std::size_t kSparse = 16;

/// So are regions next to which so many triangles prove nothing.
constexpr std::size_t kTries = 8;

using Box = Eigen::AlignedBox3d;

double largest_coordinate(const Box& box) {
  return std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

using Corners = std::array<Vec3, 3>;

Corners corners_of(const mesh::MeshView& mesh, std::uint32_t face) {
  const Triangle& t = mesh.triangles[face];
  return {mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
}

/// Any vector, if the triangle is degenerate.
Vec3 unit_normal(const Corners& t) { return (t[1] - t[0]).cross(t[2] - t[0]).stableNormalized(); }

/// The centre of a triangle that stays. Whatever direction separates it from another triangle, they
/// are apart.
class Place {
 public:
  /// `largest` is no less than any coordinate of the other triangles.
  Place(const Corners& triangle, double largest, double largest_move)
      : centre_((triangle[0] + triangle[1] + triangle[2]) / 3) {
    // With coordinates up to L, the centre is off by less than 7 L 2^-53 and heights over it by
    // less than 14 L 2^-53 more, underflow apart; unit vectors and these few sums by far less.
    largest = std::max(largest, largest_coordinate(boxes::bounds_of(triangle)));
    margin_ =
        (largest_move + largest * 0x1p-48 + std::numeric_limits<double>::min()) * (1 + 0x1p-48);
    const Vec3 normal = unit_normal(triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      across_[i] = (triangle[(i + 1) % 3] - triangle[i]).cross(normal).stableNormalized();
    }
  }

  /// True if the box is certainly farther than the largest move.
  [[nodiscard]] bool is_far_from(const Box& box) const {
    return (box.min() - centre_).cwiseMax(centre_ - box.max()).maxCoeff() > margin_;
  }
  [[nodiscard]] bool is_far_from(const Corners& other) const {
    const auto is_beyond = [&](const Vec3& direction) {
      return std::ranges::all_of(
          other, [&](const Vec3& corner) { return direction.dot(corner - centre_) > margin_; });
    };
    if (is_far_from(boxes::bounds_of(other)) || std::ranges::any_of(across_, is_beyond)) {
      return true;
    }
    const Vec3 normal = unit_normal(other);
    return is_beyond(normal) || is_beyond(-normal);
  }

 private:
  Vec3 centre_;
  double margin_ = 0;
  std::array<Vec3, 3> across_;  // the edges, outwards, in the triangle's plane
};

/// The triangles that do not stay, in groups.
class MovingTriangles {
 public:
  MovingTriangles(const mesh::MeshView& mesh, std::span<const std::uint32_t> faces,
                  double largest_move)
      : move_(largest_move) {
    for (const std::uint32_t face : faces) {
      triangles_.push_back(corners_of(mesh, face));
      const Box box = boxes::bounds_of(triangles_.back());
      if (triangles_.size() % kGroup == 1) {
        groups_.push_back(box);
      }
      groups_.back().extend(box);
      largest_ = std::max(largest_, largest_coordinate(box));
    }
  }

  /// True if a place of the triangle is certainly farther from all moving ones than they move.
  [[nodiscard]] bool stay_away_from(const Corners& triangle) const {
    const Place place(triangle, largest_, move_);
    for (std::size_t group = 0; group < groups_.size(); ++group) {
      if (place.is_far_from(groups_[group])) {
        continue;
      }
      const std::size_t begin = group * kGroup;
      const auto members =
          std::span(triangles_).subspan(begin, std::min(kGroup, triangles_.size() - begin));
      if (!std::ranges::all_of(members, [&](const Corners& t) { return place.is_far_from(t); })) {
        return false;
      }
    }
    return true;
  }

 private:
  static constexpr std::size_t kGroup = 32;

  std::vector<Corners> triangles_;
  std::vector<Box> groups_;
  double move_, largest_ = 0;
};

constexpr std::uint8_t kOwn = 1, kForeign = 2;

/// The triangles with an own corner and without a foreign one.
std::vector<std::uint32_t> own_faces(std::span<const Triangle> triangles,
                                     std::span<const std::uint8_t> marks) {
  return support::indices_where(triangles.size(), [&](std::uint32_t face) {
    const auto& [a, b, c] = triangles[face];
    return (marks[a] | marks[b] | marks[c]) == kOwn;
  });
}

/// So many triangles that come one after the other are asked for at once.
constexpr std::size_t kRun = 64;

class Surroundings {
 public:
  Surroundings(const mesh::MeshView& mesh, std::span<const std::uint32_t> faces, double reach)
      : mesh_(mesh), quantizer_(mesh.points), tree_(boxes_around(faces, reach)) {}

  /// Whether the box around consecutive triangles overlaps.
  [[nodiscard]] bool overlap(std::size_t begin, std::size_t end) const {
    Eigen::AlignedBox3d box;
    for (std::size_t face = begin; face < end; ++face) {
      for (const std::uint32_t corner : mesh_.triangles[face]) {
        box.extend(mesh_.points[corner]);
      }
    }
    return tree_.overlaps(quantizer_.around(box));
  }

 private:
  [[nodiscard]] std::vector<boxes::Box> boxes_around(std::span<const std::uint32_t> faces,
                                                     double reach) const {
    std::vector<boxes::Box> result;
    result.reserve(faces.size());
    for (const std::uint32_t face : faces) {
      const auto& [a, b, c] = mesh_.triangles[face];
      result.push_back(quantizer_.around(
          quantizer_.map(mesh_.points[a], mesh_.points[b], mesh_.points[c]), reach));
    }
    return result;
  }

  mesh::MeshView mesh_;
  boxes::BoxQuantizer quantizer_;
  boxes::BoxTree tree_;
};

/// Per triangle 1 if it is near those that move.
std::vector<std::uint8_t> near_ones(const mesh::MeshView& mesh,
                                    std::span<const std::uint32_t> moving, double reach) {
  const Surroundings surroundings(mesh, moving, reach);
  std::vector<std::uint8_t> near(mesh.triangles.size(), 0);
  support::for_each_block(near.size(), [&](const support::Block& block) {
    for (std::size_t begin = block.begin; begin < block.end; begin += kRun) {
      const std::size_t end = std::min(begin + kRun, block.end);
      if (surroundings.overlap(begin, end)) {
        for (std::size_t face = begin; face < end; ++face) {
          near[face] = surroundings.overlap(face, face + 1) ? 1 : 0;
        }
      }
    }
  });
  return near;
}

/// A connected part of the surface that does not stay, with the triangles next to it; or a shell
/// near such parts.
struct Region {
  std::size_t tries = 0;
  bool keeps_its_sides = false;
};

}  // namespace

std::vector<std::uint32_t> faces_of_near_shells(const mesh::MeshView& mesh,
                                                std::span<const std::uint32_t> moving,
                                                double reach) {
  std::vector<std::uint8_t> is_near = near_ones(mesh, moving, reach);
  for (const std::uint32_t face : moving) {
    is_near[face] = 0;  // nor are, for that, the shells of these
  }
  const auto faces = [&](auto&& condition) {
    return support::indices_where(mesh.triangles.size(), [&](std::uint32_t face) {
      return condition(is_near[face] != 0, mesh.triangles[face]);
    });
  };
  std::vector<std::uint32_t> near = faces([](bool near_one, const Triangle&) { return near_one; });
  if (near.empty()) {
    return near;
  }
  support::DisjointSets shells(mesh.points.size());
  std::vector<std::uint8_t> is_corner(mesh.points.size(), 0), reaches_out = is_corner;
  for (const std::uint32_t face : near) {
    const auto& [a, b, c] = mesh.triangles[face];
    shells.unite(a, b);
    shells.unite(a, c);
    is_corner[a] = is_corner[b] = is_corner[c] = 1;
  }
  for (const std::uint32_t face : faces([&](bool near_one, const Triangle&t) {
         return !near_one && (is_corner[t[0]] | is_corner[t[1]] | is_corner[t[2]]) != 0;
       })) {
    for (const std::uint32_t corner : mesh.triangles[face]) {
      reaches_out[shells.find(corner)] = 1;
    }
  }
  std::erase_if(near, [&](std::uint32_t face) {
    return reaches_out[shells.find(mesh.triangles[face][0])] != 0;
  });
  return near;
}

bool keeps_shell_orientation(const mesh::MeshView& mesh, std::span<const std::uint8_t> moved,
                             double largest_move) {
  const std::vector<std::uint32_t> moving = own_faces(mesh.triangles, moved);
  if (moving.size() * kSparse > mesh.triangles.size()) {
    return false;
  }
  if (moving.empty()) {
    return true;
  }
  support::DisjointSets sets(mesh.points.size());
  std::vector<std::uint8_t> marks(moved.begin(), moved.end());
  for (std::uint8_t& mark : marks) {
    mark *= kForeign;
  }
  const auto unite = [&](const Triangle& t) {
    sets.unite(t[0], t[1]);
    sets.unite(t[0], t[2]);
  };
  for (const std::uint32_t face : moving) {
    const Triangle& t = mesh.triangles[face];
    for (const std::uint32_t point : t) {
      marks[point] |= kOwn;
    }
    unite(t);
  }
  std::vector<std::uint32_t> staying = own_faces(mesh.triangles, marks);
  const std::vector<std::uint32_t> near = faces_of_near_shells(mesh, moving, largest_move);
  staying.insert(staying.end(), near.begin(), near.end());
  for (const std::uint32_t face : staying) {
    unite(mesh.triangles[face]);
  }
  std::map<std::uint32_t, Region> regions;  // by their lowest points
  for (const auto faces : {std::span(moving), std::span(near)}) {
    for (const std::uint32_t face : faces) {
      regions.try_emplace(sets.find(mesh.triangles[face][0]));
    }
  }
  const MovingTriangles triangles(mesh, moving, largest_move);
  for (const std::uint32_t face : staying) {
    Region& region = regions[sets.find(mesh.triangles[face][0])];
    if (!region.keeps_its_sides && region.tries < kTries) {
      ++region.tries;
      region.keeps_its_sides = triangles.stay_away_from(corners_of(mesh, face));
    }
  }
  return std::ranges::all_of(regions, [](const auto& r) { return r.second.keeps_its_sides; });
}

}  // namespace dupin::rounding
