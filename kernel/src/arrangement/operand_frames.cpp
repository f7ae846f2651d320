#include "arrangement/operand_frames.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "boxes/main_directions.h"

namespace dupin::arrangement {
namespace {

// Principal axes need not be exact, nor seen from every point.
constexpr std::size_t kSamples = 512;

Axes principal_axes(const mesh::ExactMesh& mesh) {
  const std::size_t step = std::max<std::size_t>(1, mesh.points.size() / kSamples);
  Vec3 center = Vec3::Zero();
  double count = 0;
  for (std::size_t i = 0; i < mesh.points.size(); i += step) {
    center += mesh.points[i];
    count += 1;
  }
  center /= count;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < mesh.points.size(); i += step) {
    const Vec3 d = mesh.points[i] - center;
    spread += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Axes axes = boxes::orthonormal(solver.eigenvectors().col(2), solver.eigenvectors().col(1));
  return axes.allFinite() ? axes : Axes::Identity();
}

Bounds run_bounds(const mesh::ExactMesh& mesh, std::size_t begin, std::size_t end, const Axes& axes,
                  double slack) {
  Bounds box;
  for (std::size_t t = begin; t < end; ++t) {
    // Neighbours share corners and often follow one another.
    const Triangle& previous = mesh.triangles[t > begin ? t - 1 : t];
    for (const std::uint32_t corner : mesh.triangles[t]) {
      if (t == begin || std::find(previous.begin(), previous.end(), corner) == previous.end()) {
        box.extend(rotated(axes, mesh.points[corner]));
      }
    }
  }
  box.min().array() -= slack;
  box.max().array() += slack;
  return box;
}

}  // namespace

double rotation_slack(double extent) {
  // With u = 2^-52 (rounding upward): a coordinate is a sum of three products, off by less than
  // 3.1 u 3 extent, of a point off by u / 2 in each coordinate. Turning a box back assumes
  // orthogonal axes, which are so within 16 u, for coordinates up to sqrt(3) extent: less than
  // 2^-45 in all.
  return 0x1p-45 * extent;
}

FramedOperand framed(const mesh::ExactMesh& mesh, double slack) {
  FramedOperand result;
  if (mesh.points.empty()) {
    return result;
  }
  result.axes = principal_axes(mesh);
  const std::size_t count = mesh.triangles.size();
  result.runs.resize(support::block_count(count, FramedOperand::kRun));
  support::for_each_block(
      result.runs.size(),
      [&](const support::Block& block) {
        const UpwardRounding rounding;
        for (std::size_t i = block.begin; i < block.end; ++i) {
          const std::size_t begin = i * FramedOperand::kRun;
          const std::size_t end = std::min(begin + FramedOperand::kRun, count);
          result.runs[i] = run_bounds(mesh, begin, end, result.axes, slack);
        }
      },
      support::Block::kSize / FramedOperand::kRun);
  for (const Bounds& run : result.runs) {
    result.bounds.extend(run);
  }
  Eigen::Index longest = 0;
  result.bounds.sizes().maxCoeff(&longest);
  const auto exchange = [longest](Bounds& b) {
    std::swap(b.min()[0], b.min()[longest]);
    std::swap(b.max()[0], b.max()[longest]);
  };
  exchange(result.bounds);
  std::for_each(result.runs.begin(), result.runs.end(), exchange);
  result.axes.row(0).swap(result.axes.row(longest));
  return result;
}

Bounds bounds_in(const Axes& axes, const Axes& others, const Bounds& box, double slack) {
  const Eigen::Matrix3d turn = axes * others.transpose();
  const Vec3 center = turn * box.center();
  const Vec3 reach = turn.cwiseAbs() * (box.sizes() / 2) + Vec3::Constant(2 * slack);
  return Bounds(center - reach, center + reach);
}

Axes common_axes(const Axes& a, const Axes& b) {
  const Vec3 first = a.row(0), second = b.row(0);
  // Below this angle the second direction says little.
  constexpr double kNearlyParallel = 0.95;
  return std::abs(first.dot(second)) < kNearlyParallel ? boxes::orthonormal(first, second) : a;
}

}  // namespace dupin::arrangement
