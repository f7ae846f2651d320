#include "booleans/union_in_steps.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "arrangement/arrange.h"
#include "boxes/main_directions.h"
#include "dupin/kernel/parallel.h"
#include "mesh/exact_mesh.h"

namespace dupin::booleans {
namespace {

using mesh::ExactMesh;
using Indices = std::span<std::uint32_t>;

// Of so many solids at a time, in general.
constexpr std::size_t kAtOnce = 3;

Eigen::AlignedBox3d box_of(const ExactMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : mesh.points) {
    box.extend(point);
  }
  return box;
}

// How so many are divided.
std::vector<std::array<std::size_t, 2>> parts_of(std::size_t operands, std::size_t at_once) {
  std::vector<std::array<std::size_t, 2>> parts;
  const std::size_t count = std::min(at_once, operands);
  for (std::size_t i = 0; i < count; ++i) {
    parts.push_back({operands * i / count, operands * (i + 1) / count});
  }
  return parts;
}

std::size_t step_count(std::size_t operands, std::size_t at_once) {
  std::size_t count = operands > 1 ? 1 : 0;
  if (count > 0) {
    for (const auto& [begin, end] : parts_of(operands, at_once)) {
      count += step_count(end - begin, at_once);
    }
  }
  return count;
}

// Of solids about axes in a plane, about one point: the angles of the axes. Empty if they are
// no such fan. No more is meant than how long the union takes.
std::vector<double> angles_of_fan(std::span<const Solid> solids) {
  constexpr double kFlat = 1e-6, kOpen = 0.1, kNarrow = 1.0 / 8;
  Eigen::AlignedBox3d centres;
  double least = HUGE_VAL;
  std::vector<Vec3> axes;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Solid& solid : solids) {
    const Eigen::AlignedBox3d box = box_of(solid.exact());
    if (box.isEmpty()) {
      return {};
    }
    centres.extend(box.center());
    least = std::min(least, box.diagonal().norm());
    axes.emplace_back(boxes::principal_axes(solid.exact().points).row(0));
    spread += axes.back() * axes.back().transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Vec3 values = solver.eigenvalues() / static_cast<double>(solids.size());
  if (!(values[0] <= kFlat && values[1] >= kOpen && centres.diagonal().norm() <= kNarrow * least)) {
    return {};
  }
  std::vector<double> angles;
  for (const Vec3& axis : axes) {
    const double angle =
        std::atan2(axis.dot(solver.eigenvectors().col(1)), axis.dot(solver.eigenvectors().col(2)));
    angles.push_back(angle < 0 ? angle + std::numbers::pi : angle);
  }
  return angles;
}

// Neighbours in a fan cross each other where few others do, so that more of them at a time cost
// little: few levels of steps, each of which costs much more where points are no longer those of
// the operands.
std::size_t at_once_in_fan(std::size_t solids) {
  constexpr double kMostPerLevel = 6;
  const auto count = static_cast<double>(solids);
  const double levels = std::max(2.0, std::round(std::log(count) / std::log(kMostPerLevel)));
  return std::max(kAtOnce, static_cast<std::size_t>(std::ceil(std::pow(count, 1 / levels))));
}

class Steps {
 public:
  Steps(std::span<const Solid> operands, const BooleanOptions& options)
      : operands_(operands),
        options_(options),
        angles_(angles_of_fan(operands)),
        at_once_(angles_.empty() ? kAtOnce : at_once_in_fan(operands.size())),
        steps_(step_count(operands.size(), at_once_)) {
    for (const Solid& operand : operands) {
      const Eigen::AlignedBox3d box = box_of(operand.exact());
      centres_.emplace_back(box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center()));
    }
  }

  ExactMesh run() {
    std::vector<std::uint32_t> all(operands_.size());
    std::iota(all.begin(), all.end(), 0u);
    ExactMesh result = united(all);
    order_names(result);
    return result;
  }

 private:
  ExactMesh united(Indices operands) {
    if (operands.size() == 1) {
      return with_sources(operands[0]);
    }
    sort_neighbours(operands);
    const std::vector<std::array<std::size_t, 2>> ranges = parts_of(operands.size(), at_once_);
    std::vector<ExactMesh> parts(ranges.size());
    for_each_in_parallel(ranges.size(), [&](std::size_t i) {
      const auto [begin, end] = ranges[i];
      parts[i] = united(operands.subspan(begin, end - begin));
    });
    return step(parts);
  }

  ExactMesh with_sources(std::uint32_t operand) const {
    ExactMesh mesh = operands_[operand].exact();
    for (std::uint32_t i = 0; i < mesh.sources.size(); ++i) {
      mesh.sources[i] = {operand, i};
    }
    return mesh;
  }

  // Around a fan, else along the longest extent. Equal ones stay in their order.
  void sort_neighbours(Indices operands) const {
    if (!angles_.empty()) {
      std::stable_sort(operands.begin(), operands.end(),
                       [&](std::uint32_t i, std::uint32_t j) { return angles_[i] < angles_[j]; });
      return;
    }
    Eigen::AlignedBox3d box;
    for (const std::uint32_t o : operands) {
      box.extend(centres_[o]);
    }
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    std::stable_sort(operands.begin(), operands.end(), [&](std::uint32_t i, std::uint32_t j) {
      return centres_[i][axis] < centres_[j][axis];
    });
  }

  ExactMesh step(const std::vector<ExactMesh>& parts) {
    std::vector<const ExactMesh*> meshes;
    for (const ExactMesh& part : parts) {
      meshes.push_back(&part);
    }
    ExactMesh result = arrangement::arrange_and_merge(
        meshes, arrangement::union_rule(meshes.size()), progress(), options_.memory_limit);
    for (Source& source : result.sources) {
      source = parts[source.operand].sources[source.triangle];
    }
    ++done_;
    return result;
  }

  // Behind what arrange_unless_crowded() has told. The caller hears of it on the thread it called
  // on; on others steps only learn whether to go on.
  [[nodiscard]] Progress progress() {
    if (!options_.progress) {
      return {};
    }
    return [this](std::string_view stage, double fraction) {
      if (std::this_thread::get_id() != thread_) {
        return !is_cancelled_;
      }
      const double part =
          (static_cast<double>(done_.load()) + fraction) / static_cast<double>(steps_);
      told_ = std::clamp(kBegin + (1 - kBegin) * part, told_, 1.0);  // lest rounding leads back
      is_cancelled_ = !options_.progress(stage, told_);
      return !is_cancelled_;
    };
  }

  // As if all had been united at once.
  void order_names(ExactMesh& result) const {
    std::vector<std::string> names;
    const auto number_of = [&names](const std::string& name) {
      const auto at = std::find(names.begin(), names.end(), name);
      const auto number = static_cast<std::uint32_t>(at - names.begin());
      if (at == names.end()) {
        names.push_back(name);
      }
      return number;
    };
    for (const Solid& operand : operands_) {
      std::for_each(operand.names().begin(), operand.names().end(), number_of);
    }
    std::vector<std::uint32_t> number;
    for (const std::string& name : result.names) {
      number.push_back(number_of(name));
    }
    for (std::uint32_t& label : result.labels) {
      label = number[label];
    }
    result.names = std::move(names);
  }

  std::span<const Solid> operands_;
  const BooleanOptions& options_;
  std::vector<Vec3> centres_;
  std::vector<double> angles_;  // empty if they are no fan
  std::size_t at_once_;
  static constexpr double kBegin = 0.4;
  std::size_t steps_;
  std::atomic<std::size_t> done_{0};
  std::thread::id thread_ = std::this_thread::get_id();
  double told_ = kBegin;
  std::atomic<bool> is_cancelled_{false};
};

}  // namespace

ExactMesh unite_in_steps(std::span<const Solid> operands, const BooleanOptions& options) {
  return Steps(operands, options).run();
}

}  // namespace dupin::booleans
