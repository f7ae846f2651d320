#include "formats/split_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "dupin/kernel/error.h"

namespace dupin::formats {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

void require_fitting(const TriMesh& mesh, const CornerNormals& normals) {
  if (normals.size() != mesh.triangles.size()) {
    throw Error(Errc::invalid_argument, "there are normals of " + std::to_string(normals.size()) +
                                            " triangles, not of " +
                                            std::to_string(mesh.triangles.size()));
  }
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (const Direction& normal : normals[i]) {
      if (!std::ranges::all_of(normal, [](float x) { return std::isfinite(x); })) {
        throw Error(Errc::invalid_argument,
                    "a normal of triangle " + std::to_string(i) + " is not finite");
      }
    }
  }
}

class Splitter {
 public:
  explicit Splitter(std::size_t points)
      : next_(points, kNone), is_used_(points, false), points_(points) {
    result_.normals.assign(points, Direction{0, 0, 1});
  }

  void give(std::uint32_t point, const Direction& normal) {
    is_used_[point] = true;
    result_.normals[point] = normal;
  }

  // The point's vertices are few: a list from the point on.
  std::uint32_t vertex(std::uint32_t point, const Direction& normal) {
    if (!is_used_[point]) {
      is_used_[point] = true;
      result_.normals[point] = normal;
      return point;
    }
    std::uint32_t at = point;
    while (result_.normals[at] != normal) {
      if (next_[at] == kNone) {
        next_[at] = copy(point, normal);
        next_.push_back(kNone);
      }
      at = next_[at];
    }
    return at;
  }

  SplitPoints take(std::vector<Triangle> triangles) {
    result_.triangles = std::move(triangles);
    return std::move(result_);
  }

 private:
  std::uint32_t copy(std::uint32_t point, const Direction& normal) {
    result_.copied.push_back(point);
    result_.normals.push_back(normal);
    return std::uint32_t(points_ + result_.copied.size() - 1);
  }

  SplitPoints result_;
  std::vector<std::uint32_t> next_;  // by vertex
  std::vector<bool> is_used_;
  std::size_t points_;
};

}  // namespace

SplitPoints split_points(const TriMesh& mesh, const CornerNormals& normals,
                         const GivenNormals& given) {
  require_fitting(mesh, normals);
  Splitter splitter(mesh.points.size());
  for (const auto& [point, normal] : given) {
    splitter.give(point, normal);
  }
  std::vector<Triangle> triangles = mesh.triangles;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& corner = triangles[i].at(k);
      corner = splitter.vertex(corner, normals[i].at(k));
    }
  }
  return splitter.take(std::move(triangles));
}

bool merge_copies(const std::vector<std::uint32_t>& copied, TriMesh& mesh) {
  if (copied.empty() || copied.size() > mesh.points.size()) {
    return copied.empty();
  }
  const std::size_t points = mesh.points.size() - copied.size();
  for (std::size_t i = 0; i < copied.size(); ++i) {
    if (copied[i] >= points || mesh.points[points + i] != mesh.points[copied[i]]) {
      return false;
    }
  }
  for (Triangle& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) {
      corner = corner < points ? corner : copied[corner - points];
    }
  }
  mesh.points.resize(points);
  return true;
}

}  // namespace dupin::formats
