#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "boxes/box_quantizer.h"
#include "boxes/box_tree.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/solid.h"
#include "rounding/edits/edited_mesh.h"
#include "rounding/edits/fault_tracker.h"

namespace dupin::rounding {

/// What repair reads of a mesh whose rounding has faults.
struct BrokenMesh {
  std::span<const Vec3> doubles, on_lattice;  ///< the places before and after rounding
  std::span<const Triangle> triangles;
  std::span<const std::uint32_t> labels;           ///< per triangle; may be empty
  std::span<const std::uint32_t> representatives;  ///< per point the first that coincides with it
  std::span<const std::uint8_t> complete = {};     ///< as EditedMesh has them
};

/// As it was before rounding.
[[nodiscard]] inline EditedMesh unedited(const BrokenMesh& mesh) {
  return {mesh.doubles, mesh.triangles, mesh.labels, mesh.representatives, mesh.complete};
}

/// Some triangles of a mesh as a mesh of its own with a border. Numbers, of points and of
/// triangles, ascend as in the whole mesh.
class MeshPart {
 public:
  /// These triangles, ascending. Points are complete that are said to be.
  MeshPart(const BrokenMesh& whole, std::vector<std::uint32_t> faces,
           const std::function<bool(std::uint32_t)>& is_complete);

  /// The surroundings of faults: the triangles some rings around, and all that are as near to these
  /// as edits may move them. None if the part would not be much smaller than the whole. `reach`
  /// bounds the moves of points before they are rounded, `step` those of rounding.
  [[nodiscard]] static std::optional<MeshPart> around(const BrokenMesh& whole,
                                                      std::span<const std::uint32_t> broken,
                                                      double reach, double step);

  /// Refers to the part.
  [[nodiscard]] BrokenMesh view() const;
  /// The numbers, in the whole mesh, of the part's triangles and points.
  [[nodiscard]] const std::vector<std::uint32_t>& faces() const { return faces_; }
  [[nodiscard]] const std::vector<std::uint32_t>& points() const { return points_; }
  /// The numbers in the part of triangles of the whole mesh that belong to it.
  [[nodiscard]] std::uint32_t face(std::uint32_t of_whole) const;
  [[nodiscard]] std::vector<std::uint32_t> numbered(std::span<const std::uint32_t> of_whole) const;
  [[nodiscard]] std::vector<Fault> numbered(std::span<const Fault> of_whole) const;

  /// Of surroundings: whether, in the whole mesh that they have been put into, repaired triangles
  /// that differ from the rounded ones make faults with others than those of the part.
  [[nodiscard]] bool meets_rest(const EditedMesh& repaired, const Embedding& whole) const;

  /// Puts the repaired triangles, dead ones apart, and points into the rounded whole mesh.
  void put(const EditedMesh& repaired, TriMesh& whole, std::vector<Source>& sources) const;
  /// Puts the rounded points into the whole mesh.
  void put_back(std::vector<Vec3>& points) const;

 private:
  /// Boxes: all triangles whose rounded ones' boxes meet them are in the part.
  struct Zones {
    boxes::BoxQuantizer frame;
    std::vector<boxes::Box> boxes;
    boxes::BoxTree tree;
  };

  std::optional<Zones> zones_;  // of surroundings
  std::vector<std::uint32_t> faces_, points_;
  std::vector<Vec3> doubles_, on_lattice_;
  std::vector<std::uint8_t> complete_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> labels_, representatives_;
};

/// For each of these points, by its place, the first of them that coincides with it; of the whole
/// mesh `representatives` are given.
[[nodiscard]] std::vector<std::uint32_t> representatives_among(
    std::span<const std::uint32_t> points, std::span<const std::uint32_t> representatives);

/// Removes the items at ascending places, if there are any items.
template <class Item>
void erase_at(std::span<const std::uint32_t> places, std::vector<Item>& items) {
  if (places.empty() || items.empty()) {
    return;
  }
  auto end = items.begin() + places.front();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t next = i + 1 < places.size() ? places[i + 1] : items.size();
    end = std::move(items.begin() + places[i] + 1,
                    items.begin() + static_cast<std::ptrdiff_t>(next), end);
  }
  items.erase(end, items.end());
}

/// Removes points, ascending, that no triangle has.
void erase_points(std::span<const std::uint32_t> unused, TriMesh& mesh);

}  // namespace dupin::rounding
