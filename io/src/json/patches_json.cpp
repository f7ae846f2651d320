#include "dupin/io/patches_json.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include "dupin/kernel/interior_point.h"
#include "dupin/kernel/parallel.h"
#include "dupin/kernel/patch.h"
#include "json/json_value.h"

namespace dupin {
namespace {

using json::Json;
using json::json_value;

// How far the numbers of a point may be from what they stand for: what rounding moved it by, or to
// a neighbouring number, before the origin was subtracted, too.
double uncertainty(const Vec3& point, const RoundingReport& rounding) {
  const auto spacing = [&](double value, double at_place) {
    const double written =
        rounding.coordinates == Coordinates::binary32
            ? double(std::nextafter(float(std::abs(value)), std::numeric_limits<float>::max())) -
                  std::abs(value)
            : std::nextafter(std::abs(value), std::numeric_limits<double>::max()) - std::abs(value);
    const double before = std::abs(at_place);
    return std::max(written, std::nextafter(before, std::numeric_limits<double>::max()) - before);
  };
  const Vec3 place = point + rounding.origin;
  const Vec3 own{spacing(point.x(), place.x()), spacing(point.y(), place.y()),
                 spacing(point.z(), place.z())};
  return std::max(own.norm(), rounding.largest_move);
}

struct RimEdge {
  std::uint32_t patch = 0, low = 0, high = 0;
  int turns = 0;
};

// Of each patch, in their order: a bound of what the uncertainty of the points and the arithmetic
// of the sum may add to the vector area, which depends on the patch's rim only.
std::vector<double> noise_of_vector_areas(const TriMesh& mesh, const RoundingReport& rounding) {
  constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;
  constexpr double kUnused = -1;
  std::vector<double> noise(std::max<std::size_t>(mesh.names.size(), 1), kUnused);
  std::vector<RimEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& corners = mesh.triangles[i];
    const std::uint32_t patch = mesh.labels.empty() ? 0 : mesh.labels[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = corners.at(k), to = corners.at((k + 1) % 3);
      edges.push_back({patch, std::min(from, to), std::max(from, to), from < to ? 1 : -1});
    }
    const Vec3& p = mesh.points[corners[0]];
    // Two roundings of each difference and product, and one of their difference.
    noise[patch] = std::max(noise[patch], 0.0) + 4 * kUnit * (mesh.points[corners[1]] - p).norm() *
                                                     (mesh.points[corners[2]] - p).norm();
  }
  const auto key = [](const RimEdge& edge) { return std::tie(edge.patch, edge.low, edge.high); };
  std::ranges::sort(edges, {}, key);
  for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
    int turns = 0;
    for (; next < edges.size() && key(edges[next]) == key(edges[i]); ++next) {
      turns += edges[next].turns;
    }
    if (turns != 0) {
      const Vec3 &p = mesh.points[edges[i].low], &q = mesh.points[edges[i].high];
      const double of_p = uncertainty(p, rounding), of_q = uncertainty(q, rounding);
      noise[edges[i].patch] += std::abs(turns) * ((q - p).norm() * (of_p + of_q) + of_p * of_q) / 2;
    }
  }
  std::erase(noise, kUnused);
  return noise;
}

Json patch_json(const Patch& patch, double noise) {
  const double length = patch.vector_area.norm();
  return {{"name", patch.name},
          {"triangles", patch.triangles},
          {"area", patch.area},
          {"centroid", json_value(patch.centroid)},
          {"vector_area", json_value(patch.vector_area)},
          {"normal", length > noise ? json_value(patch.vector_area / length) : Json(nullptr)}};
}

Json component_json(const std::optional<InteriorPoint>& point) {
  return {{"inside", point ? json_value(point->place) : Json(nullptr)},
          {"clearance", point ? Json(point->clearance) : Json(nullptr)}};
}

}  // namespace

std::string patches_json(const Rounded& solid, const std::string& file, const MeshHeader& header) {
  const UsualArithmetic usual;
  double area = 0;
  Json patches = Json::array(), components = Json::array();
  const TriMesh& mesh = solid.mesh();
  const std::vector<double> noise = noise_of_vector_areas(mesh, solid.report());
  for (const Patch& patch : patches_of(mesh)) {
    area += patch.area;
    patches.push_back(patch_json(patch, noise.at(patches.size())));
  }
  for (const auto& point : interior_points(solid)) {
    components.push_back(component_json(point));
  }
  return json::text({{"file", file},
                     {"unit", header.unit.empty() ? Json(nullptr) : Json(header.unit)},
                     {"origin", json_value(solid.report().origin)},
                     {"area", area},
                     {"patches", patches},
                     {"components", components}});
}

}  // namespace dupin
