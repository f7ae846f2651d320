#include "incidences.h"

#include <algorithm>
#include <atomic>

#include "../disjoint_sets.h"
#include "names.h"
#include "predicates.h"
#include "sort_by_key.h"

namespace dupin::detail {
namespace {

// One id per place.
class Representatives {
 public:
  Representatives(Scene& scene, const Names& names, PlaceIndex& places)
      : base_(names.first_new_point) {
    for (const PointId id : names.corners) {
      places.first_at_place_of(id);
    }
    for (PointId id = base_; id < scene.points.size(); ++id) {
      first_.push_back(places.first_at_place_of(id));
    }
  }
  PointId operator()(PointId id) const {
    return id < base_ || id == kNone ? id : first_[id - base_];
  }

 private:
  PointId base_;
  std::vector<PointId> first_;
};

// Hands encounters to the triangles and edges they lie on.
class Distributor {
 public:
  Distributor(const Scene& scene, std::vector<std::uint8_t>& touched)
      : scene_(scene), touched_(touched) {}

  void distribute(const Encounter& encounter, PointId from, PointId to) {
    if (encounter.kind == Encounter::Kind::overlap) {
      touch(encounter.first);
      touch(encounter.second);
      return;
    }
    const auto hand = [&](std::uint32_t triangle, std::uint32_t partner,
                          Feature Encounter::End::*feature) {
      const Feature at_from = encounter.ends[0].*feature, at_to = encounter.ends[1].*feature;
      point(triangle, at_from, from);
      if (encounter.kind == Encounter::Kind::segment) {
        point(triangle, at_to, to);
        if (from != to && !on_common_edge(at_from, at_to)) {
          segments.push_back({triangle, from, to, partner});
          touch(triangle);
        }
      }
    };
    hand(encounter.first, encounter.second, &Encounter::End::on_first);
    hand(encounter.second, encounter.first, &Encounter::End::on_second);
  }

  std::vector<Incidences::OnEdge> on_edges;
  std::vector<Incidences::Inside> insides;
  std::vector<Incidences::Segment> segments;

 private:
  void touch(std::uint32_t triangle) {
    std::atomic_ref(touched_[triangle]).store(1, std::memory_order_relaxed);
  }
  void point(std::uint32_t triangle, Feature feature, PointId id) {
    if (is_edge(feature)) {
      on_edges.push_back({edge_of(scene_.triangles[triangle], feature), id});
      touch(triangle);
    } else if (feature == kInside) {
      insides.push_back({triangle, id});
      touch(triangle);
    }
  }

  const Scene& scene_;
  std::vector<std::uint8_t>& touched_;
};

void distribute(const Scene& scene, std::span<const Encounter> encounters, const Names& names,
                const Representatives& representative, Incidences& result) {
  result.touched.assign(scene.triangles.size(), 0);
  std::vector<Distributor> parts(block_count(encounters.size()),
                                 Distributor(scene, result.touched));
  for_each_block(encounters.size(), [&](const Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      parts[block.number].distribute(encounters[i], representative(names.ends[2 * i]),
                                     representative(names.ends[2 * i + 1]));
    }
  });
  for (const Distributor& part : parts) {
    result.on_edges.insert(result.on_edges.end(), part.on_edges.begin(), part.on_edges.end());
    result.insides.insert(result.insides.end(), part.insides.begin(), part.insides.end());
    result.segments.insert(result.segments.end(), part.segments.begin(), part.segments.end());
  }
}

// The sign of q - p along some axis on which they differ, and the axis.
struct Direction {
  int axis = 0, sign = 0;
};
Direction direction_of(const PointTable& points, EdgeKey edge) {
  const PointId p = lower_end(edge), q = upper_end(edge);
  const Vec3 step = (points.approximation(q) - points.approximation(p)).cwiseAbs();
  int axis = 0;
  step.maxCoeff(&axis);
  for (int k = 0; k < 3; ++k, axis = (axis + 1) % 3) {
    if (const int sign = compare(points, q, p, axis); sign != 0) {
      return {axis, sign};
    }
  }
  return {};
}

// The ends of the edges are all below `first_new_point`.
void sort_along_edges(const PointTable& points, PointId first_new_point,
                      std::vector<Incidences::OnEdge>& on_edges) {
  using OnEdge = Incidences::OnEdge;
  sort_by_key(
      on_edges, first_new_point, [](const OnEdge& p) { return lower_end(p.edge); },
      [](const OnEdge& a, const OnEdge& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.point < b.point;
      });
  const auto same = [](const OnEdge& a, const OnEdge& b) {
    return a.edge == b.edge && a.point == b.point;
  };
  on_edges.erase(std::unique(on_edges.begin(), on_edges.end(), same), on_edges.end());
  const std::vector<Run> edges = runs_of_equal(on_edges, [](const OnEdge& p) { return p.edge; });
  const auto sort_runs = [&](const Block& block) {
    const UpwardRounding rounding;
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const auto [begin, end] = edges[i];
      if (end - begin > 1) {
        const Direction direction = direction_of(points, on_edges[begin].edge);
        std::sort(on_edges.begin() + begin, on_edges.begin() + end,
                  [&](const OnEdge& a, const OnEdge& b) {
                    return direction.sign * compare(points, a.point, b.point, direction.axis) < 0;
                  });
      }
    }
  };
  constexpr std::size_t kFewEdges = 256;
  for_each_block(edges.size(), sort_runs, kFewEdges);
}

// Classes of triangles that overlap in a common plane, and every other touched triangle alone.
void group_faces(std::span<const Encounter> encounters, Incidences& result) {
  std::vector<std::uint32_t> overlapping;
  for (const Encounter& e : encounters) {
    if (e.kind == Encounter::Kind::overlap) {
      overlapping.insert(overlapping.end(), {e.first, e.second});
    }
  }
  std::sort(overlapping.begin(), overlapping.end());
  overlapping.erase(std::unique(overlapping.begin(), overlapping.end()), overlapping.end());
  DisjointSets classes(overlapping.size());
  const auto index = [&overlapping](std::uint32_t triangle) {
    return static_cast<std::uint32_t>(
        std::lower_bound(overlapping.begin(), overlapping.end(), triangle) - overlapping.begin());
  };
  for (const Encounter& e : encounters) {
    if (e.kind == Encounter::Kind::overlap) {
      classes.unite(index(e.first), index(e.second));
    }
  }
  std::vector<std::vector<std::uint32_t>>& faces = result.overlapping;
  std::vector<std::uint32_t> face_of(overlapping.size(), kNone);
  for (std::uint32_t i = 0; i < overlapping.size(); ++i) {
    std::uint32_t& face = face_of[classes.find(i)];
    if (face == kNone) {
      face = static_cast<std::uint32_t>(faces.size());
      faces.emplace_back();
    }
    faces[face].push_back(overlapping[i]);
  }
  const auto collect = [&](std::size_t i, std::vector<std::uint32_t>& found) {
    const auto t = static_cast<std::uint32_t>(i);
    if (result.touched[t] && !std::binary_search(overlapping.begin(), overlapping.end(), t)) {
      found.push_back(t);
    }
  };
  result.alone = collect_in_order<std::uint32_t>(result.touched.size(), collect);
}

template <class Item>
void sort_by_triangle(const Scene& scene, std::vector<Item>& items) {
  sort_by_key(
      items, static_cast<std::uint32_t>(scene.triangles.size()),
      [](const Item& item) { return item.triangle; },
      [](const Item& a, const Item& b) { return a.triangle < b.triangle; });
}

template <class Item>
std::span<const Item> of_triangle(const std::vector<Item>& items, std::uint32_t triangle) {
  const auto begin =
      std::lower_bound(items.begin(), items.end(), triangle,
                       [](const Item& item, std::uint32_t t) { return item.triangle < t; });
  const auto end = std::find_if(begin, items.end(),
                                [triangle](const Item& i) { return i.triangle != triangle; });
  return {begin, end};
}

}  // namespace

std::span<const Incidences::OnEdge> Incidences::on_edge(EdgeKey edge) const {
  const auto begin = std::lower_bound(on_edges.begin(), on_edges.end(), edge,
                                      [](const OnEdge& p, EdgeKey key) { return p.edge < key; });
  const auto end =
      std::find_if(begin, on_edges.end(), [edge](const OnEdge& p) { return p.edge != edge; });
  return {begin, end};
}

std::span<const Incidences::Inside> Incidences::inside(std::uint32_t triangle) const {
  return of_triangle(insides, triangle);
}

std::span<const Incidences::Segment> Incidences::segments_of(std::uint32_t triangle) const {
  return of_triangle(segments, triangle);
}

Incidences gather(Scene& scene, std::span<const Encounter> encounters) {
  Incidences result;
  const Names names = name_points(scene, encounters);
  result.places.emplace(scene.points, scene.extent, scene.points.size() - names.first_new_point);
  const Representatives representative(scene, names, *result.places);
  distribute(scene, encounters, names, representative, result);
  scene.special.resize(scene.points.size(), 1);
  for (const PointId id : names.corners) {
    scene.special[id] = 1;
  }
  sort_along_edges(scene.points, names.first_new_point, result.on_edges);
  sort_by_triangle(scene, result.insides);
  sort_by_triangle(scene, result.segments);
  group_faces(encounters, result);
  return result;
}

}  // namespace dupin::detail
