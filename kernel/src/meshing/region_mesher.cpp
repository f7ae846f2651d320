#include "meshing/region_mesher.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <utility>

#include <Eigen/Geometry>

#include "mesh/surface_distance.h"
#include "meshing/angle_improvement.h"
#include "meshing/delaunay_refinement.h"
#include "meshing/edge_cuts.h"
#include "meshing/edge_edits.h"
#include "meshing/edge_lengths.h"
#include "meshing/patch_topology.h"
#include "meshing/patch_trials.h"
#include "meshing/seeds.h"
#include "meshing/tetrahedra.h"

namespace dupin::meshing {
namespace {

/// More would ask for triangles of no size where points along curves are too far apart.
constexpr int kAttempts = 2;

class Mesher {
 public:
  Mesher(const Region& region, const CurvePoints& balls, const GivenSolid& given, RegionWish& wish,
         const Progress& progress)
      : region_(region),
        balls_(balls),
        given_(given),
        options_(given.options()),
        wish_(wish),
        progress_(progress),
        surface_(region.mesh.points, region.mesh.triangles, region.features.regions) {
    for (std::size_t c = 0; c < balls.chains.size(); ++c) {
      borders_.push_back({balls.chains[c], region.sides[c]});
    }
  }

  std::optional<RegionMesh> run() {
    if (!has_near_borders()) {
      return std::nullopt;
    }
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      made_ = refined();
      if (!is_patch()) {
        wish_.share /= 2;
        continue;
      }
      const std::optional<double> deviation = improved();
      if (!deviation) {
        wish_.share /= 2;
      } else if (const double longest = longest_edge(); longest > given_.largest_edge()) {
        // Beside curves the generator does not look at sizes.
        edge_share_ *= 0.95 * given_.largest_edge() / longest;
        wish_.fault = given_.too_long();
      } else {
        return RegionMesh{std::move(made_.points), std::move(made_.triangles), *deviation};
      }
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] Tetrahedra refined() const {
    const double distance = wish_.share * (options_.distance - given_.features().absorbed);
    const EdgeLengths lengths(surface_, region_.features, distance,
                              edge_share_ * given_.largest_edge() / 2);
    Refinement wanted;
    wanted.edge_length = [&](const Vec3& point) { return lengths.at(point); };
    wanted.radius = edge_share_ * given_.largest_edge() / 2;
    wanted.distance = distance;
    wanted.smallest_angle = options_.smallest_angle;
    wanted.most_points = options_.most_points;
    wanted.most_useful_points = most_useful_points(lengths);
    wanted.seeds = seeds_of(region_.mesh, region_.features, surface_, lengths);
    return refine_surface(region_.mesh, region_.features, balls_, wanted, progress_);
  }

  /// Meshes had at most 1.8 times as many points as their borders, and triangles of these lengths,
  /// have.
  [[nodiscard]] std::size_t most_useful_points(const EdgeLengths& lengths) const {
    constexpr double kMore = 4, kAtLeast = 500;
    double points = static_cast<double>(balls_.points.size());
    for (const auto& [a, b, c] : region_.mesh.triangles) {
      const Vec3 &p = region_.mesh.points[a], &q = region_.mesh.points[b],
                 &r = region_.mesh.points[c];
      double shortest = edge_share_ * given_.largest_edge();
      for (const Vec3& place : {p, q, r, Vec3((p + q + r) / 3)}) {
        shortest = std::min(shortest, lengths.at(place));
      }
      points += (q - p).cross(r - p).norm() / 2 / (shortest * shortest);
    }
    return static_cast<std::size_t>(
        std::min(kAtLeast + kMore * points, static_cast<double>(options_.most_points)));
  }

  /// Whether edges between neighbours of the chains, which every mesh has, may be within the
  /// distance.
  [[nodiscard]] bool has_near_borders() {
    for (const std::vector<std::uint32_t>& chain : balls_.chains) {
      for (std::size_t i = 1; i < chain.size(); ++i) {
        const Vec3 &a = balls_.points[chain[i - 1]].place, &b = balls_.points[chain[i]].place;
        if (!surface_.nearest((a + b) / 2, 0, options_.distance)) {
          wish_.fault = given_.too_far({a, b, (a + b) / 2});
          return false;
        }
      }
    }
    return true;
  }

  /// Makes the mesh better, cuts it where it is too far off, and returns its distance, if that can
  /// be proved.
  std::optional<double> improved() {
    for (const double share : {0.9, 0.8, 0.7}) {
      const MoveLimits limits = {given_.largest_edge(), share * options_.distance};
      cut_far_edges(made_, surface_, borders_, limits.distance);
      improve(limits);
      if (const std::optional<double> deviation = this->deviation()) {
        const Tetrahedra before = made_;
        if (!try_patches(made_, surface_, borders_, options_.smallest_angle, limits)) {
          return deviation;
        }
        if (const std::optional<double> now = this->deviation()) {
          return now;
        }
        made_ = before;
        return deviation;
      }
    }
    return std::nullopt;
  }

  void improve(const MoveLimits& limits) {
    constexpr int kRounds = 3;
    improve_angles(made_, surface_, options_.smallest_angle, limits);
    for (int round = 0;
         round < kRounds && edit_edges(made_, surface_, borders_, options_.smallest_angle, limits);
         ++round) {
      improve_angles(made_, surface_, options_.smallest_angle, limits);
    }
  }

  /// Turns triangles outward.
  [[nodiscard]] bool is_patch() {
    std::vector<double> outward;
    for (const auto& [a, b, c] : made_.triangles) {
      const Vec3 &p = made_.points[a], &q = made_.points[b], &r = made_.points[c];
      const Vec3 normal = (q - p).cross(r - p);
      const auto near = surface_.nearest((p + q + r) / 3, 0, options_.distance);
      outward.push_back(near ? region_.features.normals[near->face].dot(normal) : 0);
    }
    if (made_.triangles.empty() || !turn_outward(made_.triangles, outward, borders_)) {
      const Triangle& t = region_.mesh.triangles.front();
      wish_.fault = GivenSolid::no_mesh(region_.mesh.points[t[0]]);
      return false;
    }
    return true;
  }

  /// The largest distance both ways, if it can be proved to be below the one allowed.
  [[nodiscard]] std::optional<double> deviation() {
    const mesh::ReferenceSurface back(made_.points, made_.triangles, made_.regions);
    const std::optional<double> there = largest(surface_, back, made_.triangles.size());
    const std::optional<double> here =
        there ? largest(back, surface_, region_.mesh.triangles.size()) : std::nullopt;
    return here ? std::optional(std::max(*there, *here)) : std::nullopt;
  }
  [[nodiscard]] std::optional<double> largest(const mesh::ReferenceSurface& to,
                                              const mesh::ReferenceSurface& from,
                                              std::size_t count) {
    double largest = 0;
    for (std::uint32_t f = 0; f < count; ++f) {
      const std::array<Vec3, 3> corners = from.corners(f);
      const std::optional<double> bound = to.bound(corners, 0, options_.distance - given_.slack());
      if (!bound) {
        wish_.fault = given_.too_far(corners);
        return std::nullopt;
      }
      largest = std::max(largest, *bound);
    }
    return largest;
  }

  [[nodiscard]] double longest_edge() const {
    double longest = 0;
    for (const Triangle& t : made_.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        longest = std::max(longest, (made_.points[t[k]] - made_.points[t[(k + 1) % 3]]).norm());
      }
    }
    return longest;
  }

  const Region& region_;
  const CurvePoints& balls_;
  const GivenSolid& given_;
  const RemeshOptions& options_;
  RegionWish& wish_;
  const Progress& progress_;
  mesh::ReferenceSurface surface_;
  std::vector<BorderChain> borders_;
  double edge_share_ = 0.9;  // of the largest edge, that is asked for
  Tetrahedra made_;
};

}  // namespace

std::vector<Region> regions_of(const GivenSolid& given) {
  const TriMesh& mesh = given.mesh();
  const Features& features = given.features();
  std::vector<Region> regions(given.region_count());
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    Region& region = regions[features.regions[f]];
    region.mesh.triangles.push_back(mesh.triangles[f]);
    region.features.normals.push_back(features.normals[f]);
    region.features.is_absorbed.push_back(features.is_absorbed[f]);
  }
  for (std::uint32_t c = 0; c < features.curves.size(); ++c) {
    const auto& [r, s] = features.curves[c].regions;
    for (const std::uint32_t number : {r, s}) {
      Region& region = regions[number];
      if (region.curves.empty() || region.curves.back() != c) {
        region.curves.push_back(c);
        region.sides.push_back(r == s ? 2 : 1);
        region.features.curves.push_back({features.curves[c].points, {0, 0}});
      }
    }
  }
  std::unordered_map<std::uint32_t, std::uint32_t> numbers;
  for (Region& region : regions) {
    numbers.clear();
    for (Triangle& triangle : region.mesh.triangles) {
      for (std::uint32_t& corner : triangle) {
        const auto [at, is_new] =
            numbers.emplace(corner, static_cast<std::uint32_t>(region.mesh.points.size()));
        if (is_new) {
          region.mesh.points.push_back(mesh.points[corner]);
        }
        corner = at->second;
      }
    }
    region.features.regions.assign(region.mesh.triangles.size(), 0);
  }
  return regions;
}

std::optional<RegionMesh> mesh_region(const Region& region, const CurvePoints& balls,
                                      const GivenSolid& given, RegionWish& wish,
                                      const Progress& progress) {
  return Mesher(region, balls, given, wish, progress).run();
}

}  // namespace dupin::meshing
