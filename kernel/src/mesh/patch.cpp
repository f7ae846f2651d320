#include "dupin/kernel/patch.h"

#include <utility>

namespace dupin {
namespace {

// Many small triangles are added to few large ones.
struct Sums {
  long double area = 0;
  Eigen::Matrix<long double, 3, 1> moment = Eigen::Matrix<long double, 3, 1>::Zero();
  Eigen::Matrix<long double, 3, 1> vector_area = Eigen::Matrix<long double, 3, 1>::Zero();
  std::size_t triangles = 0;
};

}  // namespace

std::vector<Patch> patches_of(const TriMesh& mesh) {
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
