#include "arrangement/constraints.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <string>
#include <utility>

#include "arrangement/intersection_points.h"
#include "arrangement/points/implicit_predicates.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "support/disjoint_sets.h"
#include "support/sort_by_key.h"

namespace dupin::arrangement {
namespace {

// One id for all coincident points.
class Representatives {
 public:
  Representatives(ArrangementInput& input, const IntersectionPoints& points,
                  CoincidentPointIndex& coincident)
      : base_(points.first_new_point) {
    for (const PointId id : points.corners) {
      coincident.first_coincident(id);
    }
    coincident.tighten_wide(base_, input.points.size());
    for (PointId id = base_; id < input.points.size(); ++id) {
      first_.push_back(coincident.first_coincident(id));
    }
  }
  PointId operator()(PointId id) const {
    return id < base_ || id == kNone ? id : first_[id - base_];
  }

 private:
  PointId base_;
  std::vector<PointId> first_;
};

// Of what two facets have in common, what triangles of theirs have.
struct Piece {
  std::uint32_t first, second;         // facets
  std::array<PointId, 2> ends;         // kNone at joints
  bool divides_first, divides_second;  // else it runs along a side
  friend auto operator<=>(const Piece&, const Piece&) = default;
};

// Calls hand(triangle, feature, id) for what either triangle has of the ends of what they have in
// common, of which not all are known.
template <class Hand>
void hand_ends(const TriangleIntersection& intersection, PointId from, PointId to,
               const Hand& hand) {
  const auto& [first, second, kind, coplanar, axis, ends] = intersection;
  const std::array<PointId, 2> ids{from, to};
  const std::size_t count = kind == TriangleIntersection::Kind::overlap   ? 0
                            : kind == TriangleIntersection::Kind::segment ? 2
                                                                          : 1;
  for (std::size_t i = 0; i < count; ++i) {
    for (const auto& [triangle, feature] :
         {std::pair(first, ends[i].on_first), {second, ends[i].on_second}}) {
      if (ids[i] != kNone && !is_corner(feature)) {
        hand(triangle, feature, ids[i]);
      }
    }
  }
}

// Hands intersections to the facets they lie in.
class Distributor {
 public:
  Distributor(const ArrangementInput& input, Constraints& result)
      : input_(input), facets_(result.facets), sheets_(result.sheets), touched_(result.touched) {}

  void distribute(const TriangleIntersection& intersection, PointId from, PointId to) {
    const auto& [first, second, kind, coplanar, axis, ends] = intersection;
    if (kind == TriangleIntersection::Kind::overlap) {
      touch(first);
      touch(second);
      return;
    }
    hand_ends(intersection, from, to, [this](std::uint32_t triangle, Feature feature, PointId id) {
      if (facets_.is_inside(triangle, feature)) {
        insides.push_back({facets_.of(triangle), id});
      }
      touch(triangle);
    });
    if (kind != TriangleIntersection::Kind::segment) {
      return;
    }
    const bool divides_first = divides(first, common_edge(ends[0].on_first, ends[1].on_first));
    const bool divides_second = divides(second, common_edge(ends[0].on_second, ends[1].on_second));
    if (from == kNone || to == kNone) {
      pieces.push_back(
          {facets_.of(first), facets_.of(second), {from, to}, divides_first, divides_second});
      touch(first);
      touch(second);
    } else if (from != to) {
      if (divides_first) {
        divide(first, second, from, to);
      }
      if (divides_second) {
        divide(second, first, from, to);
      }
    }
  }

  std::vector<Constraints::Inside> insides;
  std::vector<Constraints::Segment> segments;
  std::vector<Piece> pieces;

 private:
  void touch(std::uint32_t triangle) {
    for (const std::uint32_t t : {triangle, facets_.mate(triangle)}) {
      if (t != kNone) {
        std::atomic_ref(touched_[t]).store(1, std::memory_order_relaxed);
      }
    }
  }
  // A segment along an edge where nothing else divides, or along none.
  [[nodiscard]] bool divides(std::uint32_t triangle, Feature along) const {
    return facets_.is_inside(triangle, along) ||
           (!sheets_.empty() && sheets_.at(edge_of(input_.triangles[triangle], along)) != nullptr);
  }
  void divide(std::uint32_t triangle, std::uint32_t partner, PointId from, PointId to) {
    segments.push_back({facets_.of(triangle), from, to, facets_.of(partner)});
    touch(triangle);
  }

  const ArrangementInput& input_;
  const FlatFacets& facets_;
  const FlatSheets& sheets_;
  std::vector<std::uint8_t>& touched_;
};

// The segments that two facets have in common, each made of pieces from joint to joint.
void join(const ArrangementInput& input, std::vector<Piece> pieces,
          std::vector<Constraints::Segment>& segments) {
  support::sort_by_key(
      pieces, static_cast<std::uint32_t>(input.triangles.size()),
      [](const Piece& piece) { return piece.first; }, std::less<>());
  for (std::size_t i = 0; i < pieces.size();) {
    const auto [first, second, ends, divides_first, divides_second] = pieces[i];
    std::vector<PointId> ids;
    for (; i < pieces.size() && pieces[i].first == first && pieces[i].second == second; ++i) {
      for (const PointId id : pieces[i].ends) {
        if (id != kNone && std::find(ids.begin(), ids.end(), id) == ids.end()) {
          ids.push_back(id);
        }
      }
    }
    if (ids.size() != 2) {
      throw Error(Errc::internal,
                  "internal error, please report it: two flat faces meet in a segment with " +
                      std::to_string(ids.size()) + " ends near " +
                      decimal(input.points.approximation(input.triangles[first][0])));
    }
    if (divides_first) {
      segments.push_back({first, ids[0], ids[1], second});
    }
    if (divides_second) {
      segments.push_back({second, ids[0], ids[1], first});
    }
  }
}

void distribute(const ArrangementInput& input, std::span<const TriangleIntersection> intersections,
                const IntersectionPoints& points, const Representatives& representative,
                Constraints& result) {
  result.touched.assign(input.triangles.size(), 0);
  std::vector<Distributor> parts(support::block_count(intersections.size()),
                                 Distributor(input, result));
  support::for_each_block(intersections.size(), [&](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      parts[block.number].distribute(intersections[i], representative(points.ends[2 * i]),
                                     representative(points.ends[2 * i + 1]));
    }
  });
  const auto joined = [&parts](auto list) {
    std::vector<std::remove_reference_t<decltype(parts.front().*list)>> lists;
    for (Distributor& part : parts) {
      lists.push_back(std::move(part.*list));
    }
    return support::joined(std::move(lists));
  };
  result.insides = joined(&Distributor::insides);
  result.segments = joined(&Distributor::segments);
  join(input, joined(&Distributor::pieces), result.segments);
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

// The points on sides, by edge and number. The ends of sides are all below the first new point.
support::BulkVector<Constraints::OnEdge> points_on_edges(
    const ArrangementInput& input, std::span<const TriangleIntersection> intersections,
    const IntersectionPoints& points, const Representatives& representative,
    const FlatFacets& facets) {
  using OnEdge = Constraints::OnEdge;
  const auto collect = [&](std::size_t i, const auto& found) {
    hand_ends(intersections[i], representative(points.ends[2 * i]),
              representative(points.ends[2 * i + 1]),
              [&](std::uint32_t triangle, Feature feature, PointId id) {
                if (!facets.is_inside(triangle, feature)) {
                  found(OnEdge{edge_of(input.triangles[triangle], feature), id});
                }
              });
  };
  support::BulkVector<OnEdge> on_edges = support::collect_by_key<OnEdge>(
      intersections.size(), collect, points.first_new_point,
      [](const OnEdge& p) { return lower_end(p.edge); },
      [](const OnEdge& a, const OnEdge& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.point < b.point;
      });
  const auto same = [](const OnEdge& a, const OnEdge& b) {
    return a.edge == b.edge && a.point == b.point;
  };
  on_edges.erase(std::unique(on_edges.begin(), on_edges.end(), same), on_edges.end());
  on_edges.shrink_to_fit();  // neighbouring faces have handed most of them in, too
  return on_edges;
}

void sort_along_edges(const PointTable& points,
                      support::BulkVector<Constraints::OnEdge>& on_edges) {
  using OnEdge = Constraints::OnEdge;
  const std::vector<support::IndexRange> edges =
      support::ranges_of_equal(on_edges, [](const OnEdge& p) { return p.edge; });
  const auto sort_runs = [&](const support::Block& block) {
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
  support::for_each_block(edges.size(), sort_runs, kFewEdges);
}

// Classes of facets that overlap in a common plane, and every other touched facet alone.
void group_faces(std::span<const TriangleIntersection> intersections, Constraints& result) {
  const FlatFacets& facets = result.facets;
  std::vector<std::uint32_t> number(result.touched.size(), kNone);
  for (const TriangleIntersection& e : intersections) {
    if (e.kind == TriangleIntersection::Kind::overlap) {
      number[facets.of(e.first)] = number[facets.of(e.second)] = 0;
    }
  }
  const std::vector<std::uint32_t> overlapping = support::indices_where(
      number.size(), [&number](std::size_t facet) { return number[facet] != kNone; });
  for (std::uint32_t i = 0; i < overlapping.size(); ++i) {
    number[overlapping[i]] = i;
  }
  support::DisjointSets classes(overlapping.size());
  for (const TriangleIntersection& e : intersections) {
    if (e.kind == TriangleIntersection::Kind::overlap) {
      classes.unite(number[facets.of(e.first)], number[facets.of(e.second)]);
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
  result.alone = support::indices_where(result.touched.size(), [&](std::uint32_t t) {
    return result.touched[t] && facets.of(t) == t && number[t] == kNone;
  });
}

template <class Item>
void sort_by_triangle(const ArrangementInput& input, std::vector<Item>& items) {
  support::sort_by_key(
      items, static_cast<std::uint32_t>(input.triangles.size()),
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

std::span<const Constraints::OnEdge> Constraints::on_edge(EdgeKey edge) const {
  const auto begin = std::lower_bound(on_edges.begin(), on_edges.end(), edge,
                                      [](const OnEdge& p, EdgeKey key) { return p.edge < key; });
  const auto end =
      std::find_if(begin, on_edges.end(), [edge](const OnEdge& p) { return p.edge != edge; });
  return {begin, end};
}

std::span<const Constraints::Inside> Constraints::inside(std::uint32_t triangle) const {
  return of_triangle(insides, triangle);
}

std::span<const Constraints::Segment> Constraints::segments_of(std::uint32_t triangle) const {
  return of_triangle(segments, triangle);
}

Constraints collect_constraints(ArrangementInput& input,
                                std::span<const TriangleIntersection> intersections,
                                std::span<const TrianglePair> crossed_sheets) {
  Constraints result;
  IntersectionPoints points = create_intersection_points(input, intersections, crossed_sheets);
  result.facets = std::move(points.facets);
  result.sheets = std::move(points.sheets);
  result.coincident_points.emplace(input.points, input.extent,
                                   input.points.size() - points.first_new_point);
  const Representatives representative(input, points, *result.coincident_points);
  distribute(input, intersections, points, representative, result);
  result.on_edges = points_on_edges(input, intersections, points, representative, result.facets);
  input.special.resize(input.points.size(), 1);
  for (const PointId id : points.corners) {
    input.special[id] = 1;
  }
  sort_along_edges(input.points, result.on_edges);
  sort_by_triangle(input, result.insides);
  sort_by_triangle(input, result.segments);
  group_faces(intersections, result);
  return result;
}

}  // namespace dupin::arrangement
