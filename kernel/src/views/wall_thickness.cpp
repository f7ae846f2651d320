#include "dupin/kernel/wall_thickness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "boxes/bounds.h"
#include "boxes/box_quantizer.h"
#include "boxes/box_tree.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "dupin/kernel/patch.h"

namespace dupin {
namespace {

// The first reach of a way, of the mesh's diagonal, and how it grows: a slanted stretch of the way
// lies in a box of its length cubed.
constexpr double kFirstReach = 0x1p-9, kGrowth = 1.5;

class Walls {
 public:
  Walls(const TriMesh& mesh, double most_angle)
      : mesh_(mesh),
        opposite_(-std::cos(most_angle)),
        diagonal_(boxes::bounds_of(mesh.points).diagonal().norm()),
        quantizer_(mesh.points, mesh.triangles),
        tree_(tree()) {}

  [[nodiscard]] std::optional<WallPlace> wall_behind(std::uint32_t face) const {
    const Vec3 across = doubled_area(face);
    if (!(across.squaredNorm() > 0)) {
      return std::nullopt;
    }
    const auto& [a, b, c] = mesh_.triangles[face];
    const Vec3 from = (mesh_.points[a] + mesh_.points[b] + mesh_.points[c]) / 3;
    const Vec3 inwards = -across.normalized();
    double before = 0;
    for (double reach = kFirstReach * diagonal_; before < diagonal_; reach *= kGrowth) {
      const auto [way, other] = first_hit(face, from, inwards, {before, reach});
      before = reach;
      if (way <= reach) {
        return -doubled_area(other).normalized().dot(inwards) > opposite_
                   ? std::nullopt
                   : std::optional(WallPlace{label_of(face), from, from + way * inwards, way});
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::uint32_t label_of(std::uint32_t face) const {
    return mesh_.labels.empty() ? 0 : mesh_.labels[face];
  }

 private:
  [[nodiscard]] boxes::BoxTree tree() const {
    const auto framed = [this](std::uint32_t face) {
      const auto& [a, b, c] = mesh_.triangles[face];
      return quantizer_.map(mesh_.points[a], mesh_.points[b], mesh_.points[c]);
    };
    std::vector<boxes::Box> all;
    all.reserve(mesh_.triangles.size());
    for (std::uint32_t face = 0; face < mesh_.triangles.size(); ++face) {
      all.push_back(quantizer_.around(framed(face)));
    }
    return boxes::BoxTree(all, framed);
  }

  [[nodiscard]] Vec3 doubled_area(std::uint32_t face) const {
    const auto& [a, b, c] = mesh_.triangles[face];
    return (mesh_.points[b] - mesh_.points[a]).cross(mesh_.points[c] - mesh_.points[a]);
  }

  struct Hit {
    double way = std::numeric_limits<double>::infinity();
    std::uint32_t face = 0;
  };

  struct Stretch {
    double from, to;
  };

  // Of the faces about a stretch of the way.
  [[nodiscard]] Hit first_hit(std::uint32_t face, const Vec3& from, const Vec3& direction,
                              const Stretch& stretch) const {
    Hit first;
    const Vec3 begin = from + stretch.from * direction, end = from + stretch.to * direction;
    tree_.visit(quantizer_.around(quantizer_.map(begin, end, end)), [&](std::uint32_t other) {
      if (const double way = other == face ? first.way : exit(other, from, direction);
          way < first.way) {
        first = {way, other};
      }
    });
    return first;
  }

  // Where a ray leaves the solid through the face, in lengths of its direction [MT97]; infinity if
  // it does not.
  [[nodiscard]] double exit(std::uint32_t face, const Vec3& from, const Vec3& direction) const {
    constexpr double kNever = std::numeric_limits<double>::infinity();
    const auto& [p, q, r] = mesh_.triangles[face];
    const Vec3 a = mesh_.points[p], u = mesh_.points[q] - a, v = mesh_.points[r] - a,
               across = direction.cross(v), beside = from - a, along = beside.cross(u);
    const double determinant = u.dot(across);
    if (!(determinant < 0)) {
      return kNever;
    }
    const double s = beside.dot(across) / determinant, t = direction.dot(along) / determinant,
                 way = v.dot(along) / determinant;
    if (!(s >= 0 && t >= 0 && s + t <= 1 && way > 0)) {
      return kNever;
    }
    return way;
  }

  const TriMesh& mesh_;
  double opposite_, diagonal_;
  boxes::BoxQuantizer quantizer_;
  boxes::BoxTree tree_;
};

// Of each label every so many, so that none has more than its share.
std::vector<std::uint32_t> tried_faces(const TriMesh& mesh, std::size_t most) {
  std::vector<std::vector<std::uint32_t>> of_label(std::max<std::size_t>(1, mesh.names.size()));
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    of_label[mesh.labels.empty() ? 0 : mesh.labels[face]].push_back(face);
  }
  const std::size_t share = std::max<std::size_t>(1, most / of_label.size());
  std::vector<std::uint32_t> result;
  for (const std::vector<std::uint32_t>& faces : of_label) {
    const std::size_t step = (faces.size() + share - 1) / share;
    for (std::size_t i = 0; i < faces.size(); i += step) {
      result.push_back(faces[i]);
    }
  }
  return result;
}

}  // namespace

std::vector<WallPlace> thinnest_walls(const TriMesh& mesh, std::size_t most_ways,
                                      double most_angle) {
  require_indices(mesh);
  if (!std::isfinite(most_angle)) {
    throw Error(Errc::invalid_argument, "the largest angle between the sides of a wall is finite");
  }
  if (mesh.triangles.empty()) {
    return {};
  }
  const Walls walls(mesh, most_angle);
  const std::vector<std::uint32_t> faces = tried_faces(mesh, most_ways);
  std::vector<std::optional<WallPlace>> found(faces.size());
  for_each_in_parallel(faces.size(),
                       [&](std::size_t i) { found[i] = walls.wall_behind(faces[i]); });
  std::vector<WallPlace> result;
  for (const auto& place : found) {
    if (!place) {
      continue;
    }
    if (result.empty() || result.back().label != place->label) {
      result.push_back(*place);
    } else if (place->thickness < result.back().thickness) {
      result.back() = *place;
    }
  }
  return result;
}

}  // namespace dupin
