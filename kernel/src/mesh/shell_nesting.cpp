#include "mesh/shell_nesting.h"

#include <algorithm>
#include <optional>

namespace dupin::mesh {
namespace {

std::vector<Eigen::AlignedBox3d> boxes_of(const MeshView& mesh, const Shells& shells) {
  std::vector<Eigen::AlignedBox3d> result(shells.count);
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    for (const std::uint32_t corner : mesh.triangles[face]) {
      result[shells.of_face[face]].extend(mesh.points[corner]);
    }
  }
  return result;
}

Eigen::AlignedBox3d union_of(std::span<const Eigen::AlignedBox3d> all) {
  Eigen::AlignedBox3d result;
  for (const Eigen::AlignedBox3d& box : all) {
    result.extend(box);
  }
  return result;
}

std::vector<boxes::Box> framed_boxes_of(const MeshView& mesh, const Shells& shells,
                                        const boxes::BoxQuantizer& quantizer) {
  std::vector<boxes::Box> result(shells.count, boxes::Box::nothing());
  const auto mapped = quantizer.map(mesh.points);
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    const auto& [a, b, c] = mesh.triangles[face];
    result[shells.of_face[face]].join(quantizer.around({mapped[a], mapped[b], mapped[c]}));
  }
  return result;
}

// Whether `outer`, larger by `reach` on all sides, contains the box.
bool is_within(const boxes::Box& box, const boxes::Box& outer, float reach) {
  bool is_within = true;
  for (std::size_t k = 0; k < 3; ++k) {
    is_within =
        is_within && box.low[k] >= outer.low[k] - reach && box.high[k] <= outer.high[k] + reach;
  }
  return is_within;
}

}  // namespace

double ray_cost(const MeshView& mesh, std::uint32_t face) {
  return bounds_of(mesh, face).sizes().tail<2>().sum();
}

// Three times it, and all is scaled by 3, to stay in integers.
WindingPoint point_within(const MeshView& mesh, std::uint32_t face) {
  exact::ExactVector point;
  for (const std::uint32_t corner : mesh.triangles[face]) {
    for (int i = 0; i < 3; ++i) {
      point[i] = point[i] + CGAL::Mpzf(mesh.points[corner][i]);
    }
  }
  return {point, 3, bounds_of(mesh, face)};
}

ShellNest::ShellNest(const MeshView& mesh, const Shells& shells)
    : mesh_(mesh),
      shells_(shells),
      boxes_(boxes_of(mesh, shells)),
      quantizer_(union_of(boxes_), mesh.points, mesh.triangles),
      framed_(framed_boxes_of(mesh, shells, quantizer_)),
      tree_(std::span<const boxes::Box>(framed_)),
      large_(shells.count) {
  constexpr std::size_t kLarge = 256;
  for (std::size_t shell = 0; shell < shells.count; ++shell) {
    if (const auto faces = shells.faces_of(shell); faces.size() >= kLarge) {
      large_[shell] = std::make_unique<const RayFaces>(mesh_, faces);
    }
  }
}

bool ShellNest::encloses(std::size_t outer, std::size_t inner) const {
  return boxes_[outer].contains(boxes_[inner]) && encloses(outer, test_point(inner));
}

bool ShellNest::encloses(std::size_t outer, const WindingPoint& point) const {
  return (large_[outer] ? large_[outer]->winding_number(point)
                        : winding_number(mesh_, shells_.faces_of(outer), point)) != 0;
}

WindingPoint ShellNest::test_point(std::size_t shell) const {
  return point_within(
      mesh_, *std::ranges::min_element(shells_.faces_of(shell), {},
                                       [&](std::uint32_t face) { return ray_cost(mesh_, face); }));
}

void ShellNest::visit_boxes_around(std::size_t shell, double margin,
                                   const std::function<void(std::size_t)>& visit) const {
  const Vec3 &low = boxes_[shell].min(), &high = boxes_[shell].max();
  const boxes::Box& framed = framed_[shell];
  const boxes::FramedPoint corner(framed.low.data());
  // Turned, a margin along the axes is less than twice as long.
  const boxes::Box about = quantizer_.around({corner, corner, corner}, 2 * margin);
  const float reach = about.high[0] - corner[0];
  tree_.visit(about, [&](std::uint32_t outer) {
    const Eigen::AlignedBox3d& box = boxes_[outer];
    if (outer != shell && is_within(framed, framed_[outer], reach) &&
        (box.min() - low).maxCoeff() <= margin && (high - box.max()).maxCoeff() <= margin) {
      visit(outer);
    }
  });
}

int ShellNest::depth(std::size_t shell) const {
  int depth = 0;
  std::optional<WindingPoint> point;
  visit_boxes_around(shell, 0, [&](std::size_t outer) {
    if (!point) {
      point = test_point(shell);
    }
    depth += encloses(outer, *point) ? 1 : 0;
  });
  return depth;
}

std::vector<int> nesting_depths(const MeshView& mesh, const Shells& shells) {
  std::vector<int> depths(shells.count);
  if (shells.count < 2) {
    return depths;
  }
  const ShellNest nest(mesh, shells);
  for (std::size_t shell = 0; shell < shells.count; ++shell) {
    depths[shell] = nest.depth(shell);
  }
  return depths;
}

}  // namespace dupin::mesh
