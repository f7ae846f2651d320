#include "faces.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "predicates.h"
#include "triangulation.h"
#include "winding_change.h"

namespace dupin::detail {
namespace {

// The result for one face, its own new points numbered from kNewPoint.
struct FacePieces {
  Pieces local;
  std::vector<Triangulation::NewPoint> new_points;
};

class FaceTriangulator {
 public:
  FaceTriangulator(const Scene& scene, const Incidences& incidences,
                   std::span<const std::uint32_t> members)
      : scene_(scene),
        incidences_(incidences),
        members_(members),
        projection_(projection_of(scene.points, scene.support(members[0]))),
        triangulation_(scene.points, projection_, caller()) {}

  FacePieces run(const BooleanRule& rule) {
    collect_points();
    if (members_.size() == 1) {
      start_from_triangle();
    } else {
      start_from_frame();
    }
    for (const std::uint32_t t : members_) {
      for (const Incidences::Segment& s : incidences_.segments_of(t)) {
        slots_.push_back({s.partner, {}});
        triangulation_.constrain(vertex(s.from), vertex(s.to), last_slot());
      }
    }
    triangulation_.improve(scene_.support(members_[0]));
    find_regions();
    return emit(rule);
  }

 private:
  struct Slot {
    std::uint32_t partner;                ///< a triangle whose plane holds the line, or kNone
    std::vector<std::uint32_t> bounding;  ///< members of which it is an edge
  };

  Triangulation::Caller caller() {
    return {[this](std::uint32_t a, std::uint32_t b) { return crossing(a, b); },
            [this](std::uint32_t a, std::uint32_t b) { return both(a, b); }};
  }

  Definition crossing(std::uint32_t a, std::uint32_t b) const {
    std::array<std::uint32_t, 3> planes{members_[0], slots_[a].partner, slots_[b].partner};
    std::sort(planes.begin(), planes.end());
    Definition definition{Definition::Kind::three_planes, 0, {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const Triangle& support = scene_.support(planes[i]);
      std::copy(support.begin(), support.end(), definition.of.begin() + static_cast<long>(3 * i));
    }
    return definition;
  }

  std::uint32_t both(std::uint32_t present, std::uint32_t added) {
    if (slots_[added].bounding.empty() && slots_[present].partner != kNone) {
      return present;
    }
    Slot slot{std::min(slots_[present].partner, slots_[added].partner), slots_[present].bounding};
    slot.bounding.insert(slot.bounding.end(), slots_[added].bounding.begin(),
                         slots_[added].bounding.end());
    slots_.push_back(std::move(slot));
    return last_slot();
  }

  [[nodiscard]] std::uint32_t last_slot() const {
    return static_cast<std::uint32_t>(slots_.size() - 1);
  }

  [[nodiscard]] EdgeKey edge(std::uint32_t t, std::size_t i) const {
    const Triangle& corners = scene_.triangles[t];
    return edge_key(corners[i], corners[(i + 1) % 3]);
  }

  void collect_points() {
    for (const std::uint32_t t : members_) {
      const Triangle& corners = scene_.triangles[t];
      ids_.insert(ids_.end(), corners.begin(), corners.end());
      for (std::size_t i = 0; i < 3; ++i) {
        for (const auto& p : incidences_.on_edge(edge(t, i))) {
          ids_.push_back(p.point);
        }
      }
      for (const auto& p : incidences_.inside(t)) {
        ids_.push_back(p.point);
      }
      for (const auto& s : incidences_.segments_of(t)) {
        ids_.insert(ids_.end(), {s.from, s.to});
      }
    }
    std::sort(ids_.begin(), ids_.end());
    ids_.erase(std::unique(ids_.begin(), ids_.end()), ids_.end());
    vertices_.assign(ids_.size(), kNone);
  }

  Triangulation::Vertex& slot_of(PointId id) {
    const auto i = std::lower_bound(ids_.begin(), ids_.end(), id) - ids_.begin();
    return vertices_[static_cast<std::size_t>(i)];
  }
  Triangulation::Vertex vertex(PointId id) { return slot_of(id); }

  void place(PointId id, std::uint8_t sides) {
    Triangulation::Vertex& v = slot_of(id);
    if (v == kNone) {
      v = triangulation_.add(id, sides);
      triangulation_.insert(v);
    }
  }

  // The points on the triangle's edges are known to be collinear with its corners.
  void start_from_triangle() {
    const std::uint32_t t = members_[0];
    const Triangle& corners = scene_.triangles[t];
    std::array<Triangulation::Vertex, 3> v{};
    for (std::size_t i = 0; i < 3; ++i) {
      v[i] = slot_of(corners[i]) = triangulation_.add(
          corners[i], static_cast<std::uint8_t>((1u << i) | (1u << ((i + 2) % 3))));
    }
    triangulation_.start(v[0], v[1], v[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      for (const auto& p : incidences_.on_edge(edge(t, i))) {
        place(p.point, static_cast<std::uint8_t>(1u << i));
      }
    }
    place_remaining();
  }

  void place_remaining() {
    for (const std::uint32_t t : members_) {
      for (const auto& s : incidences_.segments_of(t)) {
        place(s.from, 0);
        place(s.to, 0);
      }
      for (const auto& p : incidences_.inside(t)) {
        place(p.point, 0);
      }
    }
  }

  // Several triangles: a triangle around them all, and their edges as constraints.
  void start_from_frame() {
    const int u = (projection_.axis + 1) % 3, v = (projection_.axis + 2) % 3;
    Eigen::AlignedBox2d box;
    for (const PointId id : ids_) {
      const Vec3 p = scene_.points.approximation(id);
      box.extend(Eigen::Vector2d(p[u], p[v]));
    }
    const Eigen::Vector2d center = box.center();
    const double size = 2 * box.diagonal().norm();
    const double high = projection_.orientation > 0 ? size : -size;
    const auto a = triangulation_.add_frame_corner(center[0] - 2 * size, center[1] - high);
    const auto b = triangulation_.add_frame_corner(center[0] + 2 * size, center[1] - high);
    const auto c = triangulation_.add_frame_corner(center[0], center[1] + 2 * high);
    triangulation_.start(a, b, c);
    for (const std::uint32_t t : members_) {
      for (const PointId id : scene_.triangles[t]) {
        place(id, 0);
      }
      for (std::size_t i = 0; i < 3; ++i) {
        for (const auto& p : incidences_.on_edge(edge(t, i))) {
          place(p.point, 0);
        }
      }
    }
    place_remaining();
    for (const std::uint32_t t : members_) {
      constrain_edges(t);
    }
  }

  void constrain_edges(std::uint32_t t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const EdgeKey key = edge(t, i);
      slots_.push_back({kNone, {t}});
      const std::uint32_t slot = last_slot();
      PointId from = lower_end(key);
      for (const auto& p : incidences_.on_edge(key)) {
        triangulation_.constrain(vertex(from), vertex(p.point), slot);
        from = p.point;
      }
      triangulation_.constrain(vertex(from), vertex(upper_end(key)), slot);
    }
  }

  // The parts of the face that no constraint divides.
  void find_regions() {
    const auto& faces = triangulation_.faces();
    region_of_.assign(faces.size(), kNone);
    for (std::uint32_t seed = 0; seed < faces.size(); ++seed) {
      if (region_of_[seed] != kNone) {
        continue;
      }
      const auto region = static_cast<std::uint32_t>(first_in_region_.size());
      first_in_region_.push_back(static_cast<std::uint32_t>(in_order_.size()));
      region_of_[seed] = region;
      in_order_.push_back(seed);
      for (std::size_t i = in_order_.size() - 1; i < in_order_.size(); ++i) {
        const Triangulation::Face& face = faces[in_order_[i]];
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t n = face.neighbours[k];
          if (n != kNone && face.slots[k] == kNone && region_of_[n] == kNone) {
            region_of_[n] = region;
            in_order_.push_back(n);
          }
        }
      }
    }
    first_in_region_.push_back(static_cast<std::uint32_t>(in_order_.size()));
  }

  // Which members cover each region, ascending. Crossing a member's edge enters or leaves it.
  std::vector<std::vector<std::uint32_t>> find_covers() const {
    std::vector<std::vector<std::uint32_t>> covers(first_in_region_.size() - 1);
    if (members_.size() == 1) {
      covers.assign(covers.size(), {members_[0]});
      return covers;
    }
    const auto& faces = triangulation_.faces();
    std::vector<std::uint32_t> queue{region_of_[face_at_frame()]};
    std::vector<std::uint8_t> known(covers.size(), 0);
    known[queue[0]] = 1;
    for (std::size_t q = 0; q < queue.size(); ++q) {
      const std::uint32_t region = queue[q];
      for (std::uint32_t i = first_in_region_[region]; i < first_in_region_[region + 1]; ++i) {
        const Triangulation::Face& face = faces[in_order_[i]];
        for (std::size_t k = 0; k < 3; ++k) {
          if (face.slots[k] == kNone || face.neighbours[k] == kNone) {
            continue;
          }
          const std::uint32_t other = region_of_[face.neighbours[k]];
          if (!known[other]) {
            known[other] = 1;
            covers[other] = toggled(covers[region], slots_[face.slots[k]].bounding);
            queue.push_back(other);
          }
        }
      }
    }
    return covers;
  }

  static std::vector<std::uint32_t> toggled(std::vector<std::uint32_t> cover,
                                            const std::vector<std::uint32_t>& members) {
    for (const std::uint32_t t : members) {
      const auto place = std::lower_bound(cover.begin(), cover.end(), t);
      if (place != cover.end() && *place == t) {
        cover.erase(place);
      } else {
        cover.insert(place, t);
      }
    }
    return cover;
  }

  [[nodiscard]] std::uint32_t face_at_frame() const {
    const auto& faces = triangulation_.faces();
    const auto at_frame = [this](const Triangulation::Face& face) {
      return std::any_of(face.corners.begin(), face.corners.end(), [this](auto v) {
        return triangulation_.point(v) >= Triangulation::kFirstFrameCorner;
      });
    };
    return static_cast<std::uint32_t>(std::find_if(faces.begin(), faces.end(), at_frame) -
                                      faces.begin());
  }

  FacePieces emit(const BooleanRule& rule) {
    FacePieces result;
    const auto& faces = triangulation_.faces();
    const std::vector<std::vector<std::uint32_t>> covers = find_covers();
    for (std::uint32_t region = 0; region < covers.size(); ++region) {
      std::vector<SignedTriangle> cover = signed_cover(covers[region]);
      if (changes_nothing(winding_change(scene_, rule, cover))) {
        continue;
      }
      Pieces& local = result.local;
      const auto number = static_cast<std::uint32_t>(local.regions.size());
      const auto first = static_cast<std::uint32_t>(local.covers.size());
      // A region of one triangle takes its orientation: it may be joined to others around a corner.
      const bool reversed = covers[region].size() == 1 && cover.front().sign < 0;
      for (SignedTriangle& t : cover) {
        t.sign = reversed ? -t.sign : t.sign;
      }
      local.covers.insert(local.covers.end(), cover.begin(), cover.end());
      local.regions.push_back({first, static_cast<std::uint32_t>(local.covers.size()),
                               reversed ? covers[region][0] : members_[0]});
      for (std::uint32_t i = first_in_region_[region]; i < first_in_region_[region + 1]; ++i) {
        const Triangulation::Face& face = faces[in_order_[i]];
        Pieces::Piece piece{{}, number, 0};
        for (std::size_t k = 0; k < 3; ++k) {
          piece.corners[k] = triangulation_.point(face.corners[k]);
          if (face.neighbours[k] == kNone || face.slots[k] != kNone) {
            piece.open = static_cast<std::uint8_t>(piece.open | (1u << k));
          }
        }
        if (reversed) {
          std::swap(piece.corners[1], piece.corners[2]);
          piece.open = static_cast<std::uint8_t>((piece.open & 1u) | (piece.open & 2u) << 1 |
                                                 (piece.open & 4u) >> 1);
        }
        local.pieces.push_back(piece);
      }
    }
    result.new_points = std::move(triangulation_.new_points());
    return result;
  }

  [[nodiscard]] std::vector<SignedTriangle> signed_cover(
      const std::vector<std::uint32_t>& members) const {
    std::vector<SignedTriangle> cover;
    for (const std::uint32_t t : members) {
      int sign = 1;
      if (t != members_[0]) {
        const Triangle& s = scene_.support(t);
        sign = projection_.orientation * turn(scene_.points, s[0], s[1], s[2], projection_.axis);
      }
      for (const SignedTriangle& c : scene_.cover(t)) {
        cover.push_back({c.triangle, sign * c.sign});
      }
    }
    std::sort(cover.begin(), cover.end(),
              [](const auto& a, const auto& b) { return a.triangle < b.triangle; });
    return cover;
  }

  const Scene& scene_;
  const Incidences& incidences_;
  std::span<const std::uint32_t> members_;
  Projection projection_;
  std::vector<Slot> slots_;
  Triangulation triangulation_;
  std::vector<PointId> ids_;
  std::vector<Triangulation::Vertex> vertices_;
  std::vector<std::uint32_t> region_of_;        // per face of the triangulation
  std::vector<std::uint32_t> in_order_;         // its faces by region
  std::vector<std::uint32_t> first_in_region_;  // and one past the last
};

// Puts the faces' results behind one another, in order.
class Collector {
 public:
  Collector(Scene& scene, PlaceIndex& places) : scene_(scene), places_(places) {}

  void append(FacePieces&& face) {
    std::vector<PointId> ids;
    for (Triangulation::NewPoint& point : face.new_points) {
      const PointId id = scene_.points.add(std::move(point));
      const PointId first = places_.first_at_place_of(id);
      if (first != id) {
        scene_.points.remove_last();
      }
      ids.push_back(first);
    }
    const auto first_region = static_cast<std::uint32_t>(result_.regions.size());
    const auto first_cover = static_cast<std::uint32_t>(result_.covers.size());
    for (Pieces::Piece piece : face.local.pieces) {
      for (PointId& id : piece.corners) {
        id = id < Triangulation::kNewPoint ? id : ids[id - Triangulation::kNewPoint];
      }
      piece.region += first_region;
      result_.pieces.push_back(piece);
    }
    for (Pieces::Region region : face.local.regions) {
      region.first_cover += first_cover;
      region.end_cover += first_cover;
      result_.regions.push_back(region);
    }
    result_.covers.insert(result_.covers.end(), face.local.covers.begin(), face.local.covers.end());
  }
  Pieces take() { return std::move(result_); }

 private:
  Scene& scene_;
  PlaceIndex& places_;
  Pieces result_;
};

}  // namespace

Pieces retriangulate(Scene& scene, const BooleanRule& rule, Incidences& incidences,
                     const Stage& stage) {
  std::vector<FacePieces> faces(incidences.faces.size());
  tbb::parallel_for(std::size_t{0}, faces.size(), [&](std::size_t i) {
    const UpwardRounding rounding;
    faces[i] = FaceTriangulator(scene, incidences, incidences.faces[i]).run(rule);
    stage.step(faces.size());
  });
  Collector collector(scene, *incidences.places);
  for (FacePieces& face : faces) {
    collector.append(std::move(face));
  }
  scene.special.resize(scene.points.size(), 1);
  return collector.take();
}

}  // namespace dupin::detail
