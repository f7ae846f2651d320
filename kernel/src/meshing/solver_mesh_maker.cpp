#include "meshing/solver_mesh_maker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "mesh/surface_distance.h"
#include "meshing/angle_improvement.h"
#include "meshing/delaunay_refinement.h"
#include "meshing/edge_lengths.h"
#include "meshing/features.h"
#include "meshing/given_solid.h"
#include "meshing/seeds.h"
#include "meshing/surface_mesh_maker.h"
#include "meshing/tetrahedra.h"
#include "support/blocks.h"

namespace dupin::meshing {
namespace {

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

/// Below that, the generator refines what its own rounding makes, and has no end: measured of
/// cubes, turned and at any place, from an eighth of it down.
void require_distance_of_doubles(const GivenSolid& given) {
  constexpr double kLeast = 0x1p-32;  // of the diagonal
  const double least = kLeast * given.diagonal(), distance = given.options().distance;
  if (distance < least) {
    throw Error(Errc::invalid_argument,
                "the distance of a mesh for solvers must be at least " + decimal_at_most(least) +
                    " for a solid of this size, not " + decimal(distance, kMessageDigits));
  }
}

/// Said before hours of work: no triangle covers more than one with three of these edges, and there
/// are two of them to a point. A mesh may have less area than what it is made of, but hardly a
/// quarter.
bool has_few_points(const GivenSolid& given, double edge) {
  constexpr double kPart = 0.25;
  const double triangles = kPart * given.area() / (std::numbers::sqrt3 / 4 * edge * edge);
  return triangles / 2 <= static_cast<double>(given.options().most_points);
}

void require_few_points(const GivenSolid& given) {
  if (!has_few_points(given, given.largest_edge())) {
    throw too_many(given.options().most_points);
  }
}

/// Tetrahedra are no longer than walls are thick: of a plate, twice its volume by its area.
void require_thick_walls(const GivenSolid& given, const Solid& solid) {
  const double thickness = 2 * solid.volume() / given.area();
  if (!has_few_points(given, thickness)) {
    throw Error(Errc::limit_exceeded,
                "the solid is about " + decimal(thickness, kMessageDigits) +
                    " thick, and filled with tetrahedra no longer than that it gets more than " +
                    std::to_string(given.options().most_points) +
                    " points; make it thicker, or mesh its surface alone");
  }
}

class Maker {
 public:
  explicit Maker(const GivenSolid& given) : given_(given), options_(given.options()) {}

  SolverMesh run() {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      made_ = refined(share_ * (options_.distance - given_.features().absorbed));
      tell(options_.progress, "improve");
      const MoveLimits limits = given_.move_limits();
      improve_angles(made_, given_.surface(), options_.smallest_angle, limits);
      improve_dihedral_angles(made_, given_.surface(), kDihedralAngle, options_.smallest_angle,
                              limits);
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
    const EdgeLengths lengths(given_.surface(), given_.features(), distance,
                              edge_share_ * given_.largest_edge() / 2);
    lengths.require_room(given_.most_points_on_curves(), EdgeLengths::Between::all);
    Refinement wanted;
    wanted.edge_length = [&](const Vec3& point) { return lengths.at(point); };
    wanted.radius = edge_share_ * given_.largest_edge() / 2;
    wanted.distance = distance;
    wanted.smallest_angle = options_.smallest_angle;
    wanted.fill = true;
    wanted.most_points = options_.most_points;
    wanted.seeds = seeds_of(given_.mesh(), given_.features(), given_.surface(), lengths);
    return refine(given_.mesh(), given_.features(), wanted, options_.progress);
  }

  /// Nothing if a distance or the solid cannot be proved. What is wrong is noted then, and less
  /// asked for.
  std::optional<SolverMesh> prove() {
    std::optional<SolverMesh> result = prove_solid();
    if (!result) {
      share_ /= 2;
    } else if (result->report.longest_edge > given_.largest_edge()) {
      // Beside curves the generator does not look at sizes.
      edge_share_ *= 0.95 * given_.largest_edge() / result->report.longest_edge;
      fault_ = given_.too_long();
      result.reset();
    }
    return result;
  }
  std::optional<SolverMesh> prove_solid() {
    if (made_.triangles.empty()) {
      fault_ = GivenSolid::no_mesh();
      return std::nullopt;
    }
    VolumeMesh mesh = volume_mesh_of({std::move(made_.points), std::move(made_.triangles), {}, {}},
                                     std::move(made_.tetrahedra));
    TriMesh& skin = mesh.surface;
    const mesh::ReferenceSurface back(skin.points, skin.triangles, made_.regions);
    const std::optional<double> there = largest(given_.surface(), skin, made_.regions);
    const std::optional<double> here =
        there ? largest(back, given_.mesh(), given_.features().regions) : std::nullopt;
    if (!here) {
      return std::nullopt;
    }
    given_.label(skin, made_.regions);
    SolverMesh result;
    try {
      result.surface = Solid::from(skin);
    } catch (const Error& error) {
      fault_ = std::string("the mesh is no solid: ") + error.what();
      return std::nullopt;
    }
    if (!given_.hangs_together_as(result.surface)) {
      fault_ = "the mesh does not hang together as the solid does; allow less distance";
      return std::nullopt;
    }
    result.report = given_.report_of(skin, made_.regions);
    result.report.deviation = std::max(*there, *here) + given_.slack();
    result.mesh = std::move(mesh);
    return result;
  }

  /// The largest distance from the triangles of a mesh to the same region of a surface, if it can
  /// be proved to be below the one allowed.
  [[nodiscard]] std::optional<double> largest(const mesh::ReferenceSurface& to, const TriMesh& from,
                                              const std::vector<std::uint32_t>& regions) {
    constexpr std::size_t kBlock = 64;
    std::vector<double> distances(from.triangles.size());
    support::for_each_block(
        distances.size(),
        [&](const support::Block& block) {
          for (std::size_t i = block.begin; i < block.end; ++i) {
            const auto& [a, b, c] = from.triangles[i];
            distances[i] = to.bound({from.points[a], from.points[b], from.points[c]}, regions[i],
                                    options_.distance - given_.slack())
                               .value_or(std::numeric_limits<double>::infinity());
          }
        },
        kBlock);
    const auto far = std::ranges::max_element(distances);
    if (*far <= options_.distance) {
      return *far;
    }
    const auto& [a, b, c] = from.triangles[static_cast<std::size_t>(far - distances.begin())];
    fault_ = given_.too_far({from.points[a], from.points[b], from.points[c]});
    return std::nullopt;
  }

  const GivenSolid& given_;
  const RemeshOptions& options_;
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
    throw Error(Errc::contact,
                "a solid that touches itself, as near " + decimal(solid.contacts().front().from) +
                    ", cannot be meshed for solvers; separate or bridge its contacts first");
  }
  const GivenSolid given(solid, options);
  require_distance_of_doubles(given);
  require_few_points(given);
  if (!fill) {
    return make_surface_mesh(given);
  }
  require_thick_walls(given, solid);
  return Maker(given).run();
}

}  // namespace dupin::meshing
