#include "rounding/near_shells.h"

#include <algorithm>
#include <cstddef>

#include <Eigen/Geometry>

#include "boxes/box_quantizer.h"
#include "boxes/box_tree.h"
#include "support/blocks.h"
#include "support/disjoint_sets.h"

namespace dupin::rounding {
namespace {

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
    const auto low = quantizer_.map(box.min()), high = quantizer_.map(box.max());
    return tree_.overlaps(quantizer_.around({low, high, high}));
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

}  // namespace dupin::rounding
