#include "meshing/solver_mesh_maker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/kernel/error.h"
#include "dupin/kernel/rounding.h"
#include "meshing/angle_improvement.h"
#include "meshing/delaunay_refinement.h"
#include "meshing/edge_lengths.h"
#include "meshing/features.h"
#include "meshing/surface_distance.h"
#include "meshing/tetrahedra.h"
#include "support/blocks.h"
#include "support/none.h"

namespace dupin::meshing {
namespace {

/// Triangles that are moved stay within so much of the distance at the places that are looked at.
constexpr double kNear = 0.75;
/// Along a curve there is one ball for so many points, or they would be nowhere else.
constexpr std::size_t kPointsPerBall = 10;
constexpr double kDegree = std::numbers::pi / 180;
/// Of tetrahedra, wanted: solvers complain of less.
constexpr double kDihedralAngle = 12 * kDegree;

void check_options(const RemeshOptions& options) {
  const auto refuse = [](const std::string& what) { throw Error(Errc::invalid_argument, what); };
  if (!(options.distance > 0) || !std::isfinite(options.distance)) {
    refuse("the distance of a mesh for solvers must be positive and finite");
  }
  if (!(options.largest_edge >= 0) || !std::isfinite(options.largest_edge)) {
    refuse("the largest edge must be 0, for a choice, or positive and finite");
  }
  if (!(options.smallest_angle >= 0 && options.smallest_angle <= 30.001 * kDegree)) {
    refuse("the smallest angle must be between 0 and 30 degrees");
  }
  if (!(options.feature_angle > 0 && options.feature_angle < std::numbers::pi)) {
    refuse("the angle of sharp edges must be between 0 and 180 degrees");
  }
  if (options.most_points == 0) {
    refuse("the largest number of points must be positive");
  }
}

Eigen::AlignedBox3d box_of(const TriMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : mesh.points) {
    box.extend(point);
  }
  return box;
}

class Maker {
 public:
  Maker(const Solid& solid, const RemeshOptions& options, bool fill)
      : solid_(solid),
        options_(options),
        fill_(fill),
        given_(to_mesh(solid).mesh()),
        features_(find_features(given_, options.feature_angle, options.distance)),
        surface_(given_.points, given_.triangles, features_.regions) {
    const Eigen::AlignedBox3d box = box_of(given_);
    largest_edge_ = options.largest_edge > 0 ? options.largest_edge : box.diagonal().norm() / 10;
    // Covers the rounding of a distance, and of cuts, tenfold.
    slack_ = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()) * 0x1p-46;
  }

  SolverMesh run() {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      made_ = refined(share_ * (options_.distance - features_.absorbed));
      tell(options_.progress, "improve");
      const MoveLimits limits{largest_edge_, kNear * options_.distance};
      improve_angles(made_, surface_, options_.smallest_angle, limits);
      if (fill_) {
        improve_dihedral_angles(made_, surface_, kDihedralAngle, options_.smallest_angle, limits);
      }
      tell(options_.progress, "prove");
      if (std::optional<SolverMesh> proved = prove()) {
        return std::move(*proved);
      }
    }
    throw Error(Errc::unroundable, fault_);
  }

 private:
  static constexpr int kAttempts = 4;

  [[nodiscard]] Tetrahedra refined(double distance) const {
    const EdgeLengths lengths(surface_, features_, distance, edge_share_ * largest_edge_ / 2);
    lengths.require_room(std::max<std::size_t>(options_.most_points / kPointsPerBall, 1));
    Refinement wanted;
    wanted.edge_length = [&](const Vec3& point) { return lengths.at(point); };
    wanted.radius = edge_share_ * largest_edge_ / 2;
    wanted.distance = distance;
    wanted.smallest_angle = options_.smallest_angle;
    wanted.fill = fill_;
    wanted.most_points = options_.most_points;
    wanted.seeds = seeds(lengths);
    return refine(given_, features_, wanted, options_.progress);
  }

  /// Three points of each region so near each other that they make a triangle of its mesh
  /// [BO05, persistent facets], about the middle of a large triangle.
  [[nodiscard]] std::vector<Seed> seeds(const EdgeLengths& lengths) const {
    const std::size_t count =
        1 + static_cast<std::size_t>(*std::ranges::max_element(features_.regions));
    std::vector<std::uint8_t> has_curve(count, 0);
    for (const Curve& curve : features_.curves) {
      has_curve[curve.regions[0]] = has_curve[curve.regions[1]] = 1;
    }
    std::vector<std::uint32_t> largest(count, support::kNone);
    std::vector<double> areas(count, -1);
    for (std::uint32_t f = 0; f < given_.triangles.size(); ++f) {
      const auto& [a, b, c] = corners_of(f);
      const double area = (b - a).cross(c - a).norm();
      if (const std::uint32_t region = features_.regions[f]; area > areas[region]) {
        areas[region] = area;
        largest[region] = f;
      }
    }
    std::vector<Seed> seeds;
    constexpr double kShare = 0.3;  // of the length of edges
    for (std::uint32_t region = 0; region < count; ++region) {
      const auto& [a, b, c] = corners_of(largest[region]);
      const Vec3 middle = (a + b + c) / 3, normal = features_.normals[largest[region]];
      const Vec3 across = normal.unitOrthogonal(), along = normal.cross(across);
      const double step = kShare * lengths.at(middle);
      for (int k = 0; k < 3; ++k) {
        const double turn = 2 * std::numbers::pi * k / 3;
        const auto near = surface_.nearest(
            middle + step * (std::cos(turn) * across + std::sin(turn) * along), region, 2 * step);
        if (near) {
          seeds.push_back({near->point, region, has_curve[region] == 0});
        }
      }
    }
    add_extreme_points(has_curve, seeds);
    return seeds;
  }
  /// Regions' points that lie furthest along the axes: with three near each other alone there would
  /// be no tetrahedron.
  void add_extreme_points(const std::vector<std::uint8_t>& has_curve,
                          std::vector<Seed>& seeds) const {
    constexpr std::size_t kDirections = 6;
    std::vector<std::array<std::uint32_t, kDirections>> extremes(has_curve.size());
    std::ranges::for_each(extremes, [](auto& points) { points.fill(support::kNone); });
    const auto reach = [&](std::uint32_t v, std::size_t k) {
      const double coordinate = given_.points[v][static_cast<Eigen::Index>(k / 2)];
      return k % 2 == 0 ? coordinate : -coordinate;
    };
    for (std::uint32_t f = 0; f < given_.triangles.size(); ++f) {
      for (const std::uint32_t v : given_.triangles[f]) {
        for (std::size_t k = 0; k < kDirections; ++k) {
          std::uint32_t& extreme = extremes[features_.regions[f]][k];
          if (extreme == support::kNone || reach(v, k) > reach(extreme, k)) {
            extreme = v;
          }
        }
      }
    }
    for (std::uint32_t region = 0; region < extremes.size(); ++region) {
      for (const std::uint32_t v : extremes[region]) {
        seeds.push_back({given_.points[v], region, has_curve[region] == 0});
      }
    }
  }
  [[nodiscard]] std::array<Vec3, 3> corners_of(std::uint32_t face) const {
    const auto& [a, b, c] = given_.triangles[face];
    return {given_.points[a], given_.points[b], given_.points[c]};
  }

  /// Nothing if a distance or the solid cannot be proved. What is wrong is noted then, and less
  /// asked for.
  std::optional<SolverMesh> prove() {
    std::optional<SolverMesh> result = prove_solid();
    if (!result) {
      share_ /= 2;
    } else if (result->report.longest_edge > largest_edge_) {
      // Beside curves the generator does not look at sizes.
      edge_share_ *= 0.95 * largest_edge_ / result->report.longest_edge;
      fault_ = "edges cannot be kept as short as " + std::to_string(largest_edge_) +
               "; allow longer ones";
      result.reset();
    }
    return result;
  }
  std::optional<SolverMesh> prove_solid() {
    if (made_.triangles.empty()) {
      fault_ = "no mesh of the solid comes of these lengths; allow shorter edges or less distance";
      return std::nullopt;
    }
    VolumeMesh mesh = volume_mesh_of({std::move(made_.points), std::move(made_.triangles), {}, {}},
                                     std::move(made_.tetrahedra));
    TriMesh& skin = mesh.surface;
    const ReferenceSurface back(skin.points, skin.triangles, made_.regions);
    const std::optional<double> there = largest(surface_, skin, made_.regions);
    const std::optional<double> here =
        there ? largest(back, given_, features_.regions) : std::nullopt;
    if (!here) {
      return std::nullopt;
    }
    label(skin);
    SolverMesh result;
    try {
      result.surface = Solid::from(skin);
    } catch (const Error& error) {
      fault_ = std::string("the mesh is no solid: ") + error.what();
      return std::nullopt;
    }
    if (result.surface.euler_number() != solid_.euler_number() ||
        result.surface.shells() != solid_.shells()) {
      fault_ = "the mesh does not hang together as the solid does; allow less distance";
      return std::nullopt;
    }
    result.report = report_of(skin);
    result.report.deviation = std::max(*there, *here) + slack_;
    result.mesh = std::move(mesh);
    return result;
  }

  /// The largest distance from the triangles of a mesh to the same region of a surface, if it can
  /// be proved to be below the one allowed.
  [[nodiscard]] std::optional<double> largest(const ReferenceSurface& to, const TriMesh& from,
                                              const std::vector<std::uint32_t>& regions) {
    constexpr std::size_t kBlock = 64;
    std::vector<double> distances(from.triangles.size());
    support::for_each_block(
        distances.size(),
        [&](const support::Block& block) {
          for (std::size_t i = block.begin; i < block.end; ++i) {
            const auto& [a, b, c] = from.triangles[i];
            distances[i] = to.bound({from.points[a], from.points[b], from.points[c]}, regions[i],
                                    options_.distance - slack_)
                               .value_or(std::numeric_limits<double>::infinity());
          }
        },
        kBlock);
    const auto far = std::ranges::max_element(distances);
    if (*far <= options_.distance) {
      return *far;
    }
    const auto& [a, b, c] = from.triangles[static_cast<std::size_t>(far - distances.begin())];
    const Vec3 place = (from.points[a] + from.points[b] + from.points[c]) / 3;
    std::ostringstream text;
    text << "the distance of " << options_.distance << " cannot be kept near " << place.x() << " "
         << place.y() << " " << place.z() << "; allow more of it, or shorter edges";
    fault_ = text.str();
    return std::nullopt;
  }

  void label(TriMesh& mesh) const {
    if (given_.labels.empty()) {
      return;
    }
    // By region, that of the largest part: thin ones may have become part of it.
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> areas;
    for (std::uint32_t f = 0; f < given_.triangles.size(); ++f) {
      const auto& [a, b, c] = corners_of(f);
      areas[{features_.regions[f], given_.labels[f]}] += (b - a).cross(c - a).norm();
    }
    std::vector<std::uint32_t> labels(given_.triangles.size());
    std::vector<double> largest(given_.triangles.size(), -1);
    for (const auto& [key, area] : areas) {
      if (area > largest[key.first]) {
        largest[key.first] = area;
        labels[key.first] = key.second;
      }
    }
    for (const std::uint32_t region : made_.regions) {
      mesh.labels.push_back(labels[region]);
    }
    mesh.names = given_.names;
  }

  [[nodiscard]] RemeshReport report_of(const TriMesh& mesh) const {
    constexpr std::size_t kTold = 10;
    RemeshReport report;
    report.smallest_angle = std::numbers::pi;
    report.shortest_edge = std::numeric_limits<double>::infinity();
    std::vector<PoorTriangle> poor;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3 &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
      const double angle = smallest_angle(p, q, r);
      report.smallest_angle = std::min(report.smallest_angle, angle);
      if (angle < options_.smallest_angle) {
        poor.push_back({(p + q + r) / 3, angle});
      }
      for (const double length : {(q - p).norm(), (r - q).norm(), (p - r).norm()}) {
        report.shortest_edge = std::min(report.shortest_edge, length);
        report.longest_edge = std::max(report.longest_edge, length);
      }
    }
    report.poor_triangles = poor.size();
    std::ranges::stable_sort(poor, {}, &PoorTriangle::angle);
    poor.resize(std::min(poor.size(), kTold));
    report.worst = std::move(poor);
    return report;
  }

  const Solid& solid_;
  const RemeshOptions& options_;
  bool fill_;
  TriMesh given_;
  Features features_;
  ReferenceSurface surface_;
  double largest_edge_ = 0, slack_ = 0;
  // Of the distance and of the largest edge, that is asked for.
  double share_ = 0.5, edge_share_ = 0.9;
  Tetrahedra made_;
  std::string fault_;  // of the last mesh that was not proved
};

}  // namespace

SolverMesh make_solver_mesh(const Solid& solid, const RemeshOptions& options, bool fill) {
  check_options(options);
  if (solid.empty()) {
    return {};
  }
  if (!solid.contacts().empty()) {
    const Vec3& place = solid.contacts().front().from;
    std::ostringstream text;
    text << "a solid that touches itself, as near " << place.x() << " " << place.y() << " "
         << place.z() << ", cannot be meshed for solvers; separate or bridge its contacts first";
    throw Error(Errc::contact, text.str());
  }
  return Maker(solid, options, fill).run();
}

}  // namespace dupin::meshing
