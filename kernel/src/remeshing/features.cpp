#include "remeshing/features.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "mesh/edge_table.h"

namespace dupin::remeshing {
namespace {

constexpr double kSharpTurn = 50 * std::numbers::pi / 180;

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Normals of triangles. Those too thin for their rounded corners to tell have that of the
/// neighbour at their longest edge.
class Normals {
 public:
  Normals(const TriMesh& mesh, const mesh::EdgeTable& edges)
      : normals_(mesh.triangles.size(), Vec3::Zero()) {
    double largest = 0;
    for (const Vec3& point : mesh.points) {
      largest = std::max(largest, point.cwiseAbs().maxCoeff());
    }
    const double least_height = largest * 0x1p-40;
    std::vector<std::uint32_t> thin;
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
      const auto& [a, b, c] = mesh.triangles[f];
      const Vec3 &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
      const Vec3 normal = (q - p).cross(r - p);
      const double longest = std::max({(q - p).norm(), (r - q).norm(), (p - r).norm()});
      if (normal.norm() > least_height * longest) {
        normals_[f] = normal.normalized();
      } else {
        thin.push_back(f);
      }
    }
    if (!thin.empty()) {
      borrow(mesh, edges, thin);
    }
  }
  [[nodiscard]] const Vec3& operator[](std::uint32_t face) const { return normals_[face]; }

 private:
  void borrow(const TriMesh& mesh, const mesh::EdgeTable& edges,
              const std::vector<std::uint32_t>& thin) {
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
        Vec3 normal = normals_[f];
        for (std::uint32_t k = 0; k < 3 && normals_[f].isZero(); ++k) {
          const std::uint32_t other = across[f][k];
          const double length =
              (mesh.points[mesh.triangles[f][k]] - mesh.points[mesh.triangles[f][(k + 1) % 3]])
                  .norm();
          if (length > longest && !normals_[other].isZero()) {
            longest = length;
            normal = normals_[other];
          }
        }
        found = found || (normals_[f].isZero() && !normal.isZero());
        normals_[f] = normal;
      }
    }
  }

  std::vector<Vec3> normals_;
};

struct SharpEdge {
  std::uint32_t edge, other_end;
};

class Finder {
 public:
  Finder(const TriMesh& mesh, std::span<const std::uint8_t> fixed, const FeatureOptions& options)
      : mesh_(mesh),
        options_(options),
        edges_(mesh.triangles, mesh.points.size()),
        at_(mesh.points.size()) {
    features_.spans.resize(mesh.triangles.size());
    features_.freedoms.assign(mesh.points.size(), Freedom::region);
    find_sharp_edges();
    find_regions();
    used_.assign(edges_.size(), 0);
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
      const bool stays = fixed[v] != 0 || (at_[v].size() != 2 && !at_[v].empty());
      features_.freedoms[v] = stays            ? Freedom::none
                              : at_[v].empty() ? Freedom::region
                                               : Freedom::curve;
    }
  }

  Features run() {
    const auto count = static_cast<std::uint32_t>(mesh_.points.size());
    for (std::uint32_t v = 0; v < count; ++v) {
      if (features_.freedoms[v] == Freedom::none) {
        chains_from(v);
      }
    }
    for (std::uint32_t v = 0; v < count; ++v) {  // loops
      if (features_.freedoms[v] == Freedom::curve && used_[at_[v][0].edge] == 0) {
        features_.freedoms[v] = Freedom::none;
        chains_from(v);
      }
    }
    return std::move(features_);
  }

 private:
  void find_sharp_edges() {
    const Normals normals(mesh_, edges_);
    is_sharp_.assign(edges_.size(), 0);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      const mesh::Edge edge = edges_[e];
      const std::uint32_t f = edge.half_edges[0] / 3, g = edge.half_edges[1] / 3;
      const bool is_border = !mesh_.labels.empty() && mesh_.labels[f] != mesh_.labels[g];
      if (is_border || angle_between(normals[f], normals[g]) > options_.angle) {
        is_sharp_[e] = 1;
        at_[edge.low].push_back({e, edge.high});
        at_[edge.high].push_back({e, edge.low});
      }
    }
  }

  void find_regions() {
    const std::size_t faces = mesh_.triangles.size();
    std::vector<std::vector<std::uint32_t>> smooth(faces);
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
      if (is_sharp_[e] == 0) {
        const std::uint32_t f = edges_[e].half_edges[0] / 3, g = edges_[e].half_edges[1] / 3;
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

  void chains_from(std::uint32_t corner) {
    for (const SharpEdge& first : at_[corner]) {
      if (used_[first.edge] != 0) {
        continue;
      }
      std::vector<std::uint32_t> points = {corner}, edges;
      for (SharpEdge step = first;;) {
        used_[step.edge] = 1;
        edges.push_back(step.edge);
        points.push_back(step.other_end);
        const std::uint32_t here = step.other_end;
        if (features_.freedoms[here] == Freedom::none) {
          break;
        }
        step = at_[here][0].edge == step.edge ? at_[here][1] : at_[here][0];
      }
      cut_at_turns(points, edges);
    }
  }

  /// How much the polyline turns at its point i, seen from some way off.
  [[nodiscard]] double turn(const std::vector<std::uint32_t>& points, std::size_t i) const {
    const Vec3& here = mesh_.points[points[i]];
    std::size_t back = i - 1, ahead = i + 1;
    while (back > 0 && (mesh_.points[points[back]] - here).norm() < options_.length) {
      --back;
    }
    while (ahead + 1 < points.size() &&
           (mesh_.points[points[ahead]] - here).norm() < options_.length) {
      ++ahead;
    }
    return angle_between(here - mesh_.points[points[back]], mesh_.points[points[ahead]] - here);
  }

  /// Makes curves of a chain, which ends where it turns sharply, and begins anew.
  void cut_at_turns(const std::vector<std::uint32_t>& points,
                    const std::vector<std::uint32_t>& edges) {
    std::size_t begin = 0;
    std::vector<double> turns(points.size(), 0);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      turns[i] = turn(points, i);
    }
    for (std::size_t i = 1; i < points.size(); ++i) {
      const bool is_end = i + 1 == points.size();
      if (is_end || (turns[i] > kSharpTurn && is_sharpest(points, turns, i))) {
        features_.freedoms[points[i]] = Freedom::none;
        add_curve(std::span(points).subspan(begin, i - begin + 1),
                  std::span(edges).subspan(begin, i - begin));
        begin = i;
      }
    }
  }

  [[nodiscard]] bool is_sharpest(const std::vector<std::uint32_t>& points,
                                 const std::vector<double>& turns, std::size_t i) const {
    const Vec3& here = mesh_.points[points[i]];
    const auto near = [&](std::size_t k) {
      return (mesh_.points[points[k]] - here).norm() < options_.length;
    };
    for (std::size_t k = i; k-- > 0 && near(k);) {
      if (turns[k] >= turns[i]) {
        return false;
      }
    }
    for (std::size_t k = i + 1; k < points.size() && near(k); ++k) {
      if (turns[k] > turns[i]) {
        return false;
      }
    }
    return true;
  }

  void add_curve(std::span<const std::uint32_t> points, std::span<const std::uint32_t> edges) {
    Curve curve;
    const auto number = static_cast<std::uint32_t>(features_.curves.size());
    curve.ends = {points.front(), points.back()};
    for (std::size_t i = 0; i < points.size(); ++i) {
      curve.points.push_back(mesh_.points[points[i]]);
      curve.lengths.push_back(
          i == 0 ? 0 : curve.lengths.back() + (curve.points[i] - curve.points[i - 1]).norm());
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const mesh::Edge edge = edges_[edges[i]];
      const Span span{number, curve.lengths[i], curve.lengths[i + 1]};
      for (const std::uint32_t half_edge : edge.half_edges) {
        features_.spans[half_edge / 3][half_edge % 3] =
            edges_.origin(half_edge) == points[i] ? span : span.reversed();
      }
      curve.sides.push_back(
          {features_.regions[edge.half_edges[0] / 3], features_.regions[edge.half_edges[1] / 3]});
    }
    features_.curves.push_back(std::move(curve));
  }

  const TriMesh& mesh_;
  FeatureOptions options_;
  mesh::EdgeTable edges_;
  std::vector<std::uint8_t> is_sharp_, used_;  // per edge
  std::vector<std::vector<SharpEdge>> at_;     // per point
  Features features_;
};

}  // namespace

std::size_t Curve::edge_at(double length) const {
  const auto above = std::upper_bound(lengths.begin(), lengths.end(), length);
  const auto i = static_cast<std::size_t>(above - lengths.begin());
  return std::clamp<std::size_t>(i, 1, lengths.size() - 1) - 1;
}

Vec3 Curve::at(double length) const {
  const std::size_t i = edge_at(length);
  const double span = lengths[i + 1] - lengths[i];
  const double t = span > 0 ? std::clamp((length - lengths[i]) / span, 0.0, 1.0) : 0;
  return points[i] + t * (points[i + 1] - points[i]);
}

double Curve::deviation(double from, double to, const Vec3& a, const Vec3& b) const {
  if (from > to) {
    return deviation(to, from, b, a);
  }
  double largest = std::max((at(from) - a).norm(), (at(to) - b).norm());
  const Vec3 chord = b - a;
  double t = 0;
  for (std::size_t i = edge_at(from) + 1; i < points.size() && lengths[i] < to; ++i) {
    // Any rising map does; the foot is nearly the best one.
    t = std::clamp((points[i] - a).dot(chord) / chord.squaredNorm(), t, 1.0);
    largest = std::max(largest, (points[i] - (a + t * chord)).norm());
  }
  return largest;
}

Features find_features(const TriMesh& mesh, std::span<const std::uint8_t> fixed,
                       const FeatureOptions& options) {
  return Finder(mesh, fixed, options).run();
}

}  // namespace dupin::remeshing
