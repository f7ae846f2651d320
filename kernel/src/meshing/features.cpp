#include "meshing/features.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "mesh/edge_table.h"
#include "mesh/surface_distance.h"
#include "support/disjoint_sets.h"
#include "support/none.h"

namespace dupin::meshing {
namespace {

/// Curves that turn by more have a corner there.
constexpr double kSharpTurn = 50 * std::numbers::pi / 180;
/// A region to which the surface turns by more may lie back on its neighbour; steps turn by a right
/// angle.
constexpr double kFold = 120 * std::numbers::pi / 180;
/// Creases that are deeper, in distances, are kept: less deep ones take fewer triangles without.
constexpr double kDeep = 4;
/// Two creases that turn by more lead the surface back beside itself. What is flat between them and
/// narrower than edges, such as the rim of a plate, keeps them: in one region with both its sides,
/// the generator makes all edges of these as short as the rim is wide.
constexpr double kBack = 60 * std::numbers::pi / 180;
/// What turns by less at every edge within is flat.
constexpr double kFlat = 1e-3;

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double longest_edge(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
}

/// Gives triangles that are too thin the normal of the neighbour at their longest edge.
void borrow_normals(const TriMesh& mesh, const mesh::EdgeTable& edges,
                    const std::vector<std::uint32_t>& thin, std::vector<Vec3>& normals) {
  std::vector<std::array<std::uint32_t, 3>> across(mesh.triangles.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto& sides = edges[e].half_edges;
    across[sides[0] / 3][sides[0] % 3] = sides[1] / 3;
    across[sides[1] / 3][sides[1] % 3] = sides[0] / 3;
  }
  for (bool found = true; found;) {
    found = false;
    for (const std::uint32_t f : thin) {
      double longest = -1;
      Vec3 normal = normals[f];
      for (std::uint32_t k = 0; k < 3 && normals[f].isZero(); ++k) {
        const Triangle& t = mesh.triangles[f];
        const double length = (mesh.points[t[k]] - mesh.points[t[(k + 1) % 3]]).norm();
        if (length > longest && !normals[across[f][k]].isZero()) {
          longest = length;
          normal = normals[across[f][k]];
        }
      }
      found = found || (normals[f].isZero() && !normal.isZero());
      normals[f] = normal;
    }
  }
}

std::vector<Vec3> normals_of(const TriMesh& mesh, const mesh::EdgeTable& edges) {
  double largest = 0;
  for (const Vec3& point : mesh.points) {
    largest = std::max(largest, point.cwiseAbs().maxCoeff());
  }
  const double least_height = largest * 0x1p-40;
  std::vector<Vec3> normals(mesh.triangles.size(), Vec3::Zero());
  std::vector<std::uint32_t> thin;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    const Vec3 &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
    const Vec3 normal = (q - p).cross(r - p);
    if (normal.norm() > least_height * longest_edge(p, q, r)) {
      normals[f] = normal.normalized();
    } else {
      thin.push_back(f);
    }
  }
  if (!thin.empty()) {
    borrow_normals(mesh, edges, thin, normals);
  }
  return normals;
}

struct SharpEdge {
  std::uint32_t edge, other_end;
};

class Finder {
 public:
  Finder(const TriMesh& mesh, double angle, double distance, double largest_edge)
      : mesh_(mesh),
        length_(2 * distance),
        edges_(mesh.triangles, mesh.points.size()),
        at_(mesh.points.size()) {
    features_.normals = normals_of(mesh, edges_);
    find_sharp_edges(angle, distance, largest_edge);
    find_regions();
    absorb_thin_regions(distance / 4);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      if (is_sharp_[e] != 0) {
        at_[edges_[e].low].push_back({e, edges_[e].high});
        at_[edges_[e].high].push_back({e, edges_[e].low});
      }
    }
    used_.assign(edges_.size(), 0);
    is_end_.resize(mesh.points.size());
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
      is_end_[v] = at_[v].size() != 2 && !at_[v].empty() ? 1 : 0;
    }
  }

  Features run() {
    const auto count = static_cast<std::uint32_t>(mesh_.points.size());
    for (std::uint32_t v = 0; v < count; ++v) {
      if (is_end_[v] != 0) {
        chains_from(v);
      }
    }
    for (std::uint32_t v = 0; v < count; ++v) {  // loops
      if (!at_[v].empty() && is_end_[v] == 0 && used_[at_[v][0].edge] == 0) {
        chains_from(v);
      }
    }
    drop_short_curves(length_ / 512);
    split_loops_at_corners();
    return std::move(features_);
  }

 private:
  void find_sharp_edges(double angle, double distance, double largest_edge) {
    std::vector<double> turns(edges_.size());
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      const auto [f, g] = faces_at(e);
      turns[e] = angle_between(features_.normals[f], features_.normals[g]);
    }
    const std::vector<double> widths = widths_of_flats(turns);
    is_sharp_.assign(edges_.size(), 0);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      const auto [f, g] = faces_at(e);
      const bool is_border = !mesh_.labels.empty() && mesh_.labels[f] != mesh_.labels[g];
      // A triangle across it has its middle so far from it.
      const double width = std::min(widths[f], widths[g]);
      const double length = std::min(largest_edge, width);
      const double depth = turns[e] > kFlat ? length / 4 * std::tan(turns[e] / 2) : 0;
      const bool leads_back = turns[e] > kBack && width < largest_edge;
      is_sharp_[e] =
          is_border || turns[e] > angle || leads_back || depth > kDeep * distance ? 1 : 0;
    }
  }

  /// Per triangle, the width of what is flat about it, were it a strip; `turns` are those at edges.
  [[nodiscard]] std::vector<double> widths_of_flats(const std::vector<double>& turns) const {
    const std::size_t faces = mesh_.triangles.size();
    support::DisjointSets flats(faces);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      if (turns[e] <= kFlat) {
        const auto [f, g] = faces_at(e);
        flats.unite(f, g);
      }
    }
    std::vector<double> areas(faces, 0), borders(faces, 0), widths(faces);
    for (std::uint32_t f = 0; f < faces; ++f) {
      areas[flats.find(f)] += area_of(f);
    }
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      if (turns[e] > kFlat) {
        const double length = (mesh_.points[edges_[e].low] - mesh_.points[edges_[e].high]).norm();
        for (const std::uint32_t f : faces_at(e)) {
          borders[flats.find(f)] += length;
        }
      }
    }
    for (std::uint32_t f = 0; f < faces; ++f) {
      const std::uint32_t flat = flats.find(f);
      widths[f] = borders[flat] > 0 ? 2 * areas[flat] / borders[flat] : 0;
    }
    return widths;
  }

  void find_regions() {
    const std::size_t faces = mesh_.triangles.size();
    std::vector<std::vector<std::uint32_t>> smooth(faces);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      if (is_sharp_[e] == 0) {
        const auto [f, g] = faces_at(e);
        smooth[f].push_back(g);
        smooth[g].push_back(f);
      }
    }
    features_.regions.assign(faces, support::kNone);
    std::vector<std::uint32_t> stack;
    std::uint32_t region = 0;
    for (std::uint32_t first = 0; first < faces; ++first) {
      if (features_.regions[first] != support::kNone) {
        continue;
      }
      stack.assign(1, first);
      features_.regions[first] = region;
      while (!stack.empty()) {
        const std::uint32_t f = stack.back();
        stack.pop_back();
        for (const std::uint32_t g : smooth[f]) {
          if (features_.regions[g] == support::kNone) {
            features_.regions[g] = region;
            stack.push_back(g);
          }
        }
      }
      ++region;
    }
  }

  [[nodiscard]] std::array<std::uint32_t, 2> faces_at(std::uint32_t edge) const {
    const auto& sides = edges_[edge].half_edges;
    return {sides[0] / 3, sides[1] / 3};
  }
  [[nodiscard]] double area_of(std::uint32_t face) const {
    const auto& [a, b, c] = corners_of(face);
    return (b - a).cross(c - a).norm() / 2;
  }
  [[nodiscard]] std::array<std::uint32_t, 2> regions_at(std::uint32_t edge) const {
    const auto [f, g] = faces_at(edge);
    return {features_.regions[f], features_.regions[g]};
  }

  /// Of regions.
  struct Extent {
    double area = 0, border = 0;
    /// Those beside it, and how much the surface turns to them.
    std::map<std::uint32_t, double> neighbours;
    std::vector<std::uint32_t> faces;  ///< of those that may be thin
  };
  [[nodiscard]] std::vector<Extent> extents(double distance) const {
    std::vector<Extent> extents(
        1 + static_cast<std::size_t>(*std::ranges::max_element(features_.regions)));
    for (std::uint32_t f = 0; f < mesh_.triangles.size(); ++f) {
      extents[features_.regions[f]].area += area_of(f);
    }
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      const auto [r, s] = regions_at(e);
      if (r != s) {
        const auto [f, g] = faces_at(e);
        const double turn = angle_between(features_.normals[f], features_.normals[g]);
        for (const auto& [own, other] : {std::pair(r, s), std::pair(s, r)}) {
          extents[own].border +=
              (mesh_.points[edges_[e].low] - mesh_.points[edges_[e].high]).norm();
          double& largest = extents[own].neighbours[other];
          largest = std::max(largest, turn);
        }
      }
    }
    for (std::uint32_t f = 0; f < mesh_.triangles.size(); ++f) {
      Extent& extent = extents[features_.regions[f]];
      if (extent.area <= distance * extent.border) {  // else it is wider
        extent.faces.push_back(f);
      }
    }
    return extents;
  }

  void absorb_thin_regions(double distance) {
    const std::vector<Extent> extents = this->extents(distance);
    std::vector<std::uint32_t> into(extents.size());
    std::iota(into.begin(), into.end(), 0U);
    const mesh::ReferenceSurface surface(mesh_.points, mesh_.triangles, features_.regions);
    const auto is_thin = [&](std::uint32_t region) { return !extents[region].faces.empty(); };
    std::vector<std::uint8_t> stays(extents.size(), 0);
    const auto absorb = [&](std::uint32_t region, bool by_thin_ones) {
      for (const auto& [neighbour, turn] : extents[region].neighbours) {
        // What is absorbed itself stands for what it became part of, and must be near that.
        const std::uint32_t other = into[neighbour];
        if (other == region || (is_thin(other) && !by_thin_ones)) {
          continue;
        }
        const double allowed = turn > kFold ? distance / 4 : distance;
        double largest = 0;
        if (std::ranges::all_of(extents[region].faces, [&](std::uint32_t f) {
              const auto bound = surface.bound(corners_of(f), other, allowed);
              largest = std::max(largest, bound.value_or(0));
              return bound.has_value();
            })) {
          features_.absorbed = std::max(features_.absorbed, largest);
          into[region] = other;
          stays[other] = 1;
          return true;
        }
      }
      return false;
    };
    for (const bool by_thin_ones : {false, true}) {
      for (bool found = true; found;) {
        found = false;
        for (std::uint32_t region = 0; region < into.size(); ++region) {
          if (is_thin(region) && into[region] == region && stays[region] == 0) {
            found = absorb(region, by_thin_ones) || found;
          }
        }
      }
    }
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      const auto [r, s] = regions_at(e);
      if (into[r] == into[s] && (r != s || into[r] != r)) {
        is_sharp_[e] = 0;
      }
    }
    for (const std::uint32_t region : features_.regions) {
      features_.is_absorbed.push_back(into[region] != region ? 1 : 0);
    }
    std::vector<std::uint32_t> numbers(into.size(), support::kNone);
    std::uint32_t next = 0;
    for (std::uint32_t& region : features_.regions) {
      std::uint32_t& number = numbers[into[region]];
      number = number == support::kNone ? next++ : number;
      region = number;
    }
  }

  [[nodiscard]] std::array<Vec3, 3> corners_of(std::uint32_t face) const {
    const auto& [a, b, c] = mesh_.triangles[face];
    return {mesh_.points[a], mesh_.points[b], mesh_.points[c]};
  }

  void chains_from(std::uint32_t corner) {
    for (const SharpEdge& first : at_[corner]) {
      if (used_[first.edge] != 0) {
        continue;
      }
      std::vector<std::uint32_t> points = {corner};
      for (SharpEdge step = first;;) {
        used_[step.edge] = 1;
        points.push_back(step.other_end);
        const std::uint32_t here = step.other_end;
        if (is_end_[here] != 0 || here == corner) {
          break;
        }
        step = at_[here][0].edge == step.edge ? at_[here][1] : at_[here][0];
      }
      cut_at_turns(points, regions_at(first.edge));
    }
  }

  /// How much the polyline turns at its point i, seen from some way off along it: where it goes
  /// back at a sharp angle, what is near in space, from inside the angle, is not what turns.
  [[nodiscard]] double turn(const std::vector<std::uint32_t>& points, std::size_t i) const {
    const Vec3& here = mesh_.points[points[i]];
    return angle_between(here - off(points, i, -1), off(points, i, 1) - here);
  }
  /// The place some way off, or the polyline's end.
  [[nodiscard]] Vec3 off(const std::vector<std::uint32_t>& points, std::size_t i, int step) const {
    double left = length_;
    for (;;) {
      const Vec3 &from = mesh_.points[points[i]], &to = mesh_.points[points[i + step]];
      const double edge = (to - from).norm();
      i += step;
      if (edge >= left) {
        return from + left / edge * (to - from);
      }
      if (i == 0 || i + 1 == points.size()) {
        return to;
      }
      left -= edge;
    }
  }

  /// Makes curves of a chain, which ends where it turns sharply, and begins anew.
  void cut_at_turns(const std::vector<std::uint32_t>& points,
                    const std::array<std::uint32_t, 2>& regions) {
    std::size_t begin = 0;
    std::vector<double> turns(points.size(), 0);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      turns[i] = turn(points, i);
    }
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (i + 1 == points.size() || (turns[i] > kSharpTurn && is_sharpest(points, turns, i))) {
        Curve curve{{}, regions};
        for (std::size_t k = begin; k <= i; ++k) {
          curve.points.push_back(mesh_.points[points[k]]);
        }
        features_.curves.push_back(std::move(curve));
        begin = i;
      }
    }
  }

  /// Curves shorter than `least` vanish, and their ends become one: unions have corners where two
  /// points are apart by a rounding error.
  void drop_short_curves(double least) {
    std::map<Place, std::uint32_t> numbers;
    std::vector<Vec3> places;
    const auto number = [&](const Vec3& p) {
      const auto [at, is_new] =
          numbers.try_emplace(place_of(p), static_cast<std::uint32_t>(places.size()));
      if (is_new) {
        places.push_back(p);
      }
      return at->second;
    };
    for (const Curve& curve : features_.curves) {
      (void)number(curve.points.front());
      (void)number(curve.points.back());
    }
    support::DisjointSets ends(places.size());
    std::erase_if(features_.curves, [&](const Curve& curve) {
      double length = 0;
      for (std::size_t i = 1; i < curve.points.size(); ++i) {
        length += (curve.points[i] - curve.points[i - 1]).norm();
      }
      if (length < least) {
        ends.unite(number(curve.points.front()), number(curve.points.back()));
      }
      return length < least;
    });
    for (Curve& curve : features_.curves) {
      for (Vec3* end : {&curve.points.front(), &curve.points.back()}) {
        *end = places[ends.find(number(*end))];
      }
    }
  }

  /// Generators take a curve that ends where it begins as a loop without a corner, where others
  /// must not end.
  void split_loops_at_corners() {
    std::map<Place, int> ends;
    for (const Curve& curve : features_.curves) {
      ++ends[place_of(curve.points.front())];
      ++ends[place_of(curve.points.back())];
    }
    const std::size_t count = features_.curves.size();
    for (std::size_t c = 0; c < count; ++c) {
      Curve& curve = features_.curves[c];
      if (curve.points.front() == curve.points.back() && ends[place_of(curve.points.front())] > 2) {
        const auto middle =
            curve.points.begin() + static_cast<std::ptrdiff_t>(curve.points.size() / 2);
        Curve second{{middle, curve.points.end()}, curve.regions};
        curve.points.erase(middle + 1, curve.points.end());
        features_.curves.push_back(std::move(second));
      }
    }
  }
  using Place = std::array<double, 3>;
  [[nodiscard]] static Place place_of(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

  [[nodiscard]] bool is_sharpest(const std::vector<std::uint32_t>& points,
                                 const std::vector<double>& turns, std::size_t i) const {
    const auto edge = [&](std::size_t k) {
      return (mesh_.points[points[k]] - mesh_.points[points[k - 1]]).norm();
    };
    double way = 0;
    for (std::size_t k = i; k > 0 && (way += edge(k)) < length_;) {
      if (turns[--k] >= turns[i]) {
        return false;
      }
    }
    way = 0;
    for (std::size_t k = i + 1; k < points.size() && (way += edge(k)) < length_; ++k) {
      if (turns[k] > turns[i]) {
        return false;
      }
    }
    return true;
  }

  const TriMesh& mesh_;
  double length_;
  mesh::EdgeTable edges_;
  std::vector<std::uint8_t> is_sharp_, used_;  // per edge
  std::vector<std::uint8_t> is_end_;           // per point
  std::vector<std::vector<SharpEdge>> at_;     // per point
  Features features_;
};

}  // namespace

Features find_features(const TriMesh& mesh, double angle, double distance, double largest_edge) {
  return Finder(mesh, angle, distance, largest_edge).run();
}

}  // namespace dupin::meshing
