#include "scene.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <numeric>

#include <CGAL/box_intersection_d.h>

#include "../identical_points.h"
#include "blocks.h"
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

// The places of the operands' points and triangles in the scene.
void lay_out(Scene& scene) {
  PointId doubles = 0;
  std::uint32_t triangles = 0;
  std::size_t planes = 0;
  for (const ExactMesh* mesh : scene.operands) {
    scene.first_double.push_back(doubles);
    scene.first_triangle.push_back(triangles);
    doubles += mesh->double_count();
    triangles += static_cast<std::uint32_t>(mesh->triangles.size());
    planes += mesh->planes.size();
  }
  scene.first_double.push_back(doubles);
  scene.first_triangle.push_back(triangles);
  scene.triangles.resize(triangles);
  scene.points.set_double_count(doubles + 3 * planes);
}

void add_implicit_points(Scene& scene) {
  for (const ExactMesh* mesh : scene.operands) {
    scene.first_implicit.push_back(scene.points.size());
    for (const ExactPoint& point : mesh->implicit) {
      scene.points.add(point);
    }
  }
  scene.first_implicit.push_back(scene.points.size());
}

void copy_triangles(Scene& scene, std::size_t o) {
  const std::vector<Triangle>& triangles = scene.operands[o]->triangles;
  for_each_block(triangles.size(), [&](const Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const auto& [a, b, c] = triangles[i];
      scene.triangles[scene.first_triangle[o] + i] = {scene.point_of(o, a), scene.point_of(o, b),
                                                      scene.point_of(o, c)};
    }
  });
}

// Bounds of the nearest doubles of the points. Rounding is monotone: where exact solids meet, these
// overlap.
Scene::Bounds copy_points(Scene& scene, std::size_t o) {
  const ExactMesh& mesh = *scene.operands[o];
  std::vector<Scene::Bounds> bounds(block_count(mesh.points.size()));
  for_each_block(mesh.points.size(), [&](const Block& block) {
    Scene::Bounds& part = bounds[block.number];
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const Vec3& point = mesh.points[i];
      part.extend(point);
      if (i < mesh.double_count()) {
        scene.points.set(scene.first_double[o] + static_cast<PointId>(i), point);
      }
    }
  });
  Scene::Bounds all;
  for (const Scene::Bounds& part : bounds) {
    all.extend(part);
  }
  return all;
}

// The planes that triangles with implicit corners lie in, by points of their own.
void find_supports(Scene& scene) {
  const auto has_planes = [](const ExactMesh* mesh) { return !mesh->planes.empty(); };
  if (std::none_of(scene.operands.begin(), scene.operands.end(), has_planes)) {
    return;
  }
  scene.supports = scene.triangles;
  PointId next = scene.first_double.back();
  for (std::size_t o = 0; o < scene.operands.size(); ++o) {
    const PointId first_plane_point = next;
    for (const std::array<Vec3, 3>& plane : scene.operands[o]->planes) {
      for (const Vec3& point : plane) {
        scene.points.set(next++, point);
      }
    }
    const std::vector<std::uint32_t>& plane_of = scene.operands[o]->plane_of;
    for (std::size_t i = 0; i < plane_of.size(); ++i) {
      if (plane_of[i] != ExactMesh::kOwnPlane) {
        const PointId first = first_plane_point + 3 * plane_of[i];
        scene.supports[scene.first_triangle[o] + i] = {first, first + 1, first + 2};
      }
    }
  }
}

void add_points_and_triangles(Scene& scene) {
  lay_out(scene);
  add_implicit_points(scene);
  scene.bounds.resize(scene.operands.size());
  for_each_in_parallel(scene.operands.size(), [&](std::size_t o) {
    copy_triangles(scene, o);
    scene.bounds[o] = copy_points(scene, o);
  });
  for (const Scene::Bounds& box : scene.bounds) {
    if (!box.isEmpty()) {
      scene.extent = std::max(
          {scene.extent, box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()});
    }
  }
  find_supports(scene);
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
std::vector<PointId> shared_candidates(const Scene& scene) {
  // With more neighbours than this, asking all of them costs more than hashing the point.
  constexpr std::size_t kManyNeighbours = 16;
  std::vector<std::vector<std::uint32_t>> neighbours(scene.operands.size());
  for (const auto& [a, b] : scene.operand_pairs) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  std::vector<std::vector<PointId>> candidates(scene.operands.size());
  for_each_in_parallel(scene.operands.size(), [&](std::size_t o) {
    const ExactMesh& mesh = *scene.operands[o];
    const bool all = !mesh.contacts.empty() || neighbours[o].size() > kManyNeighbours;
    const auto collect = [&](std::size_t i, std::vector<PointId>& found) {
      const auto holds = [&](std::uint32_t other) {
        return scene.bounds[other].contains(mesh.points[i]);
      };
      if (all || std::any_of(neighbours[o].begin(), neighbours[o].end(), holds)) {
        found.push_back(scene.point_of(o, static_cast<std::uint32_t>(i)));
      }
    };
    candidates[o] = collect_in_order<PointId>(mesh.points.size(), collect);
  });
  return joined(std::move(candidates));
}

// Drops points whose hash no other has, by a table far smaller than the points: in two bits per
// slot, whether there is one, and whether there are more.
void keep_possible_twins(const PointTable& points, std::vector<PointId>& ids) {
  const std::size_t slots = std::bit_ceil(4 * ids.size() + 4);
  std::vector<std::uint8_t> seen(slots / 4, 0);
  const auto slot = [&](std::size_t i) {
    return hash_of(points.coordinates(ids[i])) & (slots - 1);
  };
  const auto one = [](std::size_t s) { return static_cast<std::uint8_t>(1u << s % 4 * 2); };
  const auto more = [](std::size_t s) { return static_cast<std::uint8_t>(2u << s % 4 * 2); };
  for_each_block(ids.size(), [&](const Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const std::size_t s = slot(i);
      const std::atomic_ref bits(seen[s / 4]);
      if ((bits.fetch_or(one(s), std::memory_order_relaxed) & one(s)) != 0) {
        bits.fetch_or(more(s), std::memory_order_relaxed);
      }
    }
  });
  ids = collect_in_order<PointId>(ids.size(), [&](std::size_t i, std::vector<PointId>& kept) {
    if (const std::size_t s = slot(i); (seen[s / 4] & more(s)) != 0) {
      kept.push_back(ids[i]);
    }
  });
}

class Welder {
 public:
  explicit Welder(Scene& scene) : scene_(scene) {
    scene.special.assign(scene.points.size(), 0);
    // Points of planes are corners of no triangle.
    std::fill(scene.special.begin() + scene.first_double.back(),
              scene.special.begin() + scene.points.double_count(), std::uint8_t{1});
  }

  void weld() {
    doubles_ = shared_candidates(scene_);
    if (scene_.points.size() > scene_.points.double_count()) {
      const auto is_double = [this](PointId id) { return scene_.points.is_double(id); };
      const auto first = std::stable_partition(doubles_.begin(), doubles_.end(), is_double);
      implicit_.assign(first, doubles_.end());
      doubles_.erase(first, doubles_.end());
    }
    weld_doubles();
    weld_implicit();
    if (!first_.empty()) {
      renumber(scene_.triangles);
      renumber(scene_.supports);
    }
  }

 private:
  void join(PointId id, PointId first) {
    if (id == first) {
      return;
    }
    if (first_.empty()) {
      first_.resize(scene_.points.size());
      std::iota(first_.begin(), first_.end(), 0u);
    }
    first_[id] = first;
    scene_.special[first] = scene_.special[id] = 1;
  }
  void renumber(BulkVector<Triangle>& triangles) const {
    for_each_block(triangles.size(), [&](const Block& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        for (PointId& corner : triangles[i]) {
          corner = first_[corner];
        }
      }
    });
  }
  void weld_doubles() {
    keep_possible_twins(scene_.points, doubles_);
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
  std::vector<PointId> doubles_, implicit_;  // that may have a twin
  std::vector<PointId> first_;               // of each point's place; empty while no two are one
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
  using Shared = std::pair<Triangle, std::uint32_t>;
  const auto collect = [&scene](std::size_t t, std::vector<Shared>& found) {
    Triangle corners = scene.triangles[t];
    if (scene.special[corners[0]] && scene.special[corners[1]] && scene.special[corners[2]]) {
      std::sort(corners.begin(), corners.end());
      found.emplace_back(corners, static_cast<std::uint32_t>(t));
    }
  };
  std::vector<Shared> shared = collect_in_order<Shared>(scene.triangles.size(), collect);
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

std::uint32_t Scene::operand_of_point(PointId point) const {
  const std::vector<PointId>& first = points.is_double(point) ? first_double : first_implicit;
  return static_cast<std::uint32_t>(std::upper_bound(first.begin(), first.end(), point) -
                                    first.begin() - 1);
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
  find_operand_pairs(scene);
  Welder(scene).weld();
  mark_repeated_edges(scene);
  merge_coincident_triangles(scene, rule);
  return scene;
}

}  // namespace dupin::detail
