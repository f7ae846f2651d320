#include "mesh/ray_faces.h"

#include <limits>
#include <vector>

#include "boxes/box_quantizer.h"
#include "boxes/box_tree.h"

namespace dupin::mesh {
namespace {

// A tree costs about as much as that many looks at all faces.
constexpr std::uint32_t kScans = 16;

std::vector<Vec3> corners_of(const MeshView& mesh, std::span<const std::uint32_t> faces) {
  std::vector<Vec3> corners;
  for (const std::uint32_t face : faces) {
    for (const std::uint32_t corner : mesh.triangles[face]) {
      corners.push_back(mesh.points[corner]);
    }
  }
  return corners;
}

boxes::Box box_between(const boxes::FramedPoint& low, const boxes::FramedPoint& high) {
  return {{low.x(), low.y(), low.z()}, {high.x(), high.y(), high.z()}};
}

}  // namespace

struct RayFaces::Tree {
  Tree(const MeshView& mesh, std::span<const std::uint32_t> faces)
      : quantizer(corners_of(mesh, faces)),
        boxes(std::uint32_t(faces.size()),
              [&](std::uint32_t i) {
                const Eigen::AlignedBox3d bounds = bounds_of(mesh, faces[i]);
                return box_between(quantizer.map(bounds.min()), quantizer.map(bounds.max()));
              },
              {}, {}) {}

  // The map is monotone.
  [[nodiscard]] boxes::Box ray(const WindingPoint& from) const {
    boxes::Box box =
        box_between(quantizer.map(from.around.min()), quantizer.map(from.around.max()));
    box.high[0] = std::numeric_limits<float>::max();
    return box;
  }

  boxes::BoxQuantizer quantizer;
  boxes::BoxTree boxes;
};

RayFaces::RayFaces(const MeshView& mesh, std::span<const std::uint32_t> faces)
    : mesh_(mesh), faces_(faces) {}

RayFaces::~RayFaces() = default;

int RayFaces::winding_number(const WindingPoint& point) const {
  if (asked_.load(std::memory_order_relaxed) < kScans) {
    ++asked_;
    return mesh::winding_number(mesh_, faces_, point);
  }
  std::call_once(once_, [this] { tree_ = std::make_unique<const Tree>(mesh_, faces_); });
  std::vector<std::uint32_t> met;
  tree_->boxes.visit(tree_->ray(point), [&](std::uint32_t i) { met.push_back(faces_[i]); });
  return mesh::winding_number(mesh_, met, point);
}

}  // namespace dupin::mesh
