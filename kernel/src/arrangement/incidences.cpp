#include "incidences.h"

#include <algorithm>

#include "../disjoint_sets.h"
#include "key_numbering.h"
#include "predicates.h"
#include "sort_by_key.h"

namespace dupin::detail {
namespace {

EdgeKey edge_of(const Triangle& corners, Feature feature) {
  const std::size_t i = feature - 3u;
  return edge_key(corners[i], corners[(i + 1) % 3]);
}

// The lines of edges with implicit ends, by points of the scene that say less: the coordinates of
// new points then do not build on those of earlier ones.
class EdgeLines {
 public:
  explicit EdgeLines(const Scene& scene) : scene_(scene) {
    for (std::uint32_t t = 0; t < scene.supports.size(); ++t) {
      for (Feature f = 3; f < kInside; ++f) {
        const EdgeKey edge = edge_of(scene.triangles[t], f);
        if (!scene.points.is_double(lower_end(edge)) || !scene.points.is_double(upper_end(edge))) {
          sides_.push_back({edge, t});
        }
      }
    }
    std::sort(sides_.begin(), sides_.end());
  }

  /// The point where the edge meets a plane.
  [[nodiscard]] Definition piercing(EdgeKey edge, const Triangle& plane) const {
    auto side = std::lower_bound(sides_.begin(), sides_.end(), Side{edge, 0});
    if (side != sides_.end() && side->edge == edge) {
      const Triangle& first = scene_.support(side->triangle);
      for (++side; side != sides_.end() && side->edge == edge; ++side) {
        const Triangle& second = scene_.support(side->triangle);
        if (!coplanar(first, second)) {
          return {Definition::Kind::three_planes,
                  0,
                  {first[0], first[1], first[2], second[0], second[1], second[2], plane[0],
                   plane[1], plane[2]}};
        }
        if (const auto line = common_line(first, second, edge)) {
          return {Definition::Kind::line_plane,
                  0,
                  {(*line)[0], (*line)[1], plane[0], plane[1], plane[2]}};
        }
      }
    }
    return {Definition::Kind::line_plane,
            0,
            {lower_end(edge), upper_end(edge), plane[0], plane[1], plane[2]}};
  }

 private:
  struct Side {
    EdgeKey edge;
    std::uint32_t triangle;
    friend auto operator<=>(const Side&, const Side&) = default;
  };

  [[nodiscard]] bool coplanar(const Triangle& a, const Triangle& b) const {
    return std::all_of(b.begin(), b.end(), [&](PointId p) {
      return side_of_plane(scene_.points, a[0], a[1], a[2], p) == 0;
    });
  }

  // Two corners that the planes have in common, if the edge lies on their line.
  [[nodiscard]] std::optional<std::array<PointId, 2>> common_line(const Triangle& a,
                                                                  const Triangle& b,
                                                                  EdgeKey edge) const {
    std::vector<PointId> common;
    for (const PointId p : a) {
      const bool is_common = std::any_of(b.begin(), b.end(), [&](PointId q) {
        return scene_.points.is_double(p) && scene_.points.is_double(q) &&
               scene_.points.coordinates(p) == scene_.points.coordinates(q);
      });
      if (is_common) {
        common.push_back(p);
      }
    }
    if (common.size() != 2) {
      return std::nullopt;
    }
    const int axis = projection_of(scene_.points, a).axis;
    for (const PointId end : {lower_end(edge), upper_end(edge)}) {
      if (turn(scene_.points, common[0], common[1], end, axis) != 0) {
        return std::nullopt;
      }
    }
    return std::array<PointId, 2>{common[0], common[1]};
  }

  const Scene& scene_;
  std::vector<Side> sides_;
};

// Finds or makes the point at an end of an encounter.
class PointNamer {
 public:
  PointNamer(Scene& scene, std::size_t expected_count)
      : scene_(scene), lines_(scene), numbering_(expected_count), base_(scene.points.size()) {}

  PointId name(const Encounter& encounter, const Encounter::End& end) {
    const Triangle& first = scene_.triangles[encounter.first];
    const Triangle& second = scene_.triangles[encounter.second];
    if (is_corner(end.on_first)) {
      return corner(first[end.on_first]);
    }
    if (is_corner(end.on_second)) {
      return corner(second[end.on_second]);
    }
    if (is_edge(end.on_first) && is_edge(end.on_second)) {
      const EdgeKey e = edge_of(first, end.on_first), f = edge_of(second, end.on_second);
      return named({std::min(e, f), std::max(e, f)}, [&] {
        return encounter.coplanar  ? crossing(e, f, encounter.axis)
               : end.first_crosses ? piercing(e, encounter.second)
                                   : piercing(f, encounter.first);
      });
    }
    const bool first_pierces = is_edge(end.on_first);
    const EdgeKey edge =
        first_pierces ? edge_of(first, end.on_first) : edge_of(second, end.on_second);
    const std::uint32_t plane = first_pierces ? encounter.second : encounter.first;
    return named({edge, kPlane | plane}, [&] { return piercing(edge, plane); });
  }

  /// Corners met, in order of first use.
  [[nodiscard]] const std::vector<PointId>& corners() const { return corners_; }
  [[nodiscard]] PointId first_new_point() const { return base_; }

 private:
  static constexpr std::uint64_t kPlane = std::uint64_t{1} << 63;

  PointId corner(PointId id) {
    if (met_.size() <= id) {
      met_.resize(base_, 0);
    }
    if (!met_[id]) {
      met_[id] = 1;
      corners_.push_back(id);
    }
    return id;
  }
  template <class Define>
  PointId named(const KeyNumbering::Key& key, Define&& define) {
    const std::uint32_t known = numbering_.size();
    const std::uint32_t number = numbering_.number(key);
    if (number == known) {
      scene_.points.add(define());
    }
    return base_ + number;
  }
  Definition piercing(EdgeKey edge, std::uint32_t plane) const {
    return lines_.piercing(edge, scene_.support(plane));
  }
  static Definition crossing(EdgeKey e, EdgeKey f, std::uint8_t axis) {
    return {Definition::Kind::two_lines,
            axis,
            {lower_end(e), upper_end(e), lower_end(f), upper_end(f)}};
  }

  Scene& scene_;
  EdgeLines lines_;
  KeyNumbering numbering_;
  PointId base_;
  std::vector<std::uint8_t> met_;
  std::vector<PointId> corners_;
};

// One id per place.
class Representatives {
 public:
  Representatives(Scene& scene, const PointNamer& namer, PlaceIndex& places)
      : base_(namer.first_new_point()) {
    for (const PointId id : namer.corners()) {
      places.first_at_place_of(id);
    }
    for (PointId id = base_; id < scene.points.size(); ++id) {
      first_.push_back(places.first_at_place_of(id));
    }
  }
  PointId operator()(PointId id) const { return id < base_ ? id : first_[id - base_]; }

 private:
  PointId base_;
  std::vector<PointId> first_;
};

class Distributor {
 public:
  Distributor(const Scene& scene, Incidences& result) : scene_(scene), result_(result) {}

  void distribute(const Encounter& encounter, const std::array<PointId, 2>& ids) {
    const auto hand = [&](std::uint32_t triangle, std::uint32_t partner,
                          Feature Encounter::End::*feature) {
      const Feature from = encounter.ends[0].*feature, to = encounter.ends[1].*feature;
      point(triangle, from, ids[0]);
      if (encounter.kind == Encounter::Kind::segment) {
        point(triangle, to, ids[1]);
        if (ids[0] != ids[1] && !on_common_edge(from, to)) {
          result_.segments.push_back({triangle, ids[0], ids[1], partner});
          touch(triangle);
        }
      }
    };
    hand(encounter.first, encounter.second, &Encounter::End::on_first);
    hand(encounter.second, encounter.first, &Encounter::End::on_second);
  }

  void touch(std::uint32_t triangle) { result_.touched[triangle] = 1; }

 private:
  void point(std::uint32_t triangle, Feature feature, PointId id) {
    if (is_edge(feature)) {
      result_.on_edges.push_back({edge_of(scene_.triangles[triangle], feature), id});
      touch(triangle);
    } else if (feature == kInside) {
      result_.insides.push_back({triangle, id});
      touch(triangle);
    }
  }

  const Scene& scene_;
  Incidences& result_;
};

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

void sort_along_edges(const PointTable& points, std::vector<Incidences::OnEdge>& on_edges) {
  using OnEdge = Incidences::OnEdge;
  sort_by_key(
      on_edges, points.size(), [](const OnEdge& p) { return lower_end(p.edge); },
      [](const OnEdge& a, const OnEdge& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.point < b.point;
      });
  const auto same = [](const OnEdge& a, const OnEdge& b) {
    return a.edge == b.edge && a.point == b.point;
  };
  on_edges.erase(std::unique(on_edges.begin(), on_edges.end(), same), on_edges.end());
  const std::vector<Run> edges = runs_of_equal(on_edges, [](const OnEdge& p) { return p.edge; });
  for_each_block(edges.size(), [&](const Block& block) {
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
  });
}

// Classes of triangles that overlap in a common plane, and every other touched triangle alone.
std::vector<std::vector<std::uint32_t>> group_faces(const std::vector<std::uint8_t>& touched,
                                                    std::span<const Encounter> encounters) {
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
  std::vector<std::vector<std::uint32_t>> faces;
  std::vector<std::uint32_t> face_of(overlapping.size(), kNone);
  for (std::uint32_t i = 0; i < overlapping.size(); ++i) {
    std::uint32_t& face = face_of[classes.find(i)];
    if (face == kNone) {
      face = static_cast<std::uint32_t>(faces.size());
      faces.emplace_back();
    }
    faces[face].push_back(overlapping[i]);
  }
  for (std::uint32_t t = 0; t < touched.size(); ++t) {
    if (touched[t] && !std::binary_search(overlapping.begin(), overlapping.end(), t)) {
      faces.push_back({t});
    }
  }
  return faces;
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
  const auto [begin, end] =
      std::equal_range(on_edges.begin(), on_edges.end(), OnEdge{edge, 0},
                       [](const OnEdge& a, const OnEdge& b) { return a.edge < b.edge; });
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
  result.touched.assign(scene.triangles.size(), 0);
  PointNamer namer(scene, encounters.size());
  std::vector<std::array<PointId, 2>> names;
  names.reserve(encounters.size());
  for (const Encounter& e : encounters) {
    std::array<PointId, 2> ids{kNone, kNone};
    if (e.kind != Encounter::Kind::overlap) {
      ids[0] = namer.name(e, e.ends[0]);
      ids[1] = e.kind == Encounter::Kind::segment ? namer.name(e, e.ends[1]) : ids[0];
    }
    names.push_back(ids);
  }
  result.places.emplace(scene.points, scene.extent, scene.points.size() - namer.first_new_point());
  const Representatives representative(scene, namer, *result.places);
  Distributor distributor(scene, result);
  for (std::size_t i = 0; i < encounters.size(); ++i) {
    if (encounters[i].kind == Encounter::Kind::overlap) {
      distributor.touch(encounters[i].first);
      distributor.touch(encounters[i].second);
    } else {
      distributor.distribute(encounters[i],
                             {representative(names[i][0]), representative(names[i][1])});
    }
  }
  scene.special.resize(scene.points.size(), 1);
  for (const PointId id : namer.corners()) {
    scene.special[id] = 1;
  }
  sort_along_edges(scene.points, result.on_edges);
  sort_by_triangle(scene, result.insides);
  sort_by_triangle(scene, result.segments);
  result.faces = group_faces(result.touched, encounters);
  return result;
}

}  // namespace dupin::detail
