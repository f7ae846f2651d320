#include "meshing/given_solid.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "boxes/bounds.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/rounding.h"
#include "mesh/edge_table.h"

namespace dupin::meshing {
namespace {

/// More than the diagonal of the box says nothing else, and generators overflow with it.
RemeshOptions bounded(RemeshOptions options, const TriMesh& mesh) {
  const double diagonal = boxes::bounds_of(mesh.points).diagonal().norm();
  options.distance = std::min(options.distance, diagonal);
  options.largest_edge = std::min(options.largest_edge, diagonal);
  return options;
}

/// Per half-edge, whether the triangles beside it are of two regions.
std::vector<std::uint8_t> borders_of(const TriMesh& mesh,
                                     const std::vector<std::uint32_t>& regions) {
  const mesh::EdgeTable edges(mesh.triangles, mesh.points.size());
  std::vector<std::uint8_t> is_border(3 * mesh.triangles.size(), 0);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto& sides = edges[e].half_edges;
    if (regions[sides[0] / 3] != regions[sides[1] / 3]) {
      is_border[sides[0]] = is_border[sides[1]] = 1;
    }
  }
  return is_border;
}

}  // namespace

GivenSolid::GivenSolid(const Solid& solid, const RemeshOptions& options)
    : solid_(solid),
      mesh_(to_mesh(solid).mesh()),
      options_(bounded(options, mesh_)),
      diagonal_(boxes::bounds_of(mesh_.points).diagonal().norm()),
      largest_edge_(options_.largest_edge > 0 ? options_.largest_edge : diagonal_ / 10),
      features_(find_features(mesh_, options_.feature_angle, options_.distance, largest_edge_)),
      surface_(mesh_.points, mesh_.triangles, features_.regions),
      region_count_(1 + *std::ranges::max_element(features_.regions)) {
  const Eigen::AlignedBox3d box = boxes::bounds_of(mesh_.points);
  // Covers the rounding of a distance, and of cuts, tenfold.
  slack_ = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()) * 0x1p-46;
}

double GivenSolid::area() const {
  double area = 0;
  for (std::uint32_t f = 0; f < mesh_.triangles.size(); ++f) {
    const auto& [a, b, c] = surface_.corners(f);
    area += (b - a).cross(c - a).norm() / 2;
  }
  return area;
}

bool GivenSolid::hangs_together_as(const Solid& other) const {
  return other.euler_number() == solid_.euler_number() && other.shells() == solid_.shells();
}

void GivenSolid::label(TriMesh& mesh, const std::vector<std::uint32_t>& regions) const {
  if (mesh_.labels.empty()) {
    return;
  }
  // By region, that of the largest part: thin ones may have become part of it.
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> areas;
  for (std::uint32_t f = 0; f < mesh_.triangles.size(); ++f) {
    const auto& [a, b, c] = surface_.corners(f);
    areas[{features_.regions[f], mesh_.labels[f]}] += (b - a).cross(c - a).norm();
  }
  std::vector<std::uint32_t> labels(mesh_.triangles.size());
  std::vector<double> largest(mesh_.triangles.size(), -1);
  for (const auto& [key, area] : areas) {
    if (area > largest[key.first]) {
      largest[key.first] = area;
      labels[key.first] = key.second;
    }
  }
  for (const std::uint32_t region : regions) {
    mesh.labels.push_back(labels[region]);
  }
  mesh.names = mesh_.names;
}

RemeshReport GivenSolid::report_of(const TriMesh& mesh,
                                   const std::vector<std::uint32_t>& regions) const {
  constexpr std::size_t kTold = 10;
  RemeshReport report;
  report.smallest_angle = std::numbers::pi;
  report.shortest_edge = std::numeric_limits<double>::infinity();
  std::vector<PoorTriangle> poor;
  const std::vector<std::uint8_t> is_border = borders_of(mesh, regions);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    const Vec3 &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
    const double angle = smallest_angle(p, q, r);
    report.smallest_angle = std::min(report.smallest_angle, angle);
    const std::array<double, 3> lengths = {(q - p).norm(), (r - q).norm(), (p - r).norm()};
    if (angle < options_.smallest_angle) {
      // It is opposite to the shortest edge.
      const auto shortest =
          static_cast<std::size_t>(std::ranges::min_element(lengths) - lengths.begin());
      const bool is_between =
          is_border[3 * f + (shortest + 1) % 3] != 0 && is_border[3 * f + (shortest + 2) % 3] != 0;
      report.poor_between_edges += is_between ? 1 : 0;
      poor.push_back({(p + q + r) / 3, angle, is_between});
    }
    for (const double length : lengths) {
      report.shortest_edge = std::min(report.shortest_edge, length);
      report.longest_edge = std::max(report.longest_edge, length);
    }
  }
  report.poor_triangles = poor.size();
  std::ranges::stable_sort(poor, {}, [](const PoorTriangle& triangle) {
    return std::pair(triangle.is_between_edges, triangle.angle);
  });
  poor.resize(std::min(poor.size(), kTold));
  report.worst = std::move(poor);
  return report;
}

MoveLimits GivenSolid::move_limits() const {
  constexpr double kNear = 0.75;  // of the distance, at the places that are looked at
  return {largest_edge_, kNear * options_.distance};
}

std::size_t GivenSolid::most_points_on_curves() const {
  constexpr std::size_t kPointsPerBall = 10;
  return std::max<std::size_t>(options_.most_points / kPointsPerBall, 1);
}

std::string GivenSolid::too_far(const std::array<Vec3, 3>& triangle) const {
  const Vec3 place = (triangle[0] + triangle[1] + triangle[2]) / 3;
  return "the distance of " + decimal(options_.distance, kMessageDigits) + " cannot be kept near " +
         decimal(place) + "; allow more of it, or shorter edges";
}

std::string GivenSolid::too_long() const {
  return "edges cannot be kept as short as " + decimal(largest_edge_, kMessageDigits) +
         "; allow longer ones";
}

std::string GivenSolid::too_thin(const Vec3& place, double thickness) const {
  return "sides of the solid that are " + decimal(thickness, kMessageDigits) + " apart near " +
         decimal(place) + " cross each other in a mesh within " +
         decimal(options_.distance, kMessageDigits) +
         " of them; allow a distance below that, or make it thicker there";
}

std::string GivenSolid::no_mesh(const std::optional<Vec3>& place) {
  return "no mesh of the " + (place ? "surface at " + decimal(*place) : std::string("solid")) +
         " comes of these lengths; allow shorter edges or less distance";
}

}  // namespace dupin::meshing
