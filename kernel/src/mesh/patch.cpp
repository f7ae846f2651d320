#include "dupin/kernel/patch.h"

#include <algorithm>
#include <utility>

#include "dupin/kernel/error.h"

namespace dupin {
namespace {

// Many small triangles are added to few large ones.
struct Sums {
  long double area = 0;
  Eigen::Matrix<long double, 3, 1> moment = Eigen::Matrix<long double, 3, 1>::Zero();
  Eigen::Matrix<long double, 3, 1> vector_area = Eigen::Matrix<long double, 3, 1>::Zero();
  std::size_t triangles = 0;
};

[[noreturn]] void refuse(const std::string& message) {
  throw Error(Errc::invalid_argument, message);
}

}  // namespace

void require_indices(const TriMesh& mesh) {
  const bool is_labelled = !mesh.labels.empty();
  if (is_labelled && mesh.labels.size() != mesh.triangles.size()) {
    refuse("there are " + std::to_string(mesh.labels.size()) + " labels for " +
           std::to_string(mesh.triangles.size()) + " triangles; give one for each, or none");
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t corner = std::ranges::max(mesh.triangles[i]);
    if (corner >= mesh.points.size()) {
      refuse("face " + std::to_string(i) + " has the corner " + std::to_string(corner) +
             ", but there are " + std::to_string(mesh.points.size()) + " points");
    }
    if (is_labelled && mesh.labels[i] >= mesh.names.size()) {
      refuse("face " + std::to_string(i) + " has the label " + std::to_string(mesh.labels[i]) +
             ", but there are " + std::to_string(mesh.names.size()) + " names");
    }
  }
}

void validate(const TriMesh& mesh) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (!mesh.points[i].allFinite()) {
      refuse("point " + std::to_string(i) + " has a coordinate that is not finite");
    }
  }
  require_indices(mesh);
}

std::vector<Patch> patches_of(const TriMesh& mesh) {
  require_indices(mesh);
  const bool is_labelled = !mesh.labels.empty();
  std::vector<Sums> sums(is_labelled ? mesh.names.size() : 1);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Vec3 &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
    const Vec3 half_normal = (q - p).cross(r - p) / 2;
    const double area = half_normal.norm();
    Sums& own = sums[is_labelled ? mesh.labels[i] : 0];
    own.area += area;
    own.moment += (area * (p + ((q - p) + (r - p)) / 3)).cast<long double>();
    own.vector_area += half_normal.cast<long double>();
    ++own.triangles;
  }
  std::vector<Patch> result;
  result.reserve(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Sums& own = sums[i];
    if (own.triangles > 0) {
      const Vec3 centroid =
          own.area > 0 ? Vec3((own.moment / own.area).cast<double>()) : Vec3(Vec3::Zero());
      result.push_back({is_labelled ? mesh.names[i] : std::string(), own.triangles,
                        static_cast<double>(own.area), centroid, own.vector_area.cast<double>()});
    }
  }
  return result;
}

}  // namespace dupin
