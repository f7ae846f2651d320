#include "pages/packed_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "text/mesh_text.h"

namespace dupin::pages {
namespace {

// Steps to a box: as many as binary32 tells apart on both sides of its middle.
constexpr int kStepBits = 23;

void append_unsigned(std::string& bytes, std::uint64_t number) {
  for (; number >= 128; number >>= 7) {
    bytes += static_cast<char>(number % 128 + 128);
  }
  bytes += static_cast<char>(number);
}

void append_signed(std::string& bytes, std::int64_t number) {
  append_unsigned(bytes, number < 0 ? std::uint64_t(-2 * number - 1) : std::uint64_t(2 * number));
}

double step_for(double extent) {
  return extent > 0 ? std::ldexp(1, std::ilogb(extent) + 1 - kStepBits) : 1;
}

// The order in which triangles first come to points.
struct Numbering {
  explicit Numbering(std::size_t points)
      : number(points, std::numeric_limits<std::uint32_t>::max()) {}

  // How much less than the number of points so far.
  std::uint32_t back_to(std::uint32_t point) {
    const auto next = static_cast<std::uint32_t>(order.size());
    if (number[point] == std::numeric_limits<std::uint32_t>::max()) {
      number[point] = next;
      order.push_back(point);
      return 0;
    }
    return next - number[point];
  }

  std::vector<std::uint32_t> number, order;
};

}  // namespace

PackedMesh packed(const TriMesh& mesh) {
  PackedMesh result;
  Numbering numbering(mesh.points.size());
  std::string corners;
  std::uint32_t label = 0;
  for (const std::vector<std::uint32_t>& group : text::triangles_by_label(mesh)) {
    if (!group.empty()) {
      result.runs.emplace_back(label, static_cast<std::uint32_t>(group.size()));
    }
    for (const std::uint32_t face : group) {
      for (const std::uint32_t point : mesh.triangles[face]) {
        append_unsigned(corners, numbering.back_to(point));
      }
    }
    ++label;
  }
  result.triangles = mesh.triangles.size();
  result.points = numbering.order.size();
  Eigen::AlignedBox3d box;
  for (const std::uint32_t point : numbering.order) {
    box.extend(mesh.points[point]);
  }
  if (!box.isEmpty()) {
    result.step = step_for(box.sizes().maxCoeff());
    result.center = (box.center() / result.step).array().round() * result.step;
  }
  Eigen::Matrix<std::int64_t, 3, 1> last(0, 0, 0);
  for (const std::uint32_t point : numbering.order) {
    const Vec3 steps = (mesh.points[point] - result.center) / result.step;
    const Eigen::Matrix<std::int64_t, 3, 1> at = steps.array().round().cast<std::int64_t>();
    for (int k = 0; k < 3; ++k) {
      append_signed(result.bytes, at[k] - last[k]);
    }
    last = at;
  }
  result.bytes += corners;
  return result;
}

}  // namespace dupin::pages
