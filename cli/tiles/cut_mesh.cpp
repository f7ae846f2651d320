#include "tiles/cut_mesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gmpxx.h>

#include "dupin/kernel/error.h"
#include "dupin/kernel/triangulate_region.h"

namespace dupin::cli {
namespace {

/// Sides of the slab between both planes.
enum class Side : std::uint8_t { before, between, behind };

/// A corner of what is left of faces: a point of the mesh, or one of an edge in a plane.
struct Corner {
  std::uint32_t point = 0;  // of the result
  int plane = -1;           // 0: the first, 1: the second
};

/// Whether four points are in one plane, exactly.
bool are_coplanar(const std::array<Vec3, 4>& points) {
  using Exact = std::array<mpq_class, 3>;
  const auto exact = [&](std::size_t i) {
    const Vec3 &p = points.at(i), &q = points[0];
    return Exact{mpq_class(p.x()) - q.x(), mpq_class(p.y()) - q.y(), mpq_class(p.z()) - q.z()};
  };
  const Exact a = exact(1), b = exact(2), c = exact(3);
  const mpq_class volume = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                           a[2] * (b[0] * c[1] - b[1] * c[0]);
  return volume == 0;
}

class MeshCutter {
 public:
  MeshCutter(const TriMesh& mesh, int axis, const std::optional<PlaneCut>& from,
             const std::optional<PlaneCut>& to)
      : mesh_(mesh), axis_(axis), cuts_{from ? &*from : nullptr, to ? &*to : nullptr} {
    side_.reserve(mesh.points.size());
    for (const Vec3& point : mesh.points) {
      side_.push_back(side_of(point));
    }
    taken_.assign(mesh.points.size(), kNotTaken);
    result_.names = mesh.names;
    unlabelled_ = mesh.labels.empty() ? label(std::string()) : 0;
  }

  TriMesh run() {
    for (std::size_t face = 0; face < mesh_.triangles.size(); ++face) {
      if (is_crossed(mesh_.triangles[face])) {
        crossed_.push_back(static_cast<std::uint32_t>(face));
      } else if (side_[mesh_.triangles[face][0]] == Side::between) {
        Triangle corners = mesh_.triangles[face];
        std::ranges::transform(corners, corners.begin(), [&](auto point) { return taken(point); });
        append(corners, face);
      }
    }
    for (const std::vector<std::uint32_t>& facet : flat_facets()) {
      append_facet(facet);
    }
    for (int plane = 0; plane < 2; ++plane) {
      close(plane);
    }
    return std::move(result_);
  }

 private:
  static constexpr std::uint32_t kNotTaken = 0xffffffff;
  using Edge = std::pair<std::uint32_t, std::uint32_t>;  // the lower point first

  [[nodiscard]] Side side_of(const Vec3& point) const {
    for (const PlaneCut* cut : cuts_) {
      if (cut != nullptr && point[axis_] == cut->place) {
        throw Error(Errc::invalid_argument, "a point of the mesh is in the plane of a cut");
      }
    }
    if (cuts_[0] != nullptr && point[axis_] < cuts_[0]->place) {
      return Side::before;
    }
    return cuts_[1] != nullptr && point[axis_] > cuts_[1]->place ? Side::behind : Side::between;
  }

  std::uint32_t label(const std::string& name) {
    const auto found = std::ranges::find(result_.names, name);
    if (found == result_.names.end()) {
      result_.names.push_back(name);
      return static_cast<std::uint32_t>(result_.names.size() - 1);
    }
    return static_cast<std::uint32_t>(found - result_.names.begin());
  }

  [[nodiscard]] bool is_crossed(const Triangle& corners) const {
    return side_[corners[0]] != side_[corners[1]] || side_[corners[0]] != side_[corners[2]];
  }

  void append(const Triangle& corners, std::size_t of_face) {
    result_.triangles.push_back(corners);
    result_.labels.push_back(mesh_.labels.empty() ? unlabelled_ : mesh_.labels[of_face]);
  }

  /// Faces that planes run through, those together that share an edge that one does, have one label
  /// and are in one plane of their own: where such an edge meets the plane is no corner, and what
  /// is left of them stays as flat as it was.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> flat_facets() const {
    std::map<Edge, std::uint32_t> first;  // places in crossed_
    std::vector<std::vector<std::uint32_t>> neighbours(crossed_.size());
    for (std::uint32_t i = 0; i < crossed_.size(); ++i) {
      const Triangle& corners = mesh_.triangles[crossed_[i]];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = corners.at(k), b = corners.at((k + 1) % 3);
        if (side_[a] == side_[b]) {
          continue;
        }
        const auto [entry, is_new] = first.try_emplace(std::minmax(a, b), i);
        if (!is_new && are_flat(crossed_[entry->second], crossed_[i])) {
          neighbours[i].push_back(entry->second);
          neighbours[entry->second].push_back(i);
        }
      }
    }
    std::vector<std::vector<std::uint32_t>> facets;
    std::vector<bool> is_done(crossed_.size());
    for (std::uint32_t i = 0; i < crossed_.size(); ++i) {
      std::vector<std::uint32_t> open;
      const auto take = [&](std::uint32_t next) {
        if (!is_done[next]) {
          is_done[next] = true;
          facets.back().push_back(crossed_[next]);
          open.push_back(next);
        }
      };
      if (is_done[i]) {
        continue;
      }
      facets.emplace_back();
      for (take(i); !open.empty();) {
        const std::uint32_t next = open.back();
        open.pop_back();
        std::ranges::for_each(neighbours[next], take);
      }
    }
    return facets;
  }

  [[nodiscard]] bool are_flat(std::uint32_t face, std::uint32_t other) const {
    if (!mesh_.labels.empty() && mesh_.labels[face] != mesh_.labels[other]) {
      return false;
    }
    const auto& [a, b, c] = mesh_.triangles[face];
    const Triangle& corners = mesh_.triangles[other];
    const auto apex =
        std::ranges::find_if(corners, [&, own = mesh_.triangles[face]](std::uint32_t corner) {
          return std::ranges::find(own, corner) == own.end();
        });
    return apex != corners.end() &&
           are_coplanar({mesh_.points[a], mesh_.points[b], mesh_.points[c], mesh_.points[*apex]});
  }

  void append_facet(const std::vector<std::uint32_t>& faces) {
    std::set<std::array<std::uint32_t, 2>> border;
    for (const std::uint32_t face : faces) {
      const Triangle& corners = mesh_.triangles[face];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = corners.at(k), b = corners.at((k + 1) % 3);
        if (border.erase({b, a}) == 0) {
          border.insert({a, b});
        }
      }
    }
    std::map<std::uint32_t, std::uint32_t> next;
    std::array<std::vector<std::uint32_t>, 2> in_planes;
    for (const auto& [a, b] : border) {
      const std::vector<Corner> left = left_of(a, b);
      for (std::size_t i = 0; i + 1 < left.size(); ++i) {
        link(left[i].point, left[i + 1].point, next);
      }
      for (const Corner& corner : left) {
        if (corner.plane >= 0) {
          in_planes.at(std::size_t(corner.plane)).push_back(corner.point);
        }
      }
    }
    for (std::size_t plane = 0; plane < 2; ++plane) {
      join_in_plane(in_planes.at(plane), next, sides_.at(plane));
    }
    triangulate(polygons_of(std::move(next)), faces.front());
  }

  /// What is left of an edge of a face, which begins and ends at corners.
  std::vector<Corner> left_of(std::uint32_t a, std::uint32_t b) {
    std::vector<Corner> result;
    if (side_[a] == Side::between) {
      result.push_back({taken(a)});
    }
    const bool ascends = side_[a] < side_[b];
    for (int k = 0; k < 2; ++k) {
      const int plane = ascends ? k : 1 - k;  // in the order in which it runs through them
      const Side beyond = plane == 0 ? Side::before : Side::behind;
      if ((side_[a] == beyond) != (side_[b] == beyond)) {
        result.push_back({in_plane(a, b, plane), plane});
      }
    }
    if (side_[b] == Side::between) {
      result.push_back({taken(b)});
    }
    return result;
  }

  static void link(std::uint32_t from, std::uint32_t to,
                   std::map<std::uint32_t, std::uint32_t>& next) {
    if (!next.emplace(from, to).second) {
      throw Error(Errc::invalid_argument, "a face of a mesh that is cut touches itself");
    }
  }

  /// Where a facet's border leaves it in a plane it goes on to where it comes back, which is next
  /// to it along the line in which both planes meet.
  void join_in_plane(std::vector<std::uint32_t>& points,
                     std::map<std::uint32_t, std::uint32_t>& next,
                     std::vector<std::pair<std::uint32_t, std::uint32_t>>& sides) const {
    Eigen::AlignedBox3d box;
    for (const std::uint32_t point : points) {
      box.extend(result_.points[point]);
    }
    int along = 0;
    box.sizes().maxCoeff(&along);
    std::ranges::sort(points, {},
                      [&](std::uint32_t point) { return result_.points[point][along]; });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> joined;
    for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
      const bool is_turned = next.contains(points[i]);
      joined.emplace_back(points[i + (is_turned ? 1 : 0)], points[i + (is_turned ? 0 : 1)]);
    }
    for (const auto& [from, to] : joined) {
      link(from, to, next);
      sides.emplace_back(to, from);
    }
  }

  static std::vector<std::vector<std::uint32_t>> polygons_of(
      std::map<std::uint32_t, std::uint32_t> next) {
    std::vector<std::vector<std::uint32_t>> polygons;
    while (!next.empty()) {
      std::vector<std::uint32_t>& polygon = polygons.emplace_back();
      for (auto side = next.begin(); side != next.end(); side = next.find(polygon.back())) {
        polygon.push_back(side->second);
        next.erase(side);
      }
      if (polygon.size() < 3) {
        throw Error(Errc::invalid_argument, "a mesh that is cut is not closed");
      }
    }
    return polygons;
  }

  /// What is left of a facet, seen from where it looks largest.
  void triangulate(const std::vector<std::vector<std::uint32_t>>& polygons, std::uint32_t face) {
    if (polygons.size() == 1 && polygons[0].size() == 3) {
      append({polygons[0][0], polygons[0][1], polygons[0][2]}, face);
      return;
    }
    const auto& [a, b, c] = mesh_.triangles[face];
    const Vec3 normal =
        (mesh_.points[b] - mesh_.points[a]).cross(mesh_.points[c] - mesh_.points[a]);
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    std::vector<std::uint32_t> points;
    std::vector<std::vector<std::uint32_t>> own = polygons;
    for (std::vector<std::uint32_t>& polygon : own) {
      for (std::uint32_t& corner : polygon) {
        points.push_back(corner);
        corner = static_cast<std::uint32_t>(points.size() - 1);
      }
    }
    for (auto [u, v, w] : region(points, axis, own)) {
      if (normal[axis] < 0) {
        std::swap(v, w);
      }
      append({points[u], points[v], points[w]}, face);
    }
  }

  /// Counter-clockwise about an axis of coordinates.
  [[nodiscard]] std::vector<Triangle> region(
      std::span<const std::uint32_t> points, int axis,
      const std::vector<std::vector<std::uint32_t>>& polygons) const {
    std::vector<Vec2> places;
    for (const std::uint32_t point : points) {
      const Vec3& place = result_.points[point];
      places.emplace_back(place[(axis + 1) % 3], place[(axis + 2) % 3]);
    }
    try {
      return triangulate_region(places, polygons);
    } catch (const Error& error) {
      throw Error(Errc::invalid_argument, "where a mesh is cut, " + error.message());
    }
  }

  std::uint32_t taken(std::uint32_t point) {
    if (taken_[point] == kNotTaken) {
      taken_[point] = static_cast<std::uint32_t>(result_.points.size());
      result_.points.push_back(mesh_.points[point]);
    }
    return taken_[point];
  }

  // The same whichever way round the edge is asked for.
  std::uint32_t in_plane(std::uint32_t a, std::uint32_t b, int plane) {
    const auto [entry, is_new] = known_.try_emplace(
        {std::min(a, b), std::max(a, b), plane}, static_cast<std::uint32_t>(result_.points.size()));
    if (is_new) {
      const double place = cuts_.at(std::size_t(plane))->place;
      const Vec3 *low = &mesh_.points[a], *high = &mesh_.points[b];
      if ((*low)[axis_] > (*high)[axis_]) {
        std::swap(low, high);
      }
      Vec3 point =
          *low + (place - (*low)[axis_]) / ((*high)[axis_] - (*low)[axis_]) * (*high - *low);
      point[axis_] = place;
      result_.points.push_back(point);
    }
    return entry->second;
  }

  /// Both sides of the plane have its points in the same order, and the same polygons.
  void close(int plane) {
    const auto& sides = sides_.at(std::size_t(plane));
    std::vector<std::uint32_t> points;
    for (const auto& [from, to] : sides) {
      points.push_back(from);
    }
    std::ranges::sort(points, {}, [&](std::uint32_t point) {
      const Vec3& place = result_.points[point];
      return std::pair(place[(axis_ + 1) % 3], place[(axis_ + 2) % 3]);
    });
    std::map<std::uint32_t, std::uint32_t> number, next;
    for (const std::uint32_t point : points) {
      number.emplace(point, static_cast<std::uint32_t>(number.size()));
    }
    for (auto [from, to] : sides) {
      if (plane == 0) {  // seen from before it, they run the other way round
        std::swap(from, to);
      }
      if (!number.contains(from) || !number.contains(to)) {
        throw Error(Errc::invalid_argument, "a mesh that is cut is not closed");
      }
      link(number.at(from), number.at(to), next);
    }
    if (points.empty()) {
      return;
    }
    const std::uint32_t name = label(cuts_.at(std::size_t(plane))->name);
    for (auto [a, b, c] : region(points, axis_, polygons_of(std::move(next)))) {
      if (plane == 0) {
        std::swap(b, c);
      }
      result_.triangles.push_back({points[a], points[b], points[c]});
      result_.labels.push_back(name);
    }
  }

  const TriMesh& mesh_;
  int axis_;
  std::array<const PlaneCut*, 2> cuts_;
  std::vector<Side> side_;
  std::vector<std::uint32_t> taken_, crossed_;
  std::uint32_t unlabelled_ = 0;
  std::map<std::tuple<std::uint32_t, std::uint32_t, int>, std::uint32_t> known_;
  std::array<std::vector<std::pair<std::uint32_t, std::uint32_t>>, 2> sides_;  // of what closes it
  TriMesh result_;
};

}  // namespace

TriMesh between_planes(const TriMesh& mesh, int axis, const std::optional<PlaneCut>& from,
                       const std::optional<PlaneCut>& to) {
  return from || to ? MeshCutter(mesh, axis, from, to).run() : mesh;
}

}  // namespace dupin::cli
