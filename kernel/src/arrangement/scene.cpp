#include "scene.h"

#include <algorithm>
#include <numeric>

#include <CGAL/box_intersection_d.h>

#include "../identical_points.h"
#include "limits.h"
#include "places.h"
#include "winding_change.h"

namespace dupin::detail {
namespace {

void check_limits(std::span<const ExactMesh* const> operands) {
  std::uint64_t points = 0, triangles = 0;
  for (const ExactMesh* mesh : operands) {
    points += mesh->points.size() + 3 * mesh->planes.size();
    triangles += mesh->triangles.size();
  }
  refuse_too_many(points, triangles);
}

// Corners of the planes that triangles with implicit corners lie in, as points of their own.
std::vector<PointId> add_plane_points(Scene& scene) {
  std::vector<PointId> first_of_operand;
  for (const ExactMesh* mesh : scene.operands) {
    first_of_operand.push_back(scene.points.size());
    for (const std::array<Vec3, 3>& plane : mesh->planes) {
      for (const Vec3& point : plane) {
        scene.points.add(point);
      }
    }
  }
  return first_of_operand;
}

void find_supports(Scene& scene, const std::vector<PointId>& first_plane_point) {
  const auto has_planes = [](const ExactMesh* mesh) { return !mesh->planes.empty(); };
  if (std::none_of(scene.operands.begin(), scene.operands.end(), has_planes)) {
    return;
  }
  scene.supports = scene.triangles;
  for (std::size_t o = 0; o < scene.operands.size(); ++o) {
    const std::vector<std::uint32_t>& plane_of = scene.operands[o]->plane_of;
    for (std::size_t i = 0; i < plane_of.size(); ++i) {
      if (plane_of[i] != ExactMesh::kOwnPlane) {
        const PointId first = first_plane_point[o] + 3 * plane_of[i];
        scene.supports[scene.first_triangle[o] + i] = {first, first + 1, first + 2};
      }
    }
  }
}

void add_points_and_triangles(Scene& scene) {
  std::size_t doubles = 0, triangles = 0;
  for (const ExactMesh* mesh : scene.operands) {
    doubles += mesh->double_count();
    triangles += mesh->triangles.size();
  }
  scene.points.reserve_doubles(doubles);
  scene.triangles.reserve(triangles);
  std::vector<PointId> first_double;
  for (const ExactMesh* mesh : scene.operands) {
    first_double.push_back(scene.points.size());
    for (std::uint32_t i = 0; i < mesh->double_count(); ++i) {
      scene.points.add(mesh->points[i]);
    }
  }
  const std::vector<PointId> first_plane_point = add_plane_points(scene);
  for (std::size_t o = 0; o < scene.operands.size(); ++o) {
    const ExactMesh& mesh = *scene.operands[o];
    const PointId first_implicit = scene.points.size();
    for (const ExactPoint& point : mesh.implicit) {
      scene.points.add(point);
    }
    const auto global = [&](std::uint32_t i) {
      return i < mesh.double_count() ? first_double[o] + i
                                     : first_implicit + (i - mesh.double_count());
    };
    scene.first_triangle.push_back(static_cast<std::uint32_t>(scene.triangles.size()));
    for (const Triangle& t : mesh.triangles) {
      scene.triangles.push_back({global(t[0]), global(t[1]), global(t[2])});
    }
  }
  scene.first_triangle.push_back(static_cast<std::uint32_t>(scene.triangles.size()));
  find_supports(scene, first_plane_point);
}

// Bounds of the nearest doubles of the points. Rounding is monotone: where exact solids meet, these
// overlap.
void find_bounds(Scene& scene) {
  for (const ExactMesh* mesh : scene.operands) {
    Scene::Bounds box;
    for (const Vec3& point : mesh->points) {
      box.extend(point);
    }
    scene.bounds.push_back(box);
    if (!mesh->points.empty()) {
      scene.extent = std::max(
          {scene.extent, box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()});
    }
  }
}

void find_operand_pairs(Scene& scene) {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;
  std::vector<Box> boxes;
  for (std::uint32_t i = 0; i < scene.bounds.size(); ++i) {
    const Scene::Bounds& b = scene.bounds[i];
    if (!b.isEmpty()) {
      boxes.emplace_back(
          CGAL::Bbox_3(b.min()[0], b.min()[1], b.min()[2], b.max()[0], b.max()[1], b.max()[2]), i);
    }
  }
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&scene](const Box& a, const Box& b) {
    scene.operand_pairs.push_back({std::min(a.info(), b.info()), std::max(a.info(), b.info())});
  });
  std::sort(scene.operand_pairs.begin(), scene.operand_pairs.end());
}

// Points that may have a twin: those inside the bounds of another operand, and all of an operand
// whose surface touches itself.
std::vector<std::vector<std::uint32_t>> shared_candidates(const Scene& scene) {
  // With more neighbours than this, asking all of them costs more than hashing the point.
  constexpr std::size_t kManyNeighbours = 16;
  std::vector<std::vector<std::uint32_t>> neighbours(scene.operands.size());
  for (const auto& [a, b] : scene.operand_pairs) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  std::vector<std::vector<std::uint32_t>> candidates(scene.operands.size());
  for (std::size_t o = 0; o < scene.operands.size(); ++o) {
    const ExactMesh& mesh = *scene.operands[o];
    const bool all = !mesh.contacts.empty() || neighbours[o].size() > kManyNeighbours;
    for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
      const auto holds = [&](std::uint32_t other) {
        return scene.bounds[other].contains(mesh.points[i]);
      };
      if (all || std::any_of(neighbours[o].begin(), neighbours[o].end(), holds)) {
        candidates[o].push_back(i);
      }
    }
  }
  return candidates;
}

class Welder {
 public:
  explicit Welder(Scene& scene) : scene_(scene), first_(scene.points.size()) {
    std::iota(first_.begin(), first_.end(), 0u);
    scene.special.assign(scene.points.size(), 0);
  }

  void weld() {
    const auto candidates = shared_candidates(scene_);
    PointId next_double = 0, next_implicit = scene_.points.double_count();
    for (std::size_t o = 0; o < scene_.operands.size(); ++o) {
      const ExactMesh& mesh = *scene_.operands[o];
      for (const std::uint32_t i : candidates[o]) {
        const bool is_double = i < mesh.double_count();
        (is_double ? doubles_ : implicit_)
            .push_back(is_double ? next_double + i : next_implicit + (i - mesh.double_count()));
      }
      next_double += mesh.double_count();
      next_implicit += static_cast<PointId>(mesh.implicit.size());
    }
    weld_doubles();
    weld_implicit();
    if (welded_) {
      for (Triangle& t : scene_.triangles) {
        t = {first_[t[0]], first_[t[1]], first_[t[2]]};
      }
      for (Triangle& t : scene_.supports) {
        t = {first_[t[0]], first_[t[1]], first_[t[2]]};
      }
    }
  }

 private:
  void join(PointId id, PointId first) {
    if (id != first) {
      first_[id] = first;
      scene_.special[first] = 1;
      welded_ = true;
    }
  }
  void weld_doubles() {
    std::vector<Vec3> places;
    places.reserve(doubles_.size());
    for (const PointId id : doubles_) {
      places.push_back(scene_.points.coordinates(id));
    }
    const std::vector<std::uint32_t> first = first_identical(places);
    for (std::size_t i = 0; i < doubles_.size(); ++i) {
      join(doubles_[i], doubles_[first[i]]);
    }
  }
  void weld_implicit() {
    PlaceIndex index(scene_.points, scene_.extent, implicit_.size());
    for (const PointId id : implicit_) {
      join(id, index.first_at_place_of(id));
    }
  }

  Scene& scene_;
  std::vector<PointId> first_, doubles_, implicit_;
  bool welded_ = false;
};

// An edge along which an operand touches itself may have copies of one end only: the umbrella of
// the other end then passes it twice.
void mark_repeated_edges(Scene& scene) {
  std::vector<std::array<PointId, 2>> edges;
  for (std::size_t o = 0; o < scene.operands.size(); ++o) {
    if (scene.operands[o]->contacts.empty()) {
      continue;
    }
    edges.clear();
    for (std::uint32_t t = scene.first_triangle[o]; t < scene.first_triangle[o + 1]; ++t) {
      const Triangle& corners = scene.triangles[t];
      for (std::size_t i = 0; i < 3; ++i) {
        const PointId from = corners[i], to = corners[(i + 1) % 3];
        if (scene.special[from] || scene.special[to]) {
          edges.push_back({from, to});
        }
      }
    }
    std::sort(edges.begin(), edges.end());
    for (auto e = edges.begin(); (e = std::adjacent_find(e, edges.end())) != edges.end(); ++e) {
      scene.special[(*e)[0]] = scene.special[(*e)[1]] = 1;
    }
  }
}

bool same_orientation(const Triangle& a, const Triangle& b) {
  const auto k = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
  return b[(k + 1) % 3] == a[1];
}

void merge_coincident_triangles(Scene& scene, const BooleanRule& rule) {
  scene.merged.assign(scene.triangles.size(), 0);
  std::vector<std::pair<Triangle, std::uint32_t>> shared;
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    Triangle corners = scene.triangles[t];
    if (scene.special[corners[0]] && scene.special[corners[1]] && scene.special[corners[2]]) {
      std::sort(corners.begin(), corners.end());
      shared.emplace_back(corners, t);
    }
  }
  std::sort(shared.begin(), shared.end());
  for (std::size_t i = 0, end = 0; i < shared.size(); i = end) {
    end = i + 1;
    while (end < shared.size() && shared[end].first == shared[i].first) {
      ++end;
    }
    if (end == i + 1) {
      continue;
    }
    const std::uint32_t kept = shared[i].second;
    std::vector<SignedTriangle> coincident;
    for (std::size_t j = i; j < end; ++j) {
      const std::uint32_t t = shared[j].second;
      const bool same = same_orientation(scene.triangles[kept], scene.triangles[t]);
      coincident.push_back({t, same ? 1 : -1});
    }
    const bool gone = changes_nothing(winding_change(scene, rule, coincident));
    for (std::size_t j = gone ? 0 : 1; j < coincident.size(); ++j) {
      scene.merged[coincident[j].triangle] = 1;
      if (!gone) {
        scene.duplicates.push_back({kept, coincident[j]});
      }
    }
  }
  std::stable_sort(scene.duplicates.begin(), scene.duplicates.end(),
                   [](const auto& a, const auto& b) { return a.kept < b.kept; });
}

}  // namespace

std::uint32_t Scene::operand_of(std::uint32_t triangle) const {
  return static_cast<std::uint32_t>(
      std::upper_bound(first_triangle.begin(), first_triangle.end(), triangle) -
      first_triangle.begin() - 1);
}

std::vector<SignedTriangle> Scene::cover(std::uint32_t triangle) const {
  std::vector<SignedTriangle> all{{triangle, 1}};
  const auto begin =
      std::lower_bound(duplicates.begin(), duplicates.end(), triangle,
                       [](const Duplicate& d, std::uint32_t t) { return d.kept < t; });
  for (auto d = begin; d != duplicates.end() && d->kept == triangle; ++d) {
    all.push_back(d->copy);
  }
  return all;
}

Scene import_operands(std::span<const ExactMesh* const> operands, const BooleanRule& rule) {
  check_limits(operands);
  Scene scene;
  scene.operands = operands;
  add_points_and_triangles(scene);
  find_bounds(scene);
  find_operand_pairs(scene);
  Welder(scene).weld();
  mark_repeated_edges(scene);
  merge_coincident_triangles(scene, rule);
  return scene;
}

}  // namespace dupin::detail
